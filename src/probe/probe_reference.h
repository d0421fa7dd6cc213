// SPDX-License-Identifier: MIT
// The packed probe formats by their definition, in double precision.
#ifndef GAUNT_PROBE_PROBE_REFERENCE_H_
#define GAUNT_PROBE_PROBE_REFERENCE_H_

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gaunt::probe {

// A coefficient as a record has it: from `least` to `most` in steps, where the means are as they are.
struct Coefficient {
  double value, step, least, most;
};

// All of a record, channel by channel. In band 2 of ZH3, `most` is over s of gaunt_zh3_solve().
std::vector<Coefficient> ReadReference(uint32_t format, const uint8_t* record);

// A number of a record of shared ratios or of ZH3 and what it stands for, in steps: a number q stands
// for q or, squared, for q |q|. `wanted` is what the encoded light has, given the means and the numbers
// before.
struct Written {
  int number, largest;
  bool squared;
  double wanted;
};
// All of them; none for other formats.
std::vector<Written> WrittenReference(uint32_t format, const float* light, const uint8_t* record);

// Weighted sum of decoded records; an index that is not below packed_count adds nothing.
std::vector<double> GatherReference(uint32_t format, size_t taps, const uint32_t* indices,
                                    const float* weights, const uint8_t* packed,
                                    size_t packed_count, size_t stride);

// RMS error of E/pi over the sphere and the channels, and the bound on its largest error.
void ErrorReference(int order, const double* wanted, const double* decoded, double* rms,
                    double* bound);

}  // namespace gaunt::probe

#endif  // GAUNT_PROBE_PROBE_REFERENCE_H_
