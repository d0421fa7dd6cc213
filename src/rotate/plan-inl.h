// SPDX-License-Identifier: MIT
// Kernels that apply one planned rotation to many items.
#if defined(GAUNT_ROTATE_PLAN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_ROTATE_PLAN_INL_H_
#undef GAUNT_ROTATE_PLAN_INL_H_
#else
#define GAUNT_ROTATE_PLAN_INL_H_
#endif

#include <utility>

#include "rotate/each_band-inl.h"
#include "rotate/plan.h"
#include "simd/lanes-inl.h"
#include "simd/order.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::rotate::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Entries of row m, of the cosines or, if negative, of the sines, by the m of their columns.
constexpr const float* RowOf(int l, const float* matrices, int m) {
  return m >= 0 ? matrices + m * (l + 1) : matrices + (l + 1) * (l + 1) - (m + 1) * l - 1;
}

// Offsets of the planes p and q of a turn from the middle of a band, by m.
struct PairOffsets {
  ptrdiff_t p[kMaxOrder], q[kMaxOrder];

  template <class Planes>
  GAUNT_LANES PairOffsets(int order, const PlannedTurn& turn, const Planes& planes) {
    for (int m = 1; m < order; ++m) {
      p[m] = planes.Offset(turn.side[m] * m);
      q[m] = -p[m];
    }
  }
};

// A plan for the strides of a batch.
struct PlacedPlan {
  const PlannedTurn& first;
  const PlannedTurn& last;
  const float* matrices;
  PairOffsets in, out;
};

// Band l of one channel, unrolled. Slots hold turned cosines from l up, the sines below.
template <int l>
struct ApplyBand {
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const PlacedPlan& placed, const In& in,
                              const Out& out) const {
    if constexpr (l == 0) return out(0, in(0));
    typename K::template Slots<2 * l + 1> turned, mixed;
    First(k, placed.first.tangent, placed.in, in.From(l), turned, Pairs());
    Mix(k, placed.matrices + MatricesIndex(l), turned, mixed, Rows());
    Last(k, placed.last.tangent, placed.out, mixed, out.From(l), Pairs());
  }

 private:
  using Pairs = std::make_integer_sequence<int, l + 1>;
  using Rows = std::make_integer_sequence<int, 2 * l + 1>;

  // Side by side, not nested: compilers take minutes over the latter.
  template <class K, class In, class To, int... m>
  static GAUNT_LANES void First(const K& k, const float* tangents, const PairOffsets& offsets,
                                const In& in, To& to, std::integer_sequence<int, m...>) {
    (FirstPair<m>(k, tangents, offsets, in, to), ...);
  }
  template <class K, class From, class Out, int... m>
  static GAUNT_LANES void Last(const K& k, const float* tangents, const PairOffsets& offsets,
                               const From& from, const Out& out, std::integer_sequence<int, m...>) {
    (LastPair<m>(k, tangents, offsets, from, out), ...);
  }
  template <class K, class From, class To, int... row>
  static GAUNT_LANES void Mix(const K& k, const float* matrices, const From& from, To& to,
                              std::integer_sequence<int, row...>) {
    (MixRow<row>(k, matrices, from, to), ...);
  }

  template <int m, class K, class In, class To>
  static GAUNT_LANES void FirstPair(const K& k, const float* tangents, const PairOffsets& offsets,
                                    const In& in, To& to) {
    if constexpr (m == 0) {
      to(l, in(0));
    } else {
      const auto p = in.At(offsets.p[m]), q = in.At(offsets.q[m]), tangent = k(tangents[m]);
      to(l + m, NegMulAdd(tangent, q, p));
      to(l - m, MulAdd(tangent, p, q));
    }
  }

  template <int m, class K, class From, class Out>
  static GAUNT_LANES void LastPair(const K& k, const float* tangents, const PairOffsets& offsets,
                                   const From& from, const Out& out) {
    if constexpr (m == 0) {
      out(0, from(l));
    } else {
      const auto p = from(l + m), q = from(l - m), tangent = k(tangents[m]);
      out.At(offsets.p[m], NegMulAdd(tangent, q, p));
      out.At(offsets.q[m], MulAdd(tangent, p, q));
    }
  }

  template <int row, class K, class From, class To>
  static GAUNT_LANES void MixRow(const K& k, const float* matrices, const From& from, To& to) {
    constexpr int kSide = row < l ? -1 : 1;
    to(row, Sum<l, kSide>(k, RowOf(l, matrices, row - l), from));
  }

  // Of the products of coefficients side * m with the row's entries, m down to the first.
  template <int m, int side, class K, class From>
  static GAUNT_LANES typename K::V Sum(const K& k, const float* row, const From& from) {
    if constexpr (m == (side < 0 ? 1 : 0)) {
      return Mul(k(row[m]), from(l + side * m));
    } else {
      return MulAdd(k(row[m]), from(l + side * m), Sum<m - 1, side>(k, row, from));
    }
  }
};

// All bands of each channel; n is the order or kAnyOrder. The turns are copies, which no store to a
// plane can change.
template <int n>
class ApplyPlan {
 public:
  ApplyPlan(const Plan& plan, int order, size_t channels)
      : first_(plan.first),
        last_(plan.last),
        matrices_(plan.matrices),
        order_(order),
        channels_(channels) {}

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& out) const {
    const int order = n != kAnyOrder ? n : order_;
    const PlacedPlan placed = {first_, last_, matrices_, PairOffsets(order, first_, in),
                               PairOffsets(order, last_, out)};
    ForEachBand<n, ApplyBand>(k, order, channels_, placed, in, out);
  }

 private:
  PlannedTurn first_, last_;
  const float* matrices_;
  int order_;
  size_t channels_;
};

// Moves of all bands of each channel.
struct ApplyMoves {
  int order;
  size_t channels;
  Moves moves;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& out) const {
    for (size_t c = 0; c < channels; ++c) {
      for (int l = 0; l < order; ++l) {
        const size_t middle = c * static_cast<size_t>(NumCoefficients(order)) +
                              static_cast<size_t>(CoefficientIndex(l, 0));
        const float band = l % 2 == 0 ? 1.0f : moves.odd_band;
        out(middle, Mul(k(band), in(middle)));
        for (size_t m = 1; m <= static_cast<size_t>(l); ++m) {
          const auto cosine = in(middle + m), sine = in(middle - m);
          const auto to_cosine = k(band * moves.to_cosine[m]), to_sine = k(band * moves.to_sine[m]);
          out(middle + m, Mul(to_cosine, moves.swaps[m] ? sine : cosine));
          out(middle - m, Mul(to_sine, moves.swaps[m] ? cosine : sine));
        }
      }
    }
  }
};

}  // namespace gaunt::rotate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_ROTATE_PLAN_INL_H_
