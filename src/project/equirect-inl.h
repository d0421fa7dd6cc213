// SPDX-License-Identifier: MIT
// Panoramas separate: Fourier moments of rows, times Legendre functions of the row.
#if defined(GAUNT_PROJECT_EQUIRECT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROJECT_EQUIRECT_INL_H_
#undef GAUNT_PROJECT_EQUIRECT_INL_H_
#else
#define GAUNT_PROJECT_EQUIRECT_INL_H_
#endif

#include <algorithm>
#include <cmath>

#include "project/legendre.h"
#include "project/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::project::HWY_NAMESPACE {

struct EquirectRows {
  const Image* rows;
  size_t first_row;
  size_t height;  // of the panorama
};

// Columns first <= m < last of the coefficients: cos(m phi) and sin(m phi) for each, but no sine of
// zero.
struct FourierMoments {
  int first, last;

  size_t Count() const { return Slot(last); }
  size_t Slot(int m) const {
    return static_cast<size_t>(2 * (m - first) - (first == 0 && m > 0 ? 1 : 0));
  }
};

// Moments of the texels of a run, which begins at `phi` and has `turn` from texel to texel.
inline void FillFourierTables(const FourierMoments& moments, double phi, double turn, size_t run,
                              size_t pattern, float* tables) {
  const double turn_c = std::cos(turn), turn_s = std::sin(turn);
  const double first_turn_c = std::cos(moments.first * turn);
  const double first_turn_s = std::sin(moments.first * turn);
  double c = std::cos(phi), s = std::sin(phi);
  double first_c = std::cos(moments.first * phi), first_s = std::sin(moments.first * phi);
  const auto rotate = [](double& x, double& y, double by_c, double by_s) {
    const double next = x * by_c - y * by_s;
    y = x * by_s + y * by_c;
    x = next;
  };
  for (size_t i = 0; i < run; ++i) {
    double cm = first_c, sm = first_s;
    for (int m = moments.first; m < moments.last; ++m) {
      float* const to = tables + (moments.Slot(m) * run + i) * pattern;
      std::fill(to, to + pattern, static_cast<float>(cm));
      if (m > 0) std::fill(to + run * pattern, to + (run + 1) * pattern, static_cast<float>(sm));
      rotate(cm, sm, c, s);
    }
    rotate(c, s, turn_c, turn_s);
    rotate(first_c, first_s, first_turn_c, first_turn_s);
  }
}

// Turns the moments of a cosine and of its sine, by channel, by an angle.
GAUNT_LANES void Turn(double by_c, double by_s, double* moments) {
  const ChannelTag d;
  const auto turn_c = hn::Set(d, by_c), turn_s = hn::Set(d, by_s);
  for (size_t i = 0; i < kMaxChannels; i += hn::Lanes(d)) {
    const auto c = hn::LoadU(d, moments + i), s = hn::LoadU(d, moments + kMaxChannels + i);
    hn::StoreU(hn::NegMulAdd(s, turn_s, hn::Mul(c, turn_c)), d, moments + i);
    hn::StoreU(hn::MulAdd(c, turn_s, hn::Mul(s, turn_c)), d, moments + kMaxChannels + i);
  }
}

// One pass: moments in float over runs, in double over the runs of a row. Runs share one table;
// each is turned by as much as it is away from the first.
HWY_NOINLINE void SumEquirect(const RowReader& reader, const EquirectRows& rows,
                              const FourierMoments& moments, const Legendre& legendre,
                              RunBuffer& buffer, Pass& pass) {
  const Image& image = *rows.rows;
  const size_t count = moments.Count();
  const size_t run = RunLength(count, reader.pattern(), image.width);
  const size_t stride = run * reader.pattern();
  const size_t runs = (image.width + run - 1) / run;
  const double turn = -2.0 * kPi / static_cast<double>(image.width);
  HWY_ALIGN float tables[kTableFloats];
  FillFourierTables(moments, kPi + 0.5 * turn, turn, run, reader.pattern(), tables);
  double run_c[kMaxTables], run_s[kMaxTables];
  for (int m = moments.first; m < moments.last; ++m) {
    run_c[m - moments.first] = std::cos(m * turn * static_cast<double>(run));
    run_s[m - moments.first] = std::sin(m * turn * static_cast<double>(run));
  }

  const double step = kPi / static_cast<double>(rows.height);
  for (size_t y = 0; y < image.height; ++y) {
    const unsigned char* const row = image.pixels + static_cast<ptrdiff_t>(y) * image.row_stride;
    double sums[kMaxTables * kMaxChannels] = {};
    for (size_t r = runs; r-- > 0;) {
      for (int m = std::max(moments.first, 1); m < moments.last && r + 1 < runs; ++m) {
        Turn(run_c[m - moments.first], run_s[m - moments.first],
             sums + kMaxChannels * moments.Slot(m));
      }
      Stretch main, tail;
      reader.Read(row, r * run, std::min(run, image.width - r * run), buffer, main, tail);
      double here[kMaxTables * kMaxChannels];
      RowMoments(reader, main, tail, tables, stride, count, here);
      AddMoments(count, here, sums);
    }
    const double theta = (static_cast<double>(rows.first_row + y) + 0.5) * step;
    const double sin_theta = std::sin(theta);
    const double solid_angle = -turn * 2.0 * sin_theta * std::sin(0.5 * step);
    double(*to)[kMaxChannels] = pass.sums;
    legendre.ForEach(std::cos(theta), sin_theta, [&](int, int m, double p) {
      for (size_t i = 0; i < (m == 0 ? 1u : 2u); ++i, ++to) {
        const double* const from = sums + kMaxChannels * (moments.Slot(m) + i);
        for (int c = 0; c < kMaxChannels; ++c) (*to)[c] += solid_angle * p * from[c];
      }
    });
  }
}

HWY_NOINLINE void EquirectPass(const RowReader& reader, const EquirectRows& rows,
                               const FourierMoments& moments, const Legendre& legendre,
                               RunBuffer& buffer, size_t channels, Sink& sink) {
  Pass pass;
  pass.channels = channels;
  legendre.ForEach(0.0, 0.0, [&](int l, int m, double) { pass.List(l, m); });
  SumEquirect(reader, rows, moments, legendre, buffer, pass);
  sink.Take(pass);
}

void Equirect(int order, size_t channels, const Image& image, size_t first_row, size_t height,
              Sink& sink) {
  const RowReader reader(image, channels);
  RunBuffer buffer;
  FourierMoments moments = {0, 0};
  for (; moments.first < order; moments.first = moments.last) {
    // As many columns as there is room for.
    size_t coefficients = 0;
    do {
      const int m = moments.last++;
      coefficients += static_cast<size_t>((m == 0 ? 1 : 2) * (order - m));
    } while (moments.last < order &&
             FourierMoments{moments.first, moments.last + 1}.Count() <= kMaxTables &&
             coefficients + 2 * static_cast<size_t>(order - moments.last) <=
                 Pass::kMaxCoefficients);
    const Legendre legendre(order, moments.first, moments.last);
    EquirectPass(reader, {&image, first_row, height}, moments, legendre, buffer, channels, sink);
  }
}

}  // namespace gaunt::project::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROJECT_EQUIRECT_INL_H_
