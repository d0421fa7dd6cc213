// SPDX-License-Identifier: MIT
#include "frame/environment.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaunt::tool {
namespace {

constexpr double kPi = 3.14159265358979323846;

}  // namespace

Environment Environment::Procedural() {
  Environment sky;
  sky.width_ = 512;
  sky.height_ = 256;
  sky.sun_ = {Normalize({0.62, -0.46, 0.60}), {5.4, 4.5, 3.3}, 0.02};
  sky.texels_.resize(static_cast<size_t>(sky.width_) * static_cast<size_t>(sky.height_) * 3);
  float* out = sky.texels_.data();
  for (int row = 0; row < sky.height_; ++row) {
    for (int column = 0; column < sky.width_; ++column) {
      const Vec3 d = sky.Direction(column, row);
      const double up = std::max(d.z, 0.0);
      const double haze = std::exp(-4.0 * up);
      Vec3 colour = (1.0 - haze) * Vec3{0.16, 0.34, 0.80} + haze * Vec3{0.78, 0.80, 0.80};
      const double near_sun = std::max(Dot(d, sky.sun_.direction), 0.0);
      colour +=
          (0.9 * std::pow(near_sun, 24.0) + 0.3 * std::pow(near_sun, 4.0)) * Vec3{1.0, 0.72, 0.42};
      if (d.z < 0.0) colour = std::min(1.0, 1.0 + 8.0 * d.z) * 0.5 * colour + Vec3{0.1, 0.09, 0.08};
      *out++ = static_cast<float>(std::max(colour.x, 0.05));
      *out++ = static_cast<float>(std::max(colour.y, 0.05));
      *out++ = static_cast<float>(std::max(colour.z, 0.05));
    }
  }
  return sky;
}

Environment Environment::Load(const std::string& path, TexelReport* report) {
  Panorama panorama = LoadPanorama(path, report);
  Environment environment;
  environment.width_ = panorama.width;
  environment.height_ = panorama.height;
  environment.texels_ = std::move(panorama.texels);
  environment.TakeSun();
  return environment;
}

Vec3 Environment::Texel(int column, int row) const {
  const float* texel =
      texels_.data() +
      (static_cast<size_t>(row) * static_cast<size_t>(width_) + static_cast<size_t>(column)) * 3;
  return {texel[0], texel[1], texel[2]};
}

Vec3 Environment::Direction(double column, double row) const {
  const double phi = kPi - 2.0 * kPi * (column + 0.5) / width_;
  const double theta = kPi * (row + 0.5) / height_;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

Vec3 Environment::Radiance(const Vec3& direction) const {
  const double phi = std::atan2(direction.y, direction.x);
  const double theta = std::acos(std::clamp(direction.z, -1.0, 1.0));
  const double x = (kPi - phi) / (2.0 * kPi) * width_ - 0.5;
  const double y = std::clamp(theta / kPi * height_ - 0.5, 0.0, height_ - 1.0);
  const int row = std::min(static_cast<int>(y), height_ - 2);
  const double left = std::floor(x);
  const int column = (static_cast<int>(left) + width_) % width_;
  const int next = (column + 1) % width_;
  const double u = x - left, v = y - row;
  return (1.0 - v) * ((1.0 - u) * Texel(column, row) + u * Texel(next, row)) +
         v * ((1.0 - u) * Texel(column, row + 1) + u * Texel(next, row + 1));
}

void Environment::TakeSun() {
  constexpr double kSunRadius = 5.0 * kPi / 180.0;
  constexpr double kBright = 16.0;  // times the mean
  constexpr double kShare = 0.05;   // of all light, below which a bright spot is no sun
  const auto solid_angle = [&](int row) {
    return 2.0 * kPi / width_ *
           (std::cos(kPi * row / height_) - std::cos(kPi * (row + 1) / height_));
  };
  double mean = 0.0, largest = -1.0;
  Vec3 centre;
  for (int row = 0; row < height_; ++row) {
    for (int column = 0; column < width_; ++column) {
      const double luminance = Luminance(Texel(column, row));
      mean += luminance * solid_angle(row) / (4.0 * kPi);
      if (luminance > largest) largest = luminance, centre = Direction(column, row);
    }
  }
  const double ceiling = kBright * mean;
  Vec3 irradiance, direction;
  std::vector<std::pair<size_t, double>> cut;  // texel, factor
  for (int row = 0; row < height_; ++row) {
    for (int column = 0; column < width_; ++column) {
      const Vec3 texel = Texel(column, row), d = Direction(column, row);
      const double luminance = Luminance(texel);
      if (luminance <= ceiling || Dot(d, centre) < std::cos(kSunRadius)) continue;
      const double keep = ceiling / luminance;
      irradiance += (1.0 - keep) * solid_angle(row) * texel;
      direction += (luminance - ceiling) * solid_angle(row) * d;
      cut.emplace_back(
          (static_cast<size_t>(row) * static_cast<size_t>(width_) + static_cast<size_t>(column)) *
              3,
          keep);
    }
  }
  if (Luminance(irradiance) < kShare * mean * 4.0 * kPi) return;
  for (const auto& [texel, keep] : cut) {
    for (size_t c = 0; c < 3; ++c) texels_[texel + c] *= static_cast<float>(keep);
  }
  sun_ = {Normalize(direction), irradiance, 0.02};
}

}  // namespace gaunt::tool
