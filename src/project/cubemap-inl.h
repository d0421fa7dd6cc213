// SPDX-License-Identifier: MIT
// Cubemaps: low orders by moments of the faces, high ones by the basis at each texel.
#if defined(GAUNT_PROJECT_CUBEMAP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROJECT_CUBEMAP_INL_H_
#undef GAUNT_PROJECT_CUBEMAP_INL_H_
#else
#define GAUNT_PROJECT_CUBEMAP_INL_H_
#endif

#include <algorithm>
#include <cmath>

#include "project/cube.h"
#include "project/rows-inl.h"
#include "project/samples-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::project::HWY_NAMESPACE {

// Rows of faces in hand.
struct CubeRows {
  const FaceRows* faces;
  size_t num_faces;
  size_t first_row;

  size_t size() const { return faces[0].image->width; }
  size_t rows() const { return faces[0].image->height; }
  const unsigned char* Row(size_t face, size_t row) const {
    const Image& image = *faces[face].image;
    return image.pixels + static_cast<ptrdiff_t>(row - first_row) * image.row_stride;
  }
};

// Numbers per texel of a run, with room for the last vector.
using RunNumbers = float[kMaxRun + kMaxLanes];

// Weights of texels first .. first + n of row y. `small` knows the solid angles of faces whose
// texels are too large for the series of CubeWeights.
HWY_NOINLINE void FillWeights(size_t size, const SmallFace* small, size_t y, size_t first, size_t n,
                              const CubeDegrees& degrees, const RunNumbers& u, RunNumbers& even,
                              RunNumbers& odd) {
  const double side = 2.0 / static_cast<double>(size), v = TexelCentre(y, size);
  if (small != nullptr) {
    for (size_t i = 0; i < n; ++i) {
      const double x = TexelCentre(first + i, size), angle = small->SolidAngle(first + i, y);
      const double root = 1.0 / std::sqrt(x * x + v * v + 1.0);
      double power = angle;
      for (int k = 0; k < degrees.even; ++k) power *= root;
      even[i] = static_cast<float>(power);
      power = angle;
      for (int k = 0; k < degrees.odd; ++k) power *= root;
      odd[i] = static_cast<float>(power);
    }
    return;
  }
  const size_t lanes = hn::Lanes(LaneTag());
  const CubeWeights weights = {v, side, degrees.even, degrees.odd};
  for (size_t i = 0; i < n; i += lanes) {
    const auto out = [&](size_t which, V value)
                         HWY_ATTR { hn::StoreU(value, LaneTag(), (which == 0 ? even : odd) + i); };
    weights(
        Lanes(), [&](size_t) HWY_ATTR { return hn::LoadU(LaneTag(), u + i); }, out);
  }
}

struct CubeTables {
  HWY_ALIGN float data[kTableFloats];
};

// Tables of weights times powers of u, for the texels of a run on row y.
HWY_NOINLINE void FillCubeTables(size_t size, const SmallFace* small, size_t y, size_t first,
                                 size_t run, size_t pattern, const CubeDegrees& degrees,
                                 CubeTables& tables) {
  HWY_ALIGN RunNumbers u, even = {}, odd = {};
  for (size_t i = 0; i < run + kMaxLanes; ++i) {
    u[i] = static_cast<float>(TexelCentre(first + i, size));
  }
  FillWeights(size, small, y, first, std::min(run, size - first), degrees, u, even, odd);
  const LaneTexels lane_texels(pattern);
  const size_t stride = run * pattern;
  for (size_t f = 0; f < stride; f += hn::Lanes(LaneTag())) {
    const V x = Repeat(u, lane_texels.index, f, pattern);
    float* to = tables.data + f;
    const auto out = [&](size_t, V value) HWY_ATTR {
      hn::StoreU(value, LaneTag(), to);
      to += stride;
    };
    Powers{degrees.even}(Lanes(), Repeat(even, lane_texels.index, f, pattern), x, out);
    if (degrees.odd < 0) continue;
    Powers{degrees.odd}(Lanes(), Repeat(odd, lane_texels.index, f, pattern), x, out);
  }
}

// Adds moments in u of two runs of texels of a face, at v and at -v: sums and differences of the
// first and the second.
GAUNT_LANES void AddFace(size_t face, double v, const double* sum, const double* difference,
                         CubeMoments& moments) {
  const ChannelTag d;
  const CubeFace& axes = kCubeFaces[face];
  v *= axes.main.sign * axes.down.sign;
  const uint8_t* slot = moments.slots(face);
  for (const int degree : {moments.degrees().even, moments.degrees().odd}) {
    if (degree < 0) break;
    double factor = degree % 2 == 0 ? 1.0 : axes.main.sign;
    for (int j = 0; j <= degree; ++j, factor *= v) {
      const double factors[2] = {factor, factor * (axes.main.sign * axes.across.sign)};
      const double* from = j % 2 == 0 ? sum : difference;
      for (int k = 0; k + j <= degree; ++k, from += kMaxChannels) {
        double* const to = moments[*slot++];
        for (size_t c = 0; c < kMaxChannels; c += hn::Lanes(d)) {
          hn::StoreU(
              hn::MulAdd(hn::Set(d, factors[k % 2]), hn::LoadU(d, from + c), hn::LoadU(d, to + c)),
              d, to + c);
        }
      }
    }
    sum += kMaxChannels * (degree + 1);
    difference += kMaxChannels * (degree + 1);
  }
}

// Moments of the faces. Tables are made once for all faces, and for both of the rows v and -v.
HWY_NOINLINE void SumCube(int order, size_t channels, const CubeRows& rows, const SmallFace* small,
                          RunBuffer& buffer, CubeMoments& moments) {
  const CubeDegrees degrees(order);
  const size_t count = degrees.Moments(), size = rows.size();
  const size_t end = rows.first_row + rows.rows();
  const auto reader_of = [&](size_t f) {
    return RowReader(*rows.faces[std::min(f, rows.num_faces - 1)].image, channels);
  };
  const RowReader readers[6] = {reader_of(0), reader_of(1), reader_of(2),
                                reader_of(3), reader_of(4), reader_of(5)};
  size_t widest = 0;
  for (const RowReader& reader : readers) widest = std::max(widest, reader.pattern());
  const size_t run = RunLength(count, widest, size);
  CubeTables tables;
  for (size_t y = rows.first_row; y < end; ++y) {
    const size_t mirror = size - 1 - y;
    const bool have_mirror = mirror >= rows.first_row && mirror < end && mirror != y;
    if (have_mirror && mirror < y) continue;
    for (size_t first = 0; first < size; first += run) {
      size_t made_pattern = 0;
      for (size_t f = 0; f < rows.num_faces; ++f) {
        const RowReader& reader = readers[f];
        if (made_pattern != reader.pattern()) {
          made_pattern = reader.pattern();
          FillCubeTables(size, small, y, first, run, made_pattern, degrees, tables);
        }
        double sum[kMaxCubeMoments * kMaxChannels], difference[kMaxCubeMoments * kMaxChannels];
        double* const to[2] = {sum, difference};
        const Run texels = reader.Read(rows.Row(f, y), rows.Row(f, have_mirror ? mirror : y), first,
                                       std::min(run, size - first), buffer);
        RowMoments(reader, texels, have_mirror ? 2 : 1, tables.data, run * made_pattern, count, to);
        if (have_mirror) {
          SumAndDifference(count, sum, difference);
        } else {
          std::copy(sum, sum + count * kMaxChannels, difference);
        }
        AddFace(rows.faces[f].face, TexelCentre(y, size), sum, difference, moments);
      }
    }
  }
}

HWY_NOINLINE void FinishCube(CubeMoments& moments, size_t channels, Sink& sink) {
  Pass pass;
  pass.channels = channels;
  moments.Finish(pass);
  sink.Take(pass);
}

HWY_NOINLINE void CubemapByMoments(int order, size_t channels, const CubeRows& rows,
                                   const SmallFace* small, Sink& sink) {
  CubeMoments moments(order);
  {
    RunBuffer buffer;
    SumCube(order, channels, rows, small, buffer, moments);
  }
  FinishCube(moments, channels, sink);
}

// Directions of a run's texels, and their solid angles.
struct CubeTile {
  HWY_ALIGN float directions[3][kMaxRun];
  HWY_ALIGN float values[kMaxChannels][kMaxRun];
  HWY_ALIGN RunNumbers weights;
};

HWY_NOINLINE void FillDirections(size_t face, size_t size, const SmallFace* small, size_t y,
                                 size_t first, size_t n, size_t whole, CubeTile& tile) {
  HWY_ALIGN RunNumbers u, unused;
  for (size_t i = 0; i < whole + kMaxLanes; ++i) {
    u[i] = static_cast<float>(TexelCentre(first + i, size));
  }
  FillWeights(size, small, y, first, n, CubeDegrees(1), u, tile.weights, unused);
  std::fill(tile.weights + n, tile.weights + whole, 0.0f);
  const CubeFace& axes = kCubeFaces[face];
  const double v = TexelCentre(y, size);
  for (size_t i = 0; i < whole; ++i) {
    const double x = TexelCentre(first + i, size);
    const double scale = 1.0 / std::sqrt(x * x + v * v + 1.0);
    tile.directions[axes.main.axis][i] = static_cast<float>(axes.main.sign * scale);
    tile.directions[axes.across.axis][i] = static_cast<float>(axes.across.sign * x * scale);
    tile.directions[axes.down.axis][i] = static_cast<float>(axes.down.sign * v * scale);
  }
}

HWY_NOINLINE void CubemapByBasis(int order, size_t channels, const CubeRows& rows,
                                 const SmallFace* small, Sink& sink) {
  const size_t size = rows.size(), end = rows.first_row + rows.rows();
  CubeTile tile;
  RunBuffer buffer;
  ForEachSampleBlock(
      order, channels,
      [&](const SampleBlock& block, SampleSums& sums) {
        for (size_t f = 0; f < rows.num_faces; ++f) {
          const RowReader reader(*rows.faces[f].image, channels);
          for (size_t y = rows.first_row; y < end; ++y) {
            for (size_t first = 0; first < size; first += kMaxRun) {
              const size_t n = std::min(kMaxRun, size - first);
              const size_t whole = RoundUp(n, hn::Lanes(LaneTag()));
              FillDirections(rows.faces[f].face, size, small, y, first, n, whole, tile);
              reader.ReadChannels(rows.Row(f, y), first, n, buffer);
              for (size_t c = 0; c < block.channels; ++c) {
                const size_t channel = block.first_channel + c;
                float* const to = tile.values[channel];
                for (size_t i = 0; i < n; ++i) to[i] = reader.ChannelOf(buffer, i, channel);
                std::fill(to + n, to + whole, 0.0f);
              }
              sums.Add(
                  {simd::PlanarIn(tile.directions[0], kMaxRun),
                   simd::PlanarIn(tile.values[0], kMaxRun), simd::PlanarIn(tile.weights, kMaxRun)},
                  0, whole);
            }
          }
        }
      },
      sink);
}

void Cubemap(int order, size_t channels, const FaceRows* faces, size_t num_faces, size_t first_row,
             Sink& sink) {
  const CubeRows rows = {faces, num_faces, first_row};
  const auto project = [&](const SmallFace* small) {
    const bool moments = order <= kMaxCubeMomentOrder;
    (moments ? &CubemapByMoments : &CubemapByBasis)(order, channels, rows, small, sink);
  };
  if (rows.size() > SmallFace::kMaxSize) return project(nullptr);
  const SmallFace small(rows.size());
  project(&small);
}

}  // namespace gaunt::project::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROJECT_CUBEMAP_INL_H_
