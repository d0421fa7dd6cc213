// SPDX-License-Identifier: MIT
// The kernel of the frame job after its gather: the kernels of the steps, one after the other, on one
// group of lanes.
#if defined(GAUNT_FRAME_FRAME_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_FRAME_FRAME_INL_H_
#undef GAUNT_FRAME_FRAME_INL_H_
#else
#define GAUNT_FRAME_FRAME_INL_H_
#endif

#include "evaluate/evaluate-inl.h"
#include "frame/frame.h"
#include "light/light-inl.h"
#include "rotate/tensor-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::frame::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Slots as planes to read and to write.
template <class Slots>
struct SlotPlanes {
  Slots& slots;
  size_t first;

  GAUNT_LANES SlotPlanes From(size_t p) const { return {slots, first + p}; }
  GAUNT_LANES auto operator()(size_t p) const { return slots(first + p); }
  template <class V>
  GAUNT_LANES void operator()(size_t p, V v) const {
    slots(first + p, v);
  }
};

// What is written goes to both.
template <class A, class B>
struct Both {
  const A& a;
  const B& b;

  template <class V>
  GAUNT_LANES void operator()(size_t p, V v) const {
    a(p, v);
    b(p, v);
  }
};

inline constexpr size_t kLightPlanes = 9;  // direction, colour, ambient

// The steps that are wanted; the accessors of others are not used.
struct Light {
  bool lerps, rotates, finds_direction, extracts, packs, keeps_radiance;
  float weights[probe::kChannels];  // of the direction

  template <class K, class Now, class Before, class Alpha, class Quaternion, class History,
            class Radiance, class Lights, class Packed>
  GAUNT_LANES void operator()(const K& k, const Now& now, const Before& before, const Alpha& alpha,
                              const Quaternion& quaternion, const History& history,
                              const Radiance& radiance, const Lights& lights,
                              const Packed& constants) const {
    using Slots = typename K::template Slots<kPlanes>;
    Slots slots;
    const SlotPlanes<Slots> f = {slots, 0};
    if (lerps) {
      const Both<History, SlotPlanes<Slots>> both = {history, f};
      evaluate::HWY_NAMESPACE::Blend{kPlanes}(k, before, now, alpha, both);
    } else {
      for (size_t p = 0; p < kPlanes; ++p) f(p, now(p));
    }
    if (rotates) {
      typename K::template Slots<9> matrix;
      rotate::HWY_NAMESPACE::MatrixFromQuaternion()(k, quaternion, matrix);
      rotate::HWY_NAMESPACE::RotateTensorsByMatrix<kOrder>{probe::kChannels}(k, matrix, f, f);
    }
    if (keeps_radiance) {
      for (size_t p = 0; p < kPlanes; ++p) radiance(p, f(p));
    }
    if (finds_direction) {
      light::HWY_NAMESPACE::Direction{NumCoefficients(kOrder), probe::kChannels, weights}(k, f,
                                                                                          lights);
    }
    if (extracts) {
      light::HWY_NAMESPACE::Extract<kOrder, evaluate::IrradianceBands>{probe::kChannels}(
          k, f, lights.Read(), lights.From(3), lights.From(6));
    }
    if (packs) evaluate::HWY_NAMESPACE::Constants()(k, f, constants);
  }
};

}  // namespace gaunt::frame::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_FRAME_FRAME_INL_H_
