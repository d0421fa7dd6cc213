// SPDX-License-Identifier: MIT
// Lane arithmetic of kernels, for the Highway target that is being compiled. Kernels call these
// free functions and nothing else; src/simd/count.h has the twin that counts operations.
#if defined(GAUNT_SIMD_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_SIMD_LANES_INL_H_
#undef GAUNT_SIMD_LANES_INL_H_
#else
#define GAUNT_SIMD_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

// Kernels are inlined into code of their own target, whose attributes come from the enclosing
// HWY_BEFORE_NAMESPACE. Counting them is ordinary code, into which they could not be inlined.
#undef GAUNT_LANES
#ifdef GAUNT_COUNTING
#define GAUNT_LANES inline
#else
#define GAUNT_LANES HWY_INLINE
#endif

HWY_BEFORE_NAMESPACE();
namespace gaunt::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Builtin vector types have no associated namespace, so lookup needs these declarations.
using hn::Abs;
using hn::Add;
using hn::And;
using hn::Div;
using hn::Gt;
using hn::IfThenElse;
using hn::IfThenElseZero;
using hn::IfThenZeroElse;
using hn::Lt;
using hn::Max;
using hn::Min;
using hn::Mul;
using hn::MulAdd;
using hn::MulSub;
using hn::Neg;
using hn::NegMulAdd;
using hn::Sqrt;
using hn::Sub;

// No vector is wider than this many lanes, so stack tiles have a fixed size on every target.
inline constexpr size_t kMaxLanes = 16;
using LaneTag = hn::CappedTag<float, kMaxLanes>;

// 2 / v of normal powers of two, without a division: the exponent bits of the two add up to a
// constant.
GAUNT_LANES hn::Vec<LaneTag> TwiceReciprocalOfPower(hn::Vec<LaneTag> v) {
  const LaneTag d;
  const hn::RebindToSigned<LaneTag> bits;
  return hn::BitCast(d, hn::Sub(hn::Set(bits, 0x7F800000), hn::BitCast(bits, v)));
}

// Planes of a group of lanes in memory: reading, and writing. From(p) begins at plane p, so that a
// loop over channels multiplies by the stride once per channel.
struct PlanesIn {
  const unsigned char* data;
  ptrdiff_t stride;
  GAUNT_LANES PlanesIn From(size_t p) const {
    return {data + static_cast<ptrdiff_t>(p) * stride, stride};
  }
  GAUNT_LANES hn::Vec<LaneTag> operator()(size_t p) const {
    return At(static_cast<ptrdiff_t>(p) * stride);
  }
  // For planes that are known at run time: the offset once, and often At it.
  GAUNT_LANES ptrdiff_t Offset(ptrdiff_t p) const { return p * stride; }
  GAUNT_LANES hn::Vec<LaneTag> At(ptrdiff_t offset) const {
    return hn::LoadU(LaneTag(), reinterpret_cast<const float*>(data + offset));
  }
};

// Planes of one item, for every lane.
struct SplatIn {
  const unsigned char* data;
  ptrdiff_t stride;
  GAUNT_LANES SplatIn From(size_t p) const {
    return {data + static_cast<ptrdiff_t>(p) * stride, stride};
  }
  GAUNT_LANES hn::Vec<LaneTag> operator()(size_t p) const {
    float value;
    std::memcpy(&value, data + static_cast<ptrdiff_t>(p) * stride, sizeof(value));
    return hn::Set(LaneTag(), value);
  }
};

struct PlanesOut {
  unsigned char* data;
  ptrdiff_t stride;
  GAUNT_LANES PlanesOut From(size_t p) const {
    return {data + static_cast<ptrdiff_t>(p) * stride, stride};
  }
  GAUNT_LANES void operator()(size_t p, hn::Vec<LaneTag> v) const {
    At(static_cast<ptrdiff_t>(p) * stride, v);
  }
  GAUNT_LANES PlanesIn Read() const { return {data, stride}; }
  GAUNT_LANES ptrdiff_t Offset(ptrdiff_t p) const { return p * stride; }
  GAUNT_LANES void At(ptrdiff_t offset, hn::Vec<LaneTag> v) const {
    hn::StoreU(v, LaneTag(), reinterpret_cast<float*>(data + offset));
  }
};

// What a kernel gets as `k`: constants, and slots in memory between its stages.
struct Lanes {
  using V = hn::Vec<LaneTag>;

  GAUNT_LANES V operator()(double c) const { return hn::Set(LaneTag(), static_cast<float>(c)); }
  // Constants in memory of any alignment.
  GAUNT_LANES SplatIn Floats(const void* data) const {
    return {static_cast<const unsigned char*>(data), sizeof(float)};
  }

  // As close together as the widest vector of the target permits: the first cache should hold them.
  template <int kCount>
  struct Slots {
    static constexpr size_t kStride = hn::MaxLanes(LaneTag());
    HWY_ALIGN float data[kCount * kStride];
    GAUNT_LANES V operator()(size_t p) const { return hn::Load(LaneTag(), data + p * kStride); }
    GAUNT_LANES void operator()(size_t p, V v) { hn::Store(v, LaneTag(), data + p * kStride); }
    // The slots as planes, to be read.
    GAUNT_LANES PlanesIn Planes() const {
      return {reinterpret_cast<const unsigned char*>(data), kStride * sizeof(float)};
    }
  };

  // out(p) = the sum over n terms, at least one, of factor in(source), and of `constant`, in double
  // precision: it rounds once, to float. Half of the lanes at a time, and both at once, fill the
  // vectors.
  GAUNT_LANES void WideSum(const PlanesIn& in, const uint8_t* source, const double* factor, int n,
                           double constant, const PlanesOut& out, size_t p) const;
};

#if HWY_HAVE_FLOAT64

using HalfTag = hn::Half<LaneTag>;
using WideTag = hn::Rebind<double, HalfTag>;

GAUNT_LANES hn::Vec<WideTag> LoadWide(const float* from) {
  return hn::PromoteTo(WideTag(), hn::LoadU(HalfTag(), from));
}

GAUNT_LANES void Lanes::WideSum(const PlanesIn& in, const uint8_t* source, const double* factor,
                                int n, double constant, const PlanesOut& out, size_t p) const {
  const WideTag d;
  // Without a second half where a vector is one lane.
  const size_t half = hn::Lanes(LaneTag()) - hn::Lanes(HalfTag());
  const auto plane = [&](int t) HWY_ATTR {
    return reinterpret_cast<const float*>(in.data + source[t] * in.stride);
  };
  auto lower = hn::Mul(hn::Set(d, factor[0]), LoadWide(plane(0)));
  auto upper = hn::Mul(hn::Set(d, factor[0]), LoadWide(plane(0) + half));
  for (int t = 1; t < n; ++t) {
    const auto times = hn::Set(d, factor[t]);
    lower = hn::MulAdd(times, LoadWide(plane(t)), lower);
    upper = hn::MulAdd(times, LoadWide(plane(t) + half), upper);
  }
  if (constant != 0.0) {
    lower = hn::Add(lower, hn::Set(d, constant));
    upper = hn::Add(upper, hn::Set(d, constant));
  }
  float* to = reinterpret_cast<float*>(out.data + static_cast<ptrdiff_t>(p) * out.stride);
  hn::StoreU(hn::DemoteTo(HalfTag(), lower), HalfTag(), to);
  hn::StoreU(hn::DemoteTo(HalfTag(), upper), HalfTag(), to + half);
}

#else

GAUNT_LANES void Lanes::WideSum(const PlanesIn& in, const uint8_t* source, const double* factor,
                                int n, double constant, const PlanesOut& out, size_t p) const {
  HWY_ALIGN float result[kMaxLanes];
  for (size_t lane = 0; lane < hn::Lanes(LaneTag()); ++lane) {
    double sum = 0.0;
    for (int t = 0; t < n; ++t) {
      const double value = reinterpret_cast<const float*>(in.data + source[t] * in.stride)[lane];
      sum = t == 0 ? factor[t] * value : sum + factor[t] * value;
    }
    result[lane] = static_cast<float>(constant != 0.0 ? sum + constant : sum);
  }
  out(p, hn::Load(LaneTag(), result));
}

#endif

}  // namespace gaunt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_SIMD_LANES_INL_H_
