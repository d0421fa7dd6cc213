// SPDX-License-Identifier: MIT
// The packed probe formats by their definition, in double precision.
#ifndef GAUNT_PROBE_PROBE_REFERENCE_H_
#define GAUNT_PROBE_PROBE_REFERENCE_H_

#include <cstddef>
#include <cstdint>

namespace gaunt::probe {

// 28 bytes to RGB radiance of order 3, channel-major.
void DecodeReference(const uint8_t* record, double out[27]);
void EncodeReference(const double in[27], uint8_t* record);

// Weighted sum of decoded records; an index that is not below packed_count adds nothing.
void GatherReference(size_t taps, const uint32_t* indices, const float* weights,
                     const uint8_t* packed, size_t packed_count, size_t stride, double out[27]);

// RMS error of E/pi over the sphere and the channels, and the bound on its largest error.
void ErrorReference(const double wanted[27], const double decoded[27], double* rms, double* bound);

}  // namespace gaunt::probe

#endif  // GAUNT_PROBE_PROBE_REFERENCE_H_
