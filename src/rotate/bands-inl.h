// SPDX-License-Identifier: MIT
// Kernels of rotation at any order, band by band: turns about z by the three Euler angles, with x
// and z swapped between them. The sines and cosines of the angles come straight from a quaternion,
// without trigonometry and without a singular direction.
#if defined(GAUNT_ROTATE_BANDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_ROTATE_BANDS_INL_H_
#undef GAUNT_ROTATE_BANDS_INL_H_
#else
#define GAUNT_ROTATE_BANDS_INL_H_
#endif

#include <utility>

#include "rotate/each_band-inl.h"
#include "rotate/matrix-inl.h"
#include "rotate/rotate.h"
#include "rotate/turn.h"
#include "simd/lanes-inl.h"
#include "simd/order.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::rotate::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// R = Rz(alpha) Rx(beta) Rz(gamma). The table's swap S takes z to -x with the Condon-Shortley
// phase, and is a reflection, so Rx(beta) = S Rz(beta) S: turns about z by gamma, beta and alpha,
// in this order, and S between them. Before them all, a mirror of y may negate the sines: the first
// turn has factors of its own for them.
enum Turn { kFirstTurn, kFirstTurnOfSines, kMiddleTurn, kLastTurn, kTurns };

// Planes of cos and sin of the three angles, and of the sign that sines have beforehand.
enum AnglePlane {
  kFirstCosine,
  kFirstSine,
  kMiddleCosine,
  kMiddleSine,
  kLastCosine,
  kLastSine,
  kSineSign,
  kAnglePlanes
};

// Planes of cos and sin of one angle, to length 1 once more by a step of Newton's: an error of the
// length would grow with each power. What it adds is rounded for itself: a factor near 1 would
// round down more than up, and shrink what is rotated again and again.
template <class K, class V, class Out>
GAUNT_LANES void PutAngle(const K& k, size_t plane, V c, V s, const Out& angles) {
  const V lacking = Mul(k(0.5), NegMulAdd(s, s, NegMulAdd(c, c, k(1.0))));
  angles(plane, MulAdd(c, lacking, c));
  angles(plane + 1, MulAdd(s, lacking, s));
}

// gamma from e^(i (alpha + gamma)) where `sum`, else from e^(i (alpha - gamma)), and from alpha's c
// and s.
template <class K, class M, class V, class Out>
GAUNT_LANES void PutFirstAngle(const K& k, M sum, V re, V im, V c, V s, const Out& angles) {
  const V sine = MulSub(im, c, Mul(re, s));
  PutAngle(k, kFirstCosine, MulAdd(re, c, Mul(im, s)), IfThenElse(sum, sine, Neg(sine)), angles);
}

// The angles of a quaternion of any length.
struct AnglesFromQuaternion {
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& quaternion, const Out& angles) const {
    using V = typename K::V;
    V x = quaternion(0), y = quaternion(1), z = quaternion(2), w = quaternion(3);
    ScaleQuaternion(k, x, y, z, w);
    // Of the half angles: w + i z = cos(beta/2) e^(i (alpha + gamma)/2), and x + i y = sin(beta/2)
    // e^(i (alpha - gamma)/2). Their squared lengths a and b add up to that of the quaternion, and
    // to something between 4 and 64.
    const V a = MulAdd(w, w, Mul(z, z)), b = MulAdd(x, x, Mul(y, y));
    const V product = Mul(a, b);
    const V root = Sqrt(product);
    // Where one of the two is all but zero, it has no angle: alpha is 0 then, beta 0 or pi.
    const auto pole = Lt(product, k(kPoleProduct));
    const V scale = Div(k(1.0), root);
    const V c = IfThenElse(pole, k(1.0), Mul(MulSub(w, x, Mul(z, y)), scale));
    const V s = IfThenZeroElse(pole, Mul(MulAdd(w, y, Mul(z, x)), scale));
    PutAngle(k, kLastCosine, c, s, angles);
    const V inverse = Div(k(1.0), Add(a, b));
    const V sine = IfThenZeroElse(pole, Add(root, root));
    PutAngle(k, kMiddleCosine, Mul(Sub(a, b), inverse), Mul(sine, inverse), angles);
    // alpha + gamma or alpha - gamma, whichever belongs to the longer one: near a pole it holds
    // where alpha and gamma by themselves do not.
    const auto upper = Gt(a, b);
    const V re = IfThenElse(upper, w, x), im = IfThenElse(upper, z, y);
    const V square = Div(k(1.0), Max(a, b));
    PutFirstAngle(k, upper, Mul(MulSub(re, re, Mul(im, im)), square),
                  Mul(Mul(Add(re, re), im), square), c, s, angles);
  }

 private:
  // Below it, sin(beta) is 2e-12 or less.
  static constexpr double kPoleProduct = 1.6e-23;
};

// The angles of an orthonormal matrix R, after a mirror of y where its determinant is negative.
struct AnglesFromMatrix {
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& r, const Out& angles) const {
    using V = typename K::V;
    const V zero = k(0.0), one = k(1.0);
    const V minor0 = MulSub(r(4), r(8), Mul(r(5), r(7)));
    const V minor1 = MulSub(r(5), r(6), Mul(r(3), r(8)));
    const V minor2 = MulSub(r(3), r(7), Mul(r(4), r(6)));
    const V determinant = MulAdd(r(0), minor0, MulAdd(r(1), minor1, Mul(r(2), minor2)));
    const V sign = IfThenElse(Lt(determinant, zero), k(-1.0), one);
    angles(kSineSign, sign);
    const V xy = Mul(sign, r(1)), yy = Mul(sign, r(4)), cosine = r(8);
    // sin(beta) e^(i alpha) = -R_yz + i R_xz. Where that vanishes, gamma is all there is.
    const V squared = MulAdd(r(2), r(2), Mul(r(5), r(5)));
    const auto pole = Lt(squared, k(kPoleSquared));
    const V sine = Sqrt(squared);
    const V scale = Div(one, sine);
    const V c = IfThenElse(pole, one, Mul(Neg(r(5)), scale));
    const V s = IfThenZeroElse(pole, Mul(r(2), scale));
    PutAngle(k, kMiddleCosine, cosine, sine, angles);
    PutAngle(k, kLastCosine, c, s, angles);
    // (1 + |cos(beta)|) e^(i (alpha +- gamma)), the sum where the cosine is positive. It holds
    // where alpha and gamma by themselves do not.
    const auto upper = Gt(cosine, zero);
    const V half = Div(one, Add(one, Abs(cosine)));
    const V re = Mul(half, Add(r(0), IfThenElse(upper, yy, Neg(yy))));
    const V im = Mul(half, Add(r(3), IfThenElse(upper, Neg(xy), xy)));
    PutFirstAngle(k, upper, re, im, c, s, angles);
  }

 private:
  // Below it, sin(beta) is 1e-15 or less.
  static constexpr double kPoleSquared = 1e-30;
};

// Slots of cos(m angle) and sin(m angle), m = 1 .. kMaxOrder - 1, of each turn.
constexpr size_t CosineSlot(int turn, int m) {
  return static_cast<size_t>(2 * ((kMaxOrder - 1) * turn + m - 1));
}
constexpr size_t SineSlot(int turn, int m) { return CosineSlot(turn, m) + 1; }
inline constexpr int kTurnSlots = 2 * kTurns * (kMaxOrder - 1);

// e^(i m angle), m at least 2, from two powers of half of m.
template <class Slots>
GAUNT_LANES void SetPower(int turn, int m, Slots& turns) {
  const auto c0 = turns(CosineSlot(turn, m / 2)), s0 = turns(SineSlot(turn, m / 2));
  if (m % 2 == 0) {
    turns(CosineSlot(turn, m), MulSub(c0, c0, Mul(s0, s0)));
    turns(SineSlot(turn, m), Mul(Add(c0, c0), s0));
  } else {
    const auto c1 = turns(CosineSlot(turn, m / 2 + 1)), s1 = turns(SineSlot(turn, m / 2 + 1));
    turns(CosineSlot(turn, m), MulSub(c0, c1, Mul(s0, s1)));
    turns(SineSlot(turn, m), MulAdd(s0, c1, Mul(c0, s1)));
  }
}

// All slots for m < order, at least 2, from the angles; n is the order or kAnyOrder. Without
// kMirrors the plane of the sign is not read.
template <int n, bool kMirrors>
struct SetTurns {
  int order;

  template <class InA, class Slots>
  GAUNT_LANES void operator()(const InA& angles, Slots& turns) const {
    turns(CosineSlot(kFirstTurn, 1), angles(kFirstCosine));
    turns(SineSlot(kFirstTurn, 1), angles(kFirstSine));
    turns(CosineSlot(kMiddleTurn, 1), angles(kMiddleCosine));
    turns(SineSlot(kMiddleTurn, 1), angles(kMiddleSine));
    turns(CosineSlot(kLastTurn, 1), angles(kLastCosine));
    turns(SineSlot(kLastTurn, 1), angles(kLastSine));
    SetSines(1, angles, turns);
    if constexpr (n != kAnyOrder) {
      Unrolled(angles, turns, std::make_integer_sequence<int, n - 2>());
    } else {
      for (int m = 2; m < order; ++m) SetPowers(m, angles, turns);
    }
  }

 private:
  template <class InA, class Slots, int... m>
  static GAUNT_LANES void Unrolled(const InA& angles, Slots& turns,
                                   std::integer_sequence<int, m...>) {
    (SetPowers(m + 2, angles, turns), ...);
  }

  // The three turns side by side, since each power waits for smaller ones.
  template <class InA, class Slots>
  static GAUNT_LANES void SetPowers(int m, const InA& angles, Slots& turns) {
    SetPower(kFirstTurn, m, turns);
    SetPower(kMiddleTurn, m, turns);
    SetPower(kLastTurn, m, turns);
    SetSines(m, angles, turns);
  }

  template <class InA, class Slots>
  static GAUNT_LANES void SetSines(int m, const InA& angles, Slots& turns) {
    auto c = turns(CosineSlot(kFirstTurn, m)), s = turns(SineSlot(kFirstTurn, m));
    if constexpr (kMirrors) {
      const auto sign = angles(kSineSign);
      c = Mul(sign, c), s = Mul(sign, s);
    }
    turns(CosineSlot(kFirstTurnOfSines, m), c);
    turns(SineSlot(kFirstTurnOfSines, m), s);
  }
};

// The steps of band l of one channel, unrolled: turns about z, and the swap of the table.
template <int l>
struct BandSteps {
  template <int turn, int turn_of_sines, class Slots, class From, class To>
  static GAUNT_LANES void TurnAboutZ(const Slots& turns, const From& from, To& to) {
    TurnAll<turn, turn_of_sines>(turns, from, to, Pairs());
  }
  template <class K, class From, class To>
  static GAUNT_LANES void Swap(const K& k, const From& from, To& to) {
    SwapAll(k, from, to, Rows());
  }

 private:
  using Pairs = std::make_integer_sequence<int, l + 1>;
  using Rows = std::make_integer_sequence<int, 2 * l + 1>;

  // Side by side, not nested: compilers take minutes over the latter.
  template <int turn, int turn_of_sines, class Slots, class From, class To, int... m>
  static GAUNT_LANES void TurnAll(const Slots& turns, const From& from, To& to,
                                  std::integer_sequence<int, m...>) {
    (TurnPair<turn, turn_of_sines, m>(turns, from, to), ...);
  }

  template <int turn, int turn_of_sines, int m, class Slots, class From, class To>
  static GAUNT_LANES void TurnPair(const Slots& turns, const From& from, To& to) {
    if constexpr (m == 0) {
      to(l, from(l));
    } else {
      const auto even = from(l + m), odd = from(l - m);
      to(l + m,
         MulSub(even, turns(CosineSlot(turn, m)), Mul(odd, turns(SineSlot(turn_of_sines, m)))));
      to(l - m,
         MulAdd(even, turns(SineSlot(turn, m)), Mul(odd, turns(CosineSlot(turn_of_sines, m)))));
    }
  }

  template <class K, class From, class To, int... row>
  static GAUNT_LANES void SwapAll(const K& k, const From& from, To& to,
                                  std::integer_sequence<int, row...>) {
    (to(row, SwapRow<(row < l ? l - row : row - l), (row < l ? -1 : 1)>(k, from)), ...);
  }

  // Coefficient side * m_out.
  template <int m_out, int side, class K, class From>
  static GAUNT_LANES typename K::V SwapRow(const K& k, const From& from) {
    constexpr int kParity = (l + m_out + (side < 0 ? 1 : 0)) % 2;
    constexpr int kFirst = kParity == 0 && side < 0 ? 2 : kParity;
    constexpr int kLast = l - (l - kParity) % 2;
    return SwapSum<m_out, side, kFirst, kLast>(k, from);
  }

  static constexpr double Entry(int m_out, int m_in) {
    return kFloatTurn.entry[TurnIndex(l, m_out, m_in)];
  }
  static constexpr bool AnyEntry(int m_out, int first, int last) {
    for (int m_in = first; m_in <= last; m_in += 2) {
      if (Entry(m_out, m_in) != 0.0) return true;
    }
    return false;
  }

  // Of the coefficients side * m_in, from last down to first by twos.
  template <int m_out, int side, int first, int last, class K, class From>
  static GAUNT_LANES typename K::V SwapSum(const K& k, const From& from) {
    constexpr double kEntry = Entry(m_out, last);
    if constexpr (kEntry == 0.0) {
      return SwapSum<m_out, side, first, last - 2>(k, from);
    } else if constexpr (!AnyEntry(m_out, first, last - 2)) {
      const auto value = from(l + side * last);
      if constexpr (kEntry == 1.0) {
        return value;
      } else if constexpr (kEntry == -1.0) {
        return Neg(value);
      } else {
        return Mul(k(kEntry), value);
      }
    } else {
      return MulAdd(k(kEntry), from(l + side * last),
                    SwapSum<m_out, side, first, last - 2>(k, from));
    }
  }
};

// Band l of one channel.
template <int l>
struct RotateBand {
  template <class K, class Slots, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const Slots& turns, const In& in, const Out& out) const {
    if constexpr (l == 0) return out(0, in(0));
    using Steps = BandSteps<l>;
    typename K::template Slots<2 * l + 1> turned, swapped;
    Steps::template TurnAboutZ<kFirstTurn, kFirstTurnOfSines>(turns, in, turned);
    Steps::Swap(k, turned, swapped);
    Steps::template TurnAboutZ<kMiddleTurn, kMiddleTurn>(turns, swapped, turned);
    Steps::Swap(k, turned, swapped);
    Steps::template TurnAboutZ<kLastTurn, kLastTurn>(turns, swapped, out);
  }
};

// All bands of each channel, from the angles; n is the order or kAnyOrder.
template <int n, bool kMirrors>
class RotateBands {
 public:
  RotateBands(int order, size_t channels) : order_(order), channels_(channels) {}

  template <class K, class InA, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const InA& angles, const In& in, const Out& out) const {
    const int order = n != kAnyOrder ? n : order_;
    typename K::template Slots<kTurnSlots> turns;
    SetTurns<n, kMirrors>{order}(angles, turns);
    ForEachBand<n, RotateBand>(k, order, channels_, turns, in, out);
  }

 private:
  int order_;
  size_t channels_;
};

}  // namespace gaunt::rotate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_ROTATE_BANDS_INL_H_
