// SPDX-License-Identifier: MIT
// Packed probes of one format, or the blend of two volumes of them, as those of another.
#ifndef GAUNT_PROBE_TRANSCODE_H_
#define GAUNT_PROBE_TRANSCODE_H_

#include "probe/probe.h"

namespace gaunt::probe {

// A format's kernels and shape.
struct FormatUse {
  const FormatTable& kernels;
  FormatShape shape;
};

// a + t (b - a), or a where `b` is null; bands above either order are 0.
void Transcode(const FormatUse& from, const FormatUse& to, size_t count, const PackedProbes& a,
               const PackedProbes* b, float t, uint8_t* packed, size_t stride);

}  // namespace gaunt::probe

#endif  // GAUNT_PROBE_TRANSCODE_H_
