// SPDX-License-Identifier: MIT
// Converts files of probes of any size from one encoding to another, and blends two of them.
#ifndef GAUNT_TOOLS_GAUNT_VOLUME_CONVERT_H_
#define GAUNT_TOOLS_GAUNT_VOLUME_CONVERT_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "volume/probe_stream.h"

namespace gaunt::tool {

struct ProbeInput {
  std::string path;
  std::optional<ProbeEncoding> raw;  // of a raw file; without it, one of packed probes
  size_t stride = 0;                 // of a raw file; 0: without gaps
};

// What the second volume of a blend adds: (1 - weight) a + weight b of the coefficients.
struct ProbeBlend {
  ProbeInput with;
  float weight = 0.0f;
};

struct ProbeOutput {
  std::string path;
  std::optional<ProbeEncoding> encoding;  // by default floats of the input's order, in a raw file
  bool raw = false;
  size_t stride = 0;                  // of a raw file; 0: without gaps
  std::optional<ProbeFileGrid> grid;  // of a file of packed probes; by default the input's
  bool refined = false;               // by gaunt_probe_encode_refined()
};

struct ConvertJob {
  ProbeInput in;
  std::optional<ProbeBlend> blend;
  ProbeOutput out;
  uint64_t threads = 0;  // 0: one for each core
};

// What encoding lost, of E/pi, as gaunt_probe_encode() reports it, against all bands of the input, or
// of the blend: also those that the format lacks. Only of probes whose coefficients are all finite.
struct EncodingErrors {
  struct Worst {
    double error = 0.0;
    uint64_t probe = 0;
    void Add(double other_error, uint64_t other_probe);
  };

  uint64_t finite = 0;              // probes
  uint64_t not_finite = 0;          // probes
  uint64_t clamped = 0;             // coefficients
  double light = 0.0;               // sum of means of E/pi over the sphere and the channels
  double rms = 0.0, largest = 0.0;  // sums
  Worst worst_rms, worst_largest;

  void Add(const EncodingErrors& later);
};

struct ConvertSummary {
  uint64_t probes = 0;
  ProbeEncoding in, out;
  ProbeFileGrid grid;
  uint64_t threads = 0;
  uint64_t bytes_read = 0, bytes_written = 0;
  std::optional<EncodingErrors> errors;  // none if nothing was encoded
};

// Records that already have the output's format stay as they are, unless they are blended. Of orders
// that differ, bands are dropped or filled with 0. The output is written whole or not at all, and
// may be an input; it does not depend on the number of threads. Progress is called with the share of
// the probes that is done, which rises to 1. Throws BadInput, std::runtime_error.
ConvertSummary ConvertProbes(const ConvertJob& job, const std::function<void(double)>& progress);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_VOLUME_CONVERT_H_
