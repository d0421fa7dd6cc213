// SPDX-License-Identifier: MIT
// Kernels that turn functions so that an axis of each item becomes z, and back. What is symmetric
// about z does not care about a last turn about it, so two angles are enough.
#if defined(GAUNT_PRODUCT_AXIS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PRODUCT_AXIS_INL_H_
#undef GAUNT_PRODUCT_AXIS_INL_H_
#else
#define GAUNT_PRODUCT_AXIS_INL_H_
#endif

#include <utility>

#include "rotate/bands-inl.h"
#include "rotate/each_band-inl.h"
#include "simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::product::axial::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

using rotate::HWY_NAMESPACE::BandSteps;
using rotate::HWY_NAMESPACE::CosineSlot;
using rotate::HWY_NAMESPACE::kAnyOrder;
using rotate::HWY_NAMESPACE::SineSlot;

// The axis is Rz(azimuth) Rx(tilt) z, with Rx as in rotate/bands-inl.h.
enum AxisTurn { kTilt, kAzimuth, kAxisTurns };
inline constexpr int kAxisSlots = static_cast<int>(CosineSlot(kAxisTurns, 1));

// Planes of cos and sin of the two angles.
enum AxisAnglePlane { kTiltCosine, kTiltSine, kAzimuthCosine, kAzimuthSine, kAxisAnglePlanes };

struct AnglesOfAxis {
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& axis, const Out& angles) const {
    using V = typename K::V;
    const V x = axis(0), y = axis(1);
    const V squared = MulAdd(x, x, Mul(y, y));
    // At a pole the azimuth is 0.
    const auto pole = Lt(squared, k(kPoleSquared));
    const V sine = Sqrt(squared);
    const V scale = Div(k(1.0), sine);
    const V c = IfThenElse(pole, k(1.0), Mul(Neg(y), scale));
    const V s = IfThenZeroElse(pole, Mul(x, scale));
    rotate::HWY_NAMESPACE::PutAngle(k, kTiltCosine, axis(2), IfThenZeroElse(pole, sine), angles);
    rotate::HWY_NAMESPACE::PutAngle(k, kAzimuthCosine, c, s, angles);
  }

 private:
  // Below it, the sine of the tilt is 1e-15 or less.
  static constexpr double kPoleSquared = 1e-30;
};

// Slots of cos and sin of multiples of both angles, or of their opposites, for m < order; n is the
// order or kAnyOrder.
template <int n, bool kOpposite>
struct SetAxisTurns {
  int order;

  template <class InA, class Slots>
  GAUNT_LANES void operator()(const InA& angles, Slots& turns) const {
    const auto tilt = angles(kTiltSine), azimuth = angles(kAzimuthSine);
    turns(CosineSlot(kTilt, 1), angles(kTiltCosine));
    turns(SineSlot(kTilt, 1), kOpposite ? Neg(tilt) : tilt);
    turns(CosineSlot(kAzimuth, 1), angles(kAzimuthCosine));
    turns(SineSlot(kAzimuth, 1), kOpposite ? Neg(azimuth) : azimuth);
    if constexpr (n != kAnyOrder) {
      Unrolled(turns, std::make_integer_sequence<int, (n > 2 ? n - 2 : 0)>());
    } else {
      for (int m = 2; m < order; ++m) SetPowers(m, turns);
    }
  }

 private:
  template <class Slots, int... m>
  static GAUNT_LANES void Unrolled(Slots& turns, std::integer_sequence<int, m...>) {
    (SetPowers(m + 2, turns), ...);
  }
  template <class Slots>
  static GAUNT_LANES void SetPowers(int m, Slots& turns) {
    rotate::HWY_NAMESPACE::SetPower(kTilt, m, turns);
    rotate::HWY_NAMESPACE::SetPower(kAzimuth, m, turns);
  }
};

// Band l of one channel, so that the axis becomes z, by opposite angles.
template <int l>
struct BandToZ {
  template <class K, class Slots, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const Slots& turns, const In& in, const Out& out) const {
    if constexpr (l == 0) return out(0, in(0));
    using Steps = BandSteps<l>;
    typename K::template Slots<2 * l + 1> turned, swapped;
    Steps::template TurnAboutZ<kAzimuth, kAzimuth>(turns, in, turned);
    Steps::Swap(k, turned, swapped);
    Steps::template TurnAboutZ<kTilt, kTilt>(turns, swapped, turned);
    Steps::Swap(k, turned, out);
  }
};

// So that z becomes the axis. Outputs may be in place.
template <int l>
struct BandFromZ {
  template <class K, class Slots, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const Slots& turns, const In& in, const Out& out) const {
    if constexpr (l == 0) return out(0, in(0));
    using Steps = BandSteps<l>;
    typename K::template Slots<2 * l + 1> turned, swapped;
    Steps::Swap(k, in, swapped);
    Steps::template TurnAboutZ<kTilt, kTilt>(turns, swapped, turned);
    Steps::Swap(k, turned, swapped);
    Steps::template TurnAboutZ<kAzimuth, kAzimuth>(turns, swapped, out);
  }
};

// All bands of each channel; n is the order or kAnyOrder, for orders up to kBands.
template <int n, bool kToZ, int kBands>
struct TurnAxis {
  int order;
  size_t channels;

  template <class K, class InA, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const InA& angles, const In& in, const Out& out) const {
    typename K::template Slots<kAxisSlots> turns;
    SetAxisTurns<n, kToZ>{order}(angles, turns);
    if constexpr (kToZ) {
      rotate::HWY_NAMESPACE::ForEachBand<n, BandToZ, kBands>(k, order, channels, turns, in, out);
    } else {
      rotate::HWY_NAMESPACE::ForEachBand<n, BandFromZ, kBands>(k, order, channels, turns, in, out);
    }
  }
};

}  // namespace gaunt::product::axial::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PRODUCT_AXIS_INL_H_
