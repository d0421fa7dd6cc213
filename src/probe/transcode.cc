// SPDX-License-Identifier: MIT
#include "probe/transcode.h"

#include <algorithm>
#include <cstring>

#include "evaluate/evaluate.h"

namespace gaunt::probe {
namespace {

// Coefficients of as many items as are converted at a time, plane by plane.
constexpr size_t kItems = 16;
constexpr size_t kMaxPlanes = 75;

class Tile {
 public:
  simd::InView In() const { return simd::PlanarIn(planes_, kItems); }
  simd::OutView Out() {
    return {reinterpret_cast<unsigned char*>(planes_), 4, kItems * sizeof(float), 0, 0};
  }
  float* Channel(size_t c, size_t order) { return planes_ + c * order * order * kItems; }

 private:
  alignas(64) float planes_[kMaxPlanes * kItems];
};

void Decode(const FormatUse& from, const PackedProbes& probes, size_t first, size_t n, Tile& tile) {
  from.kernels.decode(n, {probes.data + first * probes.stride, n, probes.stride}, tile.Out());
}

// Channels of one order as those of another.
void ChangeOrder(size_t from_order, Tile& from, size_t to_order, Tile& to) {
  const size_t common = std::min(from_order, to_order);
  const size_t kept = common * common * kItems, size = to_order * to_order * kItems;
  for (size_t c = 0; c < kChannels; ++c) {
    float* const channel = to.Channel(c, to_order);
    std::memcpy(channel, from.Channel(c, from_order), kept * sizeof(float));
    std::fill(channel + kept, channel + size, 0.0f);
  }
}

}  // namespace

void Transcode(const FormatUse& from, const FormatUse& to, size_t count, const PackedProbes& a,
               const PackedProbes* b, float t, uint8_t* packed, size_t stride) {
  Tile decoded, other;
  for (size_t first = 0; first < count; first += kItems) {
    const size_t n = std::min(kItems, count - first);
    Decode(from, a, first, n, decoded);
    if (b != nullptr) {
      Decode(from, *b, first, n, other);
      evaluate::Kernels().blend(from.shape.planes, n, decoded.In(), other.In(),
                                simd::BroadcastIn(&t), decoded.Out());
    }
    const bool same_order = from.shape.order == to.shape.order;
    if (!same_order) ChangeOrder(from.shape.order, decoded, to.shape.order, other);
    to.kernels.encode(false, n, (same_order ? decoded : other).In(), packed + first * stride,
                      stride, nullptr);
  }
}

}  // namespace gaunt::probe
