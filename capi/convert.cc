// SPDX-License-Identifier: MIT
#include "convert/convert.h"

#include <algorithm>
#include <cmath>

#include "check.h"

using gaunt::capi::InputOf;
using gaunt::capi::InRange;
using gaunt::capi::MemoryCheck;
using gaunt::capi::OutputOf;

namespace {

using gaunt::convert::Axis;
using gaunt::convert::Coefficients;
using gaunt::convert::Convention;
using gaunt::convert::Conversion;
using gaunt::convert::Engine;
using gaunt::convert::Quantity;
using gaunt::convert::Scale;
using gaunt::convert::Sign;

// Values in C and in the library are the same.
template <typename Enum>
constexpr bool Is(Enum value, uint32_t c_value) {
  return static_cast<uint32_t>(value) == c_value;
}
static_assert(Is(Sign::kPositive, GAUNT_SIGN_POSITIVE));
static_assert(Is(Coefficients::kFuma, GAUNT_COEFFICIENTS_FUMA));
static_assert(Is(Scale::kPolynomial, GAUNT_SCALE_POLYNOMIAL));
static_assert(Is(Quantity::kIrradianceOverPi, GAUNT_QUANTITY_IRRADIANCE_OVER_PI));
static_assert(Is(Axis::kBackward, GAUNT_AXIS_BACKWARD));
static_assert(Is(Engine::kFuma, GAUNT_ENGINE_FUMA));

// False if the value has no name.
template <typename Enum>
bool Named(uint32_t value, Enum* name) {
  *name = static_cast<Enum>(value);
  return value < static_cast<uint32_t>(Enum::kCount);
}

gaunt_status ConventionOf(const gaunt_convention* convention, Convention* result) {
  GAUNT_REQUIRE(convention != nullptr, GAUNT_ERROR_NULL);
  GAUNT_REQUIRE(convention->struct_size == sizeof(*convention), GAUNT_ERROR_STRUCT);
  bool named = Named(convention->sign, &result->sign) &&
               Named(convention->coefficients, &result->coefficients) &&
               Named(convention->scale, &result->scale) &&
               Named(convention->quantity, &result->quantity);
  for (int k = 0; k < 3; ++k) named = named && Named(convention->axes[k], &result->axes[k]);
  GAUNT_REQUIRE(named && SpansSpace(result->axes), GAUNT_ERROR_RANGE);
  GAUNT_REQUIRE(std::isfinite(convention->offset), GAUNT_ERROR_RANGE);
  result->offset = convention->offset;
  return GAUNT_OK;
}

}  // namespace

extern "C" {

gaunt_status gaunt_convention_preset(uint32_t engine, gaunt_convention* convention) {
  GAUNT_REQUIRE(convention != nullptr, GAUNT_ERROR_NULL);
  GAUNT_REQUIRE(convention->struct_size == sizeof(*convention), GAUNT_ERROR_STRUCT);
  Engine name;
  GAUNT_REQUIRE(Named(engine, &name), GAUNT_ERROR_RANGE);
  const Convention preset = gaunt::convert::PresetOf(name);
  convention->sign = static_cast<uint32_t>(preset.sign);
  convention->coefficients = static_cast<uint32_t>(preset.coefficients);
  convention->scale = static_cast<uint32_t>(preset.scale);
  convention->quantity = static_cast<uint32_t>(preset.quantity);
  for (int k = 0; k < 3; ++k) convention->axes[k] = static_cast<uint32_t>(preset.axes[k]);
  convention->offset = preset.offset;
  return GAUNT_OK;
}

gaunt_status gaunt_convert(uint32_t n, uint32_t channels, size_t count,
                           const gaunt_convention* from, const gaunt_convention* to,
                           const gaunt_view* in, const gaunt_view* out) {
  GAUNT_REQUIRE(InRange(n, 1, GAUNT_MAX_ORDER), GAUNT_ERROR_ORDER);
  GAUNT_REQUIRE(InRange(channels, 1, GAUNT_MAX_CHANNELS), GAUNT_ERROR_RANGE);
  Convention source, target;
  GAUNT_CHECK(ConventionOf(from, &source));
  GAUNT_CHECK(ConventionOf(to, &target));
  const Conversion conversion(source, target);
  const int order = static_cast<int>(n);
  GAUNT_REQUIRE(conversion.Has(order), GAUNT_ERROR_ORDER);
  const size_t planes = size_t{channels} * n * n;
  GAUNT_CHECK(MemoryCheck(count).In(in, planes).OutInPlace(out, planes).status());
  if (count == 0) return GAUNT_OK;
  gaunt::convert::Kernels().convert(conversion, order, channels, count, InputOf(*in, count),
                                    OutputOf(*out, count));
  return GAUNT_OK;
}

}  // extern "C"
