// SPDX-License-Identifier: MIT
// What a convention of SH coefficients says, and the conventions of engines. The values are those
// of gaunt.h, which documents them.
#ifndef GAUNT_CONVERT_CONVENTION_H_
#define GAUNT_CONVERT_CONVENTION_H_

#include <cstddef>
#include <cstdint>

namespace gaunt::convert {

enum class Sign : uint32_t { kCondonShortley, kPositive, kCount };
enum class Coefficients : uint32_t { kAcn, kSid, kFuma, kCount };
enum class Scale : uint32_t { kOrthonormal, kN3d, kSn3d, kFuma, kPolynomial, kCount };
enum class Quantity : uint32_t {
  kRadiance,
  kRadianceOverPi,
  kIrradiance,
  kIrradianceOverPi,
  kCount
};
// Two directions of a line each.
enum class Axis : uint32_t { kRight, kLeft, kUp, kDown, kForward, kBackward, kCount };

constexpr uint32_t LineOf(Axis axis) { return static_cast<uint32_t>(axis) / 2; }
constexpr int SignOf(Axis axis) { return static_cast<uint32_t>(axis) % 2 == 0 ? 1 : -1; }

struct Convention {
  Sign sign;
  Coefficients coefficients;
  Scale scale;
  Quantity quantity;
  Axis axes[3];
  float offset;
};

constexpr bool IsIrradiance(Quantity quantity) {
  return quantity == Quantity::kIrradiance || quantity == Quantity::kIrradianceOverPi;
}

// The highest order that a convention defines.
constexpr int MaxOrderOf(const Convention& convention, int otherwise) {
  if (convention.scale == Scale::kPolynomial) return 3;
  if (convention.scale == Scale::kFuma || convention.coefficients == Coefficients::kFuma) return 4;
  return otherwise;
}

constexpr bool SpansSpace(const Axis (&axes)[3]) {
  return LineOf(axes[0]) != LineOf(axes[1]) && LineOf(axes[1]) != LineOf(axes[2]) &&
         LineOf(axes[2]) != LineOf(axes[0]);
}

enum class Engine : uint32_t {
  kGaunt,
  kD3dx,
  kUnreal,
  kUnity,
  kGodot,
  kThreejs,
  kFilament,
  kGaussianSplats,
  kAmbix,
  kFuma,
  kCount
};

// Sources: gaunt.h and tests/golden/README.md.
constexpr Convention PresetOf(Engine engine) {
  constexpr Axis kZUp[3] = {Axis::kForward, Axis::kLeft, Axis::kUp};
  Convention convention = {Sign::kCondonShortley, Coefficients::kAcn,          Scale::kOrthonormal,
                           Quantity::kRadiance,   {kZUp[0], kZUp[1], kZUp[2]}, 0.0f};
  const auto look = [&convention](Axis x, Axis y, Axis z) {
    convention.axes[0] = x;
    convention.axes[1] = y;
    convention.axes[2] = z;
  };
  switch (engine) {
    case Engine::kUnreal: look(Axis::kForward, Axis::kRight, Axis::kUp); break;
    case Engine::kUnity:
      convention.sign = Sign::kPositive;
      convention.scale = Scale::kPolynomial;
      convention.quantity = Quantity::kIrradianceOverPi;
      look(Axis::kRight, Axis::kUp, Axis::kForward);
      break;
    case Engine::kGodot:
      convention.sign = Sign::kPositive;
      convention.quantity = Quantity::kRadianceOverPi;
      look(Axis::kRight, Axis::kUp, Axis::kBackward);
      break;
    case Engine::kThreejs:
      convention.sign = Sign::kPositive;
      look(Axis::kRight, Axis::kUp, Axis::kBackward);
      break;
    case Engine::kFilament:
      convention.sign = Sign::kPositive;
      convention.scale = Scale::kPolynomial;
      convention.quantity = Quantity::kIrradianceOverPi;
      look(Axis::kRight, Axis::kUp, Axis::kBackward);
      break;
    case Engine::kGaussianSplats:
      convention.offset = 0.5f;
      look(Axis::kRight, Axis::kDown, Axis::kForward);
      break;
    case Engine::kAmbix:
      convention.sign = Sign::kPositive;
      convention.scale = Scale::kSn3d;
      break;
    case Engine::kFuma:
      convention.sign = Sign::kPositive;
      convention.coefficients = Coefficients::kFuma;
      convention.scale = Scale::kFuma;
      break;
    case Engine::kGaunt:
    case Engine::kD3dx:
    case Engine::kCount: break;
  }
  return convention;
}

}  // namespace gaunt::convert

#endif  // GAUNT_CONVERT_CONVENTION_H_
