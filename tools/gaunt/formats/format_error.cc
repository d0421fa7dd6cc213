// SPDX-License-Identifier: MIT
#include "formats/format_error.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "evaluate/evaluate_reference.h"
#include "format_name.h"

namespace gaunt::tool {
namespace {

constexpr size_t kChannels = 3;
constexpr size_t kLightSize = size_t{kLightOrder} * kLightOrder;
constexpr size_t kDirections = 8192;

void Check(gaunt_status status) {
  if (status != GAUNT_OK) throw std::runtime_error(gaunt_status_string(status));
}

gaunt_view Interleaved(const std::vector<float>& data, size_t planes) {
  gaunt_view view;
  gaunt_view_interleaved(const_cast<float*>(data.data()), planes, &view);
  return view;
}

// Evenly spread over the sphere, on a spiral that turns by the golden angle from one to the next.
std::vector<float> SpiralDirections() {
  std::vector<float> directions;
  const double golden = std::acos(-1.0) * (3.0 - std::sqrt(5.0));
  for (size_t k = 0; k < kDirections; ++k) {
    const double z = 1.0 - (2.0 * static_cast<double>(k) + 1.0) / kDirections;
    const double phi = golden * static_cast<double>(k), r = std::sqrt(1.0 - z * z);
    for (const double x : {r * std::cos(phi), r * std::sin(phi), z}) {
      directions.push_back(static_cast<float>(x));
    }
  }
  return directions;
}

// Norm of E/pi by Parseval's theorem.
double IrradianceNorm(const Light& light) {
  double sum = 0.0;
  for (size_t c = 0; c < kChannels; ++c) {
    for (size_t l = 0; l < kLightOrder; ++l) {
      const double factor = evaluate::CosineFactor(static_cast<int>(l));
      for (size_t i = l * l; i < (l + 1) * (l + 1); ++i) {
        sum += std::pow(factor * double{light[c * kLightSize + i]}, 2);
      }
    }
  }
  return std::sqrt(sum);
}

double LargestIrradiance(const Light& light) {
  static const std::vector<float> directions = SpiralDirections();
  std::vector<float> out(kDirections * kChannels);
  gaunt_view probe;
  gaunt_view_broadcast(const_cast<float*>(light.data()), &probe);
  const gaunt_view normals = Interleaved(directions, 3), result = Interleaved(out, kChannels);
  Check(gaunt_irradiance_evaluate(kLightOrder, kChannels, kDirections, &probe, &normals, &result));
  double largest = 0.0;
  for (const float e : out) largest = std::max(largest, std::abs(double{e}));
  return largest;
}

// Of a model of an order, channel by channel, in place of the light.
FormatError ErrorOf(const std::vector<float>& model, uint32_t order, const Light& light) {
  const size_t size = size_t{order} * order;
  Light difference = light;
  double mean = 0.0;
  for (size_t c = 0; c < kChannels; ++c) {
    mean += double{light[c * kLightSize]} / (std::sqrt(4.0 * std::acos(-1.0)) * kChannels);
    for (size_t i = 0; i < size; ++i) difference[c * kLightSize + i] -= model[c * size + i];
  }
  return {IrradianceNorm(difference) / IrradianceNorm(light), LargestIrradiance(difference) / mean};
}

std::vector<float> Truncate(uint32_t order, const Light& light) {
  std::vector<float> model;
  for (size_t c = 0; c < kChannels; ++c) {
    const auto begin = light.begin() + static_cast<ptrdiff_t>(c * kLightSize);
    model.insert(model.end(), begin, begin + static_cast<ptrdiff_t>(order * order));
  }
  return model;
}

}  // namespace

Light ProjectLight(const gaunt_image& panorama) {
  Light light(kChannels * kLightSize);
  const gaunt_view out = Interleaved(light, light.size());
  Check(gaunt_project_equirect(kLightOrder, kChannels, &panorama, nullptr, &out));
  return light;
}

FormatError ErrorOfOrder(uint32_t order, const Light& light) {
  return ErrorOf(Truncate(order, light), order, light);
}

FormatError ErrorOfFormat(uint32_t format, bool refined, const Light& light) {
  const gaunt_format_properties properties = PropertiesOfFormat(format);
  std::vector<float> model = Truncate(properties.order, light);
  std::vector<unsigned char> record(properties.bytes);
  const gaunt_view view = Interleaved(model, model.size());
  const auto encode = refined ? gaunt_probe_encode_refined : gaunt_probe_encode;
  Check(encode(format, 1, &view, record.data(), record.size(), nullptr));
  Check(gaunt_probe_decode(format, 1, record.data(), record.size(), &view));
  return ErrorOf(model, properties.order, light);
}

}  // namespace gaunt::tool
