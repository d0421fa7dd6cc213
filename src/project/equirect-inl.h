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

// Moments of a row of a panorama, times the functions of its polar angle and its solid angle.
HWY_NOINLINE void AddRow(size_t row, size_t width, size_t height, const FourierMoments& moments,
                         const Legendre& legendre, const double* sums, Pass& pass) {
  const double step = kPi / static_cast<double>(height);
  const double theta = (static_cast<double>(row) + 0.5) * step, sine = std::sin(theta);
  const double solid_angle = 4.0 * kPi / static_cast<double>(width) * sine * std::sin(0.5 * step);
  const ChannelTag d;
  double(*to)[kMaxChannels] = pass.sums;
  legendre.ForEach(std::cos(theta), sine, [&](int, int m, double p) HWY_ATTR {
    const double* from = sums + kMaxChannels * moments.Slot(m);
    for (size_t i = 0; i < (m == 0 ? 1u : 2u); ++i, ++to, from += kMaxChannels) {
      for (size_t c = 0; c < kMaxChannels; c += hn::Lanes(d)) {
        const auto sum = hn::LoadU(d, *to + c);
        hn::StoreU(hn::MulAdd(hn::Set(d, solid_angle * p), hn::LoadU(d, from + c), sum), d,
                   *to + c);
      }
    }
  });
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

  for (size_t y = 0; y < image.height; y += 2) {
    const size_t two = std::min<size_t>(2, image.height - y);
    const unsigned char* const upper = image.pixels + static_cast<ptrdiff_t>(y) * image.row_stride;
    const unsigned char* const lower = two == 2 ? upper + image.row_stride : upper;
    double sums[2][kMaxTables * kMaxChannels];
    for (size_t row = 0; row < two; ++row) std::fill(sums[row], sums[row] + 4 * count, 0.0);
    for (size_t r = runs; r-- > 0;) {
      for (int m = std::max(moments.first, 1); m < moments.last && r + 1 < runs; ++m) {
        for (size_t row = 0; row < two; ++row) {
          Turn(run_c[m - moments.first], run_s[m - moments.first],
               sums[row] + kMaxChannels * moments.Slot(m));
        }
      }
      double here[2][kMaxTables * kMaxChannels];
      double* const to[2] = {here[0], here[1]};
      const Run texels =
          reader.Read(upper, lower, r * run, std::min(run, image.width - r * run), buffer);
      RowMoments(reader, texels, two, tables, stride, count, to);
      for (size_t row = 0; row < two; ++row) AddMoments(count, here[row], sums[row]);
    }
    for (size_t row = 0; row < two; ++row) {
      AddRow(rows.first_row + y + row, image.width, rows.height, moments, legendre, sums[row],
             pass);
    }
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
