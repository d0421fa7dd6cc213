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

// Planes of a group of lanes in memory: reading, and writing. From(p) begins at plane p, so that a
// loop over channels multiplies by the stride once per channel.
struct PlanesIn {
  const unsigned char* data;
  ptrdiff_t stride;
  GAUNT_LANES PlanesIn From(size_t p) const {
    return {data + static_cast<ptrdiff_t>(p) * stride, stride};
  }
  GAUNT_LANES hn::Vec<LaneTag> operator()(size_t p) const {
    return hn::LoadU(LaneTag(),
                     reinterpret_cast<const float*>(data + static_cast<ptrdiff_t>(p) * stride));
  }
};

// Planes of one item, for every lane.
struct SplatIn {
  const unsigned char* data;
  ptrdiff_t stride;
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
    hn::StoreU(v, LaneTag(), reinterpret_cast<float*>(data + static_cast<ptrdiff_t>(p) * stride));
  }
};

// What a kernel gets as `k`: constants, and slots in memory between its stages.
struct Lanes {
  using V = hn::Vec<LaneTag>;

  GAUNT_LANES V operator()(double c) const { return hn::Set(LaneTag(), static_cast<float>(c)); }

  template <int kCount>
  struct Slots {
    HWY_ALIGN float data[kCount * kMaxLanes];
    GAUNT_LANES V operator()(size_t p) const { return hn::Load(LaneTag(), data + p * kMaxLanes); }
    GAUNT_LANES void operator()(size_t p, V v) { hn::Store(v, LaneTag(), data + p * kMaxLanes); }
  };
};

}  // namespace gaunt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_SIMD_LANES_INL_H_
