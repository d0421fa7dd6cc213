// SPDX-License-Identifier: MIT
// Bit layouts and bounds of the packed probe formats, shared by kernels, drivers and the C API.
#ifndef GAUNT_PROBE_FORMAT_H_
#define GAUNT_PROBE_FORMAT_H_

#include <cstddef>
#include <cstdint>

#include "evaluate/constants.h"
#include "simd/order.h"

namespace gaunt::probe {

inline constexpr size_t kChannels = 3;

// Largest |f_i| / f_0 of any non-negative light: max |y_i| / y_0, of bands 0 to 2 and 4.
constexpr double Bound(size_t i) {
  switch (i) {
    case 0: return 1.0;
    case 1:
    case 2:
    case 3: return ConstexprSqrt(3.0);
    case 6: return ConstexprSqrt(5.0);
    case 4:
    case 5:
    case 7:
    case 8: return ConstexprSqrt(15.0) / 2.0;
    case 16:
    case 24: return 0.375 * ConstexprSqrt(35.0);
    // sin^3 cos is largest where cos^2 = 1/4.
    case 17:
    case 23: return 1.5 * ConstexprSqrt(17.5) * (3.0 / 16.0) * ConstexprSqrt(3.0);
    // sin^2 (7 cos^2 - 1) is largest where cos^2 = 4/7.
    case 18:
    case 22: return 0.75 * ConstexprSqrt(5.0) * (9.0 / 7.0);
    case 20: return 3.0;
    default: {
      // sin cos (7 cos^2 - 3) is largest where 28 cos^4 - 27 cos^2 + 3 = 0.
      const double u = (27.0 + ConstexprSqrt(393.0)) / 56.0;
      return 1.5 * ConstexprSqrt(2.5) * ConstexprSqrt(u * (1.0 - u)) * (7.0 * u - 3.0);
    }
  }
}

// RGB9E5, the shared-exponent format of graphics APIs: three 9-bit mantissas from bit 0 up and a
// 5-bit exponent e at bit 27; value = mantissa 2^(e - 24).
struct Rgb9e5 {
  static constexpr int kMantissaBits = 9;
  static constexpr int kExponentShift = 27;
  static constexpr int kExponentBias = 24;
  static constexpr double kSmallest = 0x1p-24;  // e = 0
  static constexpr double kLargest = 511.0 * 128.0;
};

// Floats of a 5-bit exponent of bias 15: with a sign and 10 bits of mantissa IEEE half floats,
// without a sign and with 6 or 5 bits the parts of R11G11B10F. The exponent 31, which stands for
// infinities and NaN, is never written, and read as if it were ordinary.
template <int kMantissa>
struct SmallFloat {
  static constexpr double kLargest = 65536.0 - 32768.0 / (1 << kMantissa);
};

// Where the means of R, G and B are, from a bit of the record on.
enum class Container { kRgb9e5, kHalf3, kR11g11b10 };

// How a ratio is written: as round(127 v) of 8 bits, as round(255 (v + 1) / 2) of 8 bits without a
// sign, or (v + 1) / 2 as a half float, for v in -1 .. 1.
enum class Code { kSnorm8, kUnorm8, kHalf };

// Bits of a record with an integer in two's complement that is never the least; none if the width is 0.
struct BitField {
  int bit, width;
  constexpr double Largest() const { return static_cast<double>((1 << (width - 1)) - 1); }
};

// Formats of means and of ratios to them: f_i = f_0 Range(i) v, where |Range(i)| is the largest ratio.
struct RatioFormat {
  static constexpr Container kContainer = Container::kRgb9e5;
  static constexpr int kContainerBit = 0;
  static constexpr double kMeanFactor = 1.0;  // f_0 of a mean of 1
  static constexpr bool Has(size_t) { return true; }
  static constexpr Code CodeOf(size_t, size_t) { return Code::kSnorm8; }
  static constexpr double Range(size_t i) { return Bound(i); }
  static constexpr size_t kAxials = 0;  // see ZH3, below
  static constexpr BitField Axial(size_t) { return {0, 0}; }
  static constexpr int kOpaqueBits[] = {-1};  // half floats that are 1 and not read
};

struct Sh2At13 : RatioFormat {
  static constexpr size_t kBytes = 13, kOrder = 2;
  static constexpr int BitOf(size_t c, size_t i) {
    return static_cast<int>(32 + 8 * (3 * c + i - 1));
  }
};
struct Sh3At28 : RatioFormat {
  static constexpr size_t kBytes = 28, kOrder = 3;
  static constexpr int BitOf(size_t c, size_t i) {
    return static_cast<int>(32 + 8 * (8 * c + i - 1));
  }
};
struct Sh3At32 : RatioFormat {
  static constexpr size_t kBytes = 32, kOrder = 3;
  static constexpr Container kContainer = Container::kHalf3;
  static constexpr int BitOf(size_t c, size_t i) {
    return static_cast<int>(64 + 8 * (8 * c + i - 1));
  }
};
// Band 3 is left out: E has none.
struct Sh5At55 : RatioFormat {
  static constexpr size_t kBytes = 55, kOrder = 5;
  static constexpr bool Has(size_t i) { return i < 9 || i >= 16; }
  static constexpr int BitOf(size_t c, size_t i) {
    return static_cast<int>(32 + 8 * (17 * c + (i < 9 ? i - 1 : i - 8)));
  }
};

// The volumetric lightmap of Unreal Engine 4 and 5: the layer of means, then six of four ratios each,
// as the texture formats FloatR11G11B10 and B8G8R8A8 have them.
struct UnrealAt28 : RatioFormat {
  static constexpr size_t kBytes = 28, kOrder = 3;
  static constexpr Container kContainer = Container::kR11g11b10;
  static constexpr Code CodeOf(size_t, size_t) { return Code::kUnorm8; }
  static constexpr int BitOf(size_t c, size_t i) {
    constexpr int kByte[4] = {2, 1, 0, 3};  // of red, green, blue, alpha
    return static_cast<int>(32 + 64 * c + 32 * ((i - 1) / 4)) + 8 * kByte[(i - 1) % 4];
  }
  static constexpr double Range(size_t i) {
    return i <= 3 ? ConstexprSqrt(3.0) : i == 6 ? 2.0 * ConstexprSqrt(5.0) : ConstexprSqrt(15.0);
  }
};

// The adaptive probe volumes of Unity keep E/pi as a polynomial of the normal: the mean L0, a vector
// of ratios v to it for 4 (v / 2) L0, and, of x y, y z, 3 z^2 - 1, x z and x^2 - y^2, ratios for
// 16 / sqrt(5) (v / 2) L0.
struct UnityPolynomial : RatioFormat {
  static constexpr Container kContainer = Container::kHalf3;
  static constexpr double kMeanFactor = 2.0 * ConstexprSqrt(kPi);
  static constexpr double Range(size_t i) {
    using Irradiance = evaluate::QuadraticConstants<evaluate::IrradianceBands>;
    constexpr double kLinear = 2.0 * Irradiance::kMean / Irradiance::kLinear;
    constexpr double kSquare = 8.0 / ConstexprSqrt(20.0) * Irradiance::kMean;
    switch (i) {
      case 1:
      case 3: return -kLinear;
      case 2: return kLinear;
      case 4: return kSquare / Irradiance::kProduct;
      case 5:
      case 7: return -kSquare / Irradiance::kProduct;
      case 6: return 3.0 * kSquare / Irradiance::kSquare;
      default: return kSquare / Irradiance::kDifference;
    }
  }

 protected:
  // Texture 0: L0 and x of red; textures 1 and 2: x, y, z of green and y of red, of blue and z of red.
  static constexpr int LinearBit(size_t c, size_t i) {
    const size_t axis = i == 3 ? 0 : i;  // of x, y, z
    if (c == 0) return axis == 0 ? 48 : axis == 1 ? 88 : 120;
    return static_cast<int>((c == 1 ? 64 : 96) + 8 * axis);
  }
};
struct UnityAt16 : UnityPolynomial {
  static constexpr size_t kBytes = 16, kOrder = 2;
  static constexpr Code CodeOf(size_t c, size_t i) {
    return c == 0 && i == 3 ? Code::kHalf : Code::kUnorm8;
  }
  static constexpr int BitOf(size_t c, size_t i) { return LinearBit(c, i); }
};
// Three more textures of x y, y z, z^2 and x z of red, green and blue, and one of x^2 - y^2.
struct UnityAt32 : UnityPolynomial {
  static constexpr size_t kBytes = 32, kOrder = 3;
  static constexpr Code CodeOf(size_t c, size_t i) {
    return c == 0 && i == 3 ? Code::kHalf : Code::kUnorm8;
  }
  static constexpr int BitOf(size_t c, size_t i) {
    if (i < 4) return LinearBit(c, i);
    if (i == 8) return static_cast<int>(224 + 8 * c);
    constexpr size_t kPlace[4] = {0, 1, 2, 3};  // of x y, y z, z^2, x z
    return static_cast<int>(128 + 32 * c + 8 * kPlace[i - 4]);
  }
};

// The directional lightmaps of Godot keep E/pi as l0 + 8 (t - 1/2) l0 . n: four texture layers of RGBA
// half floats, l0 and t for y, z and x. Alpha tells that there is light; the range is twice the bound.
struct GodotAt32 : RatioFormat {
  static constexpr size_t kBytes = 32, kOrder = 2;
  static constexpr Container kContainer = Container::kHalf3;
  static constexpr double kMeanFactor = 2.0 * ConstexprSqrt(kPi);
  static constexpr Code CodeOf(size_t, size_t) { return Code::kHalf; }
  static constexpr int BitOf(size_t c, size_t i) { return static_cast<int>(64 * i + 16 * c); }
  static constexpr double Range(size_t i) {
    return (i == 2 ? 2.0 : -2.0) * UnityPolynomial::Range(2);
  }
  static constexpr int kOpaqueBits[] = {48, 112, 176, 240};
};

// Formats of ratios v that the channels share and of what is left over along two axes of colour,
// orange and green:
//   f_ci = Bound(i) (f_c0 v_i + m e_ci),  e = (o - g, g, -o - g),  m = Luma(f_00, f_10, f_20),
// with v = q / Largest() and o, g = ColourRange(i) q |q| / Largest()^2. Squares are fine near 0, where
// most colours are, and reach far.
struct SharedFormat {
  static constexpr Container kContainer = Container::kRgb9e5;
  static constexpr int kContainerBit = 0;
  static constexpr bool kHasColour = false;
  static constexpr size_t kAxials = 0;
  static constexpr BitField Axial(size_t) { return {0, 0}; }
  static constexpr bool Has(size_t) { return true; }
  static constexpr double Range(size_t i) { return Bound(i); }
  static constexpr BitField Orange(size_t) { return {0, 0}; }
  static constexpr BitField Green(size_t) { return {0, 0}; }
  static constexpr double ColourRange(size_t i) { return i < 4 ? 0.35 : 0.25; }
};
struct LumaAt12 : SharedFormat {
  static constexpr size_t kBytes = 12, kOrder = 3;
  static constexpr BitField Ratio(size_t i) { return {static_cast<int>(24 + 8 * i), 8}; }
};
struct ChromaAt16 : SharedFormat {
  static constexpr size_t kBytes = 16, kOrder = 3;
  static constexpr bool kHasColour = true;
  static constexpr BitField Ratio(size_t i) {
    constexpr int kBits[] = {32, 64, 96, 49, 58, 81, 90, 113};
    return {kBits[i - 1], i < 4 ? 7 : 6};
  }
  static constexpr BitField Orange(size_t i) {
    constexpr int kBits[] = {39, 71, 103, 55, 119, 87, 122, 125};
    return {kBits[i - 1], i < 4 ? 5 : 3};
  }
  static constexpr BitField Green(size_t i) {
    return {static_cast<int>(12 + 32 * i), i < 4 ? 5 : 0};
  }
};
struct ChromaAt21 : SharedFormat {
  static constexpr size_t kBytes = 21, kOrder = 3;
  static constexpr bool kHasColour = true;
  static constexpr BitField Ratio(size_t i) {
    constexpr int kBits[] = {32, 40, 48, 56, 64, 71, 96, 103};
    return {kBits[i - 1], i < 4 ? 8 : 7};
  }
  static constexpr BitField Orange(size_t i) {
    constexpr int kBits[] = {78, 90, 116, 128, 136, 144, 152, 160};
    return {kBits[i - 1], i < 4 ? 6 : 4};
  }
  static constexpr BitField Green(size_t i) {
    constexpr int kBits[] = {84, 110, 122, 132, 140, 148, 156, 164};
    return {kBits[i - 1], i < 4 ? 6 : 4};
  }
};

// ZH3: order 2, and of band 2 the part that is symmetric about the luminance axis of band 1, as a
// ratio of each channel or of all, f_c2 = f_c0 kAxialRange v times the zonal function of norm 1.
inline constexpr double kAxialRange = ConstexprSqrt(5.0);
struct Zh3At16 : RatioFormat {
  static constexpr size_t kBytes = 16, kOrder = 3;
  static constexpr bool Has(size_t i) { return i < 4; }
  static constexpr int BitOf(size_t c, size_t i) { return Sh2At13::BitOf(c, i); }
  static constexpr bool kSharesRatios = false;
  static constexpr size_t kAxials = kChannels;
  static constexpr BitField Axial(size_t c) { return {static_cast<int>(104 + 8 * c), 8}; }
};
struct Zh3LumaAt8 : SharedFormat {
  static constexpr size_t kBytes = 8, kOrder = 3;
  static constexpr bool Has(size_t i) { return i < 4; }
  static constexpr BitField Ratio(size_t i) { return LumaAt12::Ratio(i); }
  static constexpr bool kSharesRatios = true;
  static constexpr size_t kAxials = 1;
  static constexpr BitField Axial(size_t) { return {56, 8}; }
};

// Formats of every coefficient as a float, channel by channel; no other number is closer.
struct HalfAt54 {
  static constexpr size_t kBytes = 54, kOrder = 3;
  static constexpr int kBits = 16;
};
struct FloatAt108 {
  static constexpr size_t kBytes = 108, kOrder = 3;
  static constexpr int kBits = 32;
};

// Means alone: the texture formats.
struct Rgb9e5At4 : RatioFormat {
  static constexpr size_t kBytes = 4, kOrder = 1;
  static constexpr int BitOf(size_t, size_t) { return 0; }
};
struct R11g11b10At4 : Rgb9e5At4 {
  static constexpr Container kContainer = Container::kR11g11b10;
};

template <class F>
inline constexpr size_t kPlanes = kChannels* F::kOrder* F::kOrder;

// In the order of GAUNT_FORMAT_*, from 1 on.
template <class... F>
struct FormatList {
  static constexpr size_t kCount = sizeof...(F);
};
using Formats = FormatList<Sh3At28, Sh2At13, Sh3At32, Sh5At55, HalfAt54, FloatAt108, UnrealAt28,
                           UnityAt16, UnityAt32, Rgb9e5At4, R11g11b10At4, LumaAt12, ChromaAt16,
                           ChromaAt21, Zh3At16, Zh3LumaAt8, GodotAt32>;
inline constexpr size_t kNumFormats = Formats::kCount;

struct FormatShape {
  size_t bytes, order, planes;
};
template <class... F>
constexpr FormatShape ShapeOf(FormatList<F...>, size_t format) {
  constexpr FormatShape kShapes[] = {{F::kBytes, F::kOrder, kPlanes<F>}...};
  return kShapes[format];
}

}  // namespace gaunt::probe

#endif  // GAUNT_PROBE_FORMAT_H_
