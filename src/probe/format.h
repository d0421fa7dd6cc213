// SPDX-License-Identifier: MIT
// Bit layout and bounds of the packed probe formats, shared by kernels, drivers and the C API.
#ifndef GAUNT_PROBE_FORMAT_H_
#define GAUNT_PROBE_FORMAT_H_

#include <cstddef>
#include <cstdint>

#include "basis/constants.h"

namespace gaunt::probe {

// SH3 in 28 bytes: RGB9E5 of the means, then 8 snorm8 ratios to the mean for each of R, G, B.
struct Sh3 {
  static constexpr size_t kBytes = 28;
  static constexpr size_t kOrder = 3;
  static constexpr size_t kChannels = 3;
  static constexpr size_t kRatios = 8;        // per channel
  static constexpr size_t kRatiosOffset = 4;  // bytes
  static constexpr double kQuantum = 127.0;

  // Largest |f_i| / f_0 of any non-negative light: max |y_i| / y_0.
  static constexpr double Bound(size_t i) {
    return i <= 3 ? ConstexprSqrt(3.0) : i == 6 ? ConstexprSqrt(5.0) : ConstexprSqrt(15.0) / 2.0;
  }
};

// Factors per ratio, for loops that must not call Bound() at run time.
struct Sh3Factors {
  float decode[Sh3::kRatios];  // ratio's integer to f_i / f_0
  float encode[Sh3::kRatios];  // f_i to its share of the bound
};
constexpr Sh3Factors MakeSh3Factors() {
  Sh3Factors factors = {};
  for (size_t i = 0; i < Sh3::kRatios; ++i) {
    factors.decode[i] = static_cast<float>(Sh3::Bound(i + 1) / Sh3::kQuantum);
    factors.encode[i] = static_cast<float>(1.0 / Sh3::Bound(i + 1));
  }
  return factors;
}
inline constexpr Sh3Factors kSh3Factors = MakeSh3Factors();

// RGB9E5, the shared-exponent format of graphics APIs: three 9-bit mantissas from bit 0 up and a
// 5-bit exponent e at bit 27; value = mantissa 2^(e - 24).
struct Rgb9e5 {
  static constexpr int kMantissaBits = 9;
  static constexpr int kExponentShift = 27;
  static constexpr int kExponentBias = 24;
  static constexpr double kSmallest = 0x1p-24;  // e = 0
  static constexpr double kLargest = 511.0 * 128.0;
};

}  // namespace gaunt::probe

#endif  // GAUNT_PROBE_FORMAT_H_
