// SPDX-License-Identifier: MIT
#include "project/project.h"

#include <algorithm>
#include <cmath>

#include "project/legendre.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "project/project.cc"
#include <hwy/foreach_target.h>

#include "project/project-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::project::HWY_NAMESPACE {

// Lanes of the narrowest vector that this target may run with.
constexpr size_t kMinLanes = HWY_MIN(4, HWY_LANES(float));
constexpr size_t kColumns = 32 * kMinLanes;  // whose cosines and sines are held at a time
constexpr size_t kMaxMoments = 2 * kMaxUnrolledOrder - 1;

// Moment 0 is the sum; 2m-1 and 2m weigh by cos(m phi) and sin(m phi).
struct ColumnWeights {
  HWY_ALIGN float rows[kMaxMoments][kColumns];

  ColumnWeights(int order, size_t width, size_t first, size_t columns) {
    for (size_t i = 0; i < kColumns; ++i) {
      // Columns past the end repeat the last texel: with weight zero, they add nothing.
      const double one = i < columns ? 1.0 : 0.0;
      const double turn = (static_cast<double>(first + i) + 0.5) / static_cast<double>(width);
      const double phi = kPi - 2.0 * kPi * turn;
      rows[0][i] = static_cast<float>(one);
      for (int m = 1; m < order; ++m) {
        rows[2 * m - 1][i] = static_cast<float>(one * std::cos(m * phi));
        rows[2 * m][i] = static_cast<float>(one * std::sin(m * phi));
      }
    }
  }
};

using Moments = double[kMaxMoments];

void AddRow(int order, size_t channels, double z, double s, double weight, const Moments* moments,
            double* sums) {
  ForEachLegendre(order, z, s, [&](int l, int m, double p) {
    for (size_t c = 0; c < channels; ++c) {
      double* const sum = sums + c * static_cast<size_t>(order * order);
      sum[CoefficientIndex(l, m)] += weight * p * moments[c][m == 0 ? 0 : 2 * m - 1];
      if (m > 0) sum[CoefficientIndex(l, -m)] += weight * p * moments[c][2 * m];
    }
  });
}

// Texels of a run of columns as planes, one tile of a group of lanes after the other.
class TexelTiles {
 public:
  TexelTiles(const simd::InView& row, size_t first, size_t columns, size_t channels, bool clamp)
      : channels_(channels), groups_((columns + hn::Lanes(LaneTag()) - 1) / hn::Lanes(LaneTag())) {
    const size_t lanes = hn::Lanes(LaneTag());
    for (size_t g = 0; g < groups_; ++g) {
      LoadTiles(row, ShapeOf(row, channels), first + g * lanes,
                std::min(lanes, columns - g * lanes), channels, tiles_ + g * channels * kMaxLanes);
    }
    if (!clamp) return;
    for (size_t t = 0; t < groups_ * channels; ++t) {
      float* const tile = tiles_ + t * kMaxLanes;
      hn::Store(Clamp()(Lanes(), hn::Load(LaneTag(), tile)), LaneTag(), tile);
    }
  }

  double Moment(size_t channel, const float* weights) const {
    const PlanesIn texels = {reinterpret_cast<const unsigned char*>(tiles_ + channel * kMaxLanes),
                             static_cast<ptrdiff_t>(channels_ * kMaxLanes * sizeof(float))};
    const PlanesIn columns = {reinterpret_cast<const unsigned char*>(weights),
                              static_cast<ptrdiff_t>(hn::Lanes(LaneTag()) * sizeof(float))};
    const auto sum = WeightedSum()(Lanes(), texels, columns, groups_);
    return static_cast<double>(hn::GetLane(hn::SumOfLanes(LaneTag(), sum)));
  }

 private:
  size_t channels_;
  size_t groups_;
  // Groups of fewer lanes than kMaxLanes leave the rest of their tile unused.
  HWY_ALIGN float tiles_[kMaxChannels * (kColumns / kMinLanes) * kMaxLanes];
};

// Separates into rows: Fourier moments of the texels in float, over short runs, times Legendre
// functions and the exact solid angle of the row's texels in double.
void EquirectRows(int order, size_t channels, const Image& image, size_t first_row, size_t rows,
                  bool clamp, double* sums) {
  const size_t num_moments = static_cast<size_t>(2 * order - 1);
  const double turn = 2.0 * kPi / static_cast<double>(image.width);
  const double step = kPi / static_cast<double>(image.height);
  for (size_t x = 0; x < image.width; x += kColumns) {
    const size_t columns = std::min(kColumns, image.width - x);
    const ColumnWeights weights(order, image.width, x, columns);
    for (size_t y = first_row; y < first_row + rows; ++y) {
      const simd::InView row = {image.pixels + static_cast<ptrdiff_t>(y) * image.row_stride,
                                image.pixel_stride, sizeof(float), 0, 0};
      const TexelTiles texels(row, x, columns, channels, clamp);
      Moments moments[kMaxChannels];
      for (size_t c = 0; c < channels; ++c) {
        for (size_t k = 0; k < num_moments; ++k) {
          moments[c][k] = texels.Moment(c, weights.rows[k]);
        }
      }
      const double theta = (static_cast<double>(y) + 0.5) * step;
      const double solid_angle = turn * 2.0 * std::sin(theta) * std::sin(0.5 * step);
      AddRow(order, channels, std::cos(theta), std::sin(theta), solid_angle, moments, sums);
    }
  }
}

const Table* GetTable() {
  static constexpr Table kTable = {&EquirectRows};
  return &kTable;
}

}  // namespace gaunt::project::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(project);
