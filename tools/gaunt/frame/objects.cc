// SPDX-License-Identifier: MIT
#include "frame/objects.h"

#include <random>

namespace gaunt::tool {
namespace {

constexpr double kRotating = 0.3;
constexpr double kRadiansPerFrame = 0.02;

// Of a standard engine, but scaled by hand: distributions differ between libraries.
double Uniform(std::mt19937& engine) { return static_cast<double>(engine()) / 4294967296.0; }

}  // namespace

Objects::Objects(const Scene& scene, size_t count)
    : indices_(count * 8), weights_(count * 8), quaternions_(count * 4), rotates_(count) {
  std::mt19937 engine(20);
  const Bounds& bounds = scene.probe_bounds();
  const Vec3 size = bounds.high - bounds.low;
  for (size_t i = 0; i < count; ++i) {
    Vec3 start;
    // Most objects stand or fly low. One that starts in a wall tries again, a few times.
    for (int attempt = 0; attempt < 20; ++attempt) {
      const double height = Uniform(engine);
      start = bounds.low + size * Vec3{Uniform(engine), Uniform(engine), height * height};
      if (!scene.Inside(start)) break;
    }
    start_.push_back(start);
    reach_.push_back({0.6 * Uniform(engine), 0.6 * Uniform(engine), 0.15 * Uniform(engine)});
    axis_.push_back(SphereDirection(static_cast<int>(engine() % 1000), 1000));
    rotates_[i] = Uniform(engine) < kRotating ? 1 : 0;
  }
  position_ = start_;
}

void Objects::MoveTo(int frame, const ProbeGrid& grid) {
  for (size_t i = 0; i < count(); ++i) {
    const double t = kRadiansPerFrame * frame + static_cast<double>(i);
    const Vec3 swing = {std::sin(t), std::cos(t), std::sin(1.7 * t)};
    position_[i] = start_[i] + reach_[i] * swing;
    grid.Taps(position_[i], indices_.data() + 8 * i, weights_.data() + 8 * i);
    if (!rotates_[i]) continue;
    float* q = quaternions_.data() + 4 * i;
    q[0] = static_cast<float>(std::sin(t) * axis_[i].x);
    q[1] = static_cast<float>(std::sin(t) * axis_[i].y);
    q[2] = static_cast<float>(std::sin(t) * axis_[i].z);
    q[3] = static_cast<float>(std::cos(t));
  }
}

}  // namespace gaunt::tool
