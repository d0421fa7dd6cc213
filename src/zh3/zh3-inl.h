// SPDX-License-Identifier: MIT
// Kernels of ZH3: order 2 and, of band 2, the part k2 that is symmetric about the axis of band 1.
// `shared`: one axis for all channels, that of their weighted sum; else one for each.
#if defined(GAUNT_ZH3_ZH3_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_ZH3_ZH3_INL_H_
#undef GAUNT_ZH3_ZH3_INL_H_
#else
#define GAUNT_ZH3_ZH3_INL_H_
#endif

#include "simd/lanes-inl.h"
#include "simd/power-inl.h"
#include "zh3/constants.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::zh3::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// out(first ..) = (x, y, z) / |.|, or zero where that is below 1e-37, or not finite.
template <class K, class V, class Out>
GAUNT_LANES void Unit(const K& k, V x, V y, V z, size_t first, Out& out) {
  const V largest = Max(Max(Abs(x), Abs(y)), Abs(z));
  const V scale = Div(k(1.0), largest);
  x = Mul(x, scale);
  y = Mul(y, scale);
  z = Mul(z, scale);
  const V squared = MulAdd(x, x, MulAdd(y, y, Mul(z, z)));
  const V inverse = Div(k(1.0), Sqrt(squared));
  const auto known = And(Gt(largest, k(kLeastVector)), Gt(squared, k(0.5)));
  out(first, IfThenElseZero(known, Mul(x, inverse)));
  out(first + 1, IfThenElseZero(known, Mul(y, inverse)));
  out(first + 2, IfThenElseZero(known, Mul(z, inverse)));
}

// Planes of the axes, and the first one of a channel's axis.
template <bool shared>
inline constexpr int kAxisPlanes = shared ? 3 : 9;
template <bool shared>
constexpr size_t AxisOf(size_t channel) {
  return shared ? 0 : 3 * channel;
}

// The axes of bands 1 of channels whose coefficients lie `stride` planes apart.
template <bool shared, size_t stride, class K, class In, class Out>
GAUNT_LANES void FindAxes(const K& k, const float* weights, const In& in, Out& axes) {
  using V = typename K::V;
  if constexpr (shared) {
    V x = k(0.0), y = k(0.0), z = k(0.0);
    for (size_t c = 0; c < 3; ++c) {
      const V weight = k(static_cast<double>(weights[c]));
      const auto f = in.From(c * stride);
      y = NegMulAdd(weight, f(1), y);
      z = MulAdd(weight, f(2), z);
      x = NegMulAdd(weight, f(3), x);
    }
    Unit(k, x, y, z, 0, axes);
  } else {
    for (size_t c = 0; c < 3; ++c) {
      const auto f = in.From(c * stride);
      Unit(k, Neg(f(3)), Neg(f(1)), f(2), 3 * c, axes);
    }
  }
}

// Band 1 along an axis.
template <class In, class Axes>
GAUNT_LANES auto Along(const In& f, const Axes& axes, size_t first) {
  const auto across = MulAdd(axes(first), f(3), Mul(axes(first + 1), f(1)));
  return MulSub(axes(first + 2), f(2), across);
}

// The zonal function of band 2 and norm 1 about an axis, y_2m / |y_2| there; 0 for no axis.
struct ZonalBand {
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& axes, size_t first, Out& out) const {
    using V = typename K::V;
    const V x = axes(first), y = axes(first + 1), z = axes(first + 2);
    const V root_x = Mul(k(kSqrt3), x), root_z = Mul(k(-kSqrt3), z);
    const V x2 = Mul(x, x), y2 = Mul(y, y);
    out(0, Mul(root_x, y));
    out(1, Mul(root_z, y));
    out(2, NegMulAdd(k(0.5), Add(x2, y2), Mul(z, z)));
    out(3, Mul(root_z, x));
    out(4, Mul(k(0.5 * kSqrt3), Sub(x2, y2)));
  }
};

template <class In, class Band>
GAUNT_LANES auto DotBand2(const In& f, const Band& band) {
  auto sum = Mul(band(0), f(4));
  for (size_t m = 1; m < 5; ++m) sum = MulAdd(band(m), f(4 + m), sum);
  return sum;
}

// k2 of order 3, and its axes where they are wanted.
template <bool shared>
struct Solve {
  template <class K, class In, class OutK2, class... OutAxes>
  GAUNT_LANES void operator()(const K& k, const In& in, const OutK2& k2,
                              const OutAxes&... axes) const {
    typename K::template Slots<kAxisPlanes<shared>> axis;
    typename K::template Slots<5> band;
    FindAxes<shared, 9>(k, kLuminance, in, axis);
    if constexpr (shared) ZonalBand()(k, axis, 0, band);
    for (size_t c = 0; c < 3; ++c) {
      if constexpr (!shared) ZonalBand()(k, axis, AxisOf<shared>(c), band);
      k2(c, DotBand2(in.From(9 * c), band));
    }
    for (size_t p = 0; p < kAxisPlanes<shared>; ++p) (axes(p, axis(p)), ...);
  }
};

// k2 = L_0 (linear r + quadratic r^2), r = |band 1 along the axis| / L_0 up to sqrt(3); 0 where
// that has no meaning, NaNs included.
template <bool shared>
struct Hallucinate {
  const float* weights;
  float linear;
  float quadratic;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& k2) const {
    using V = typename K::V;
    typename K::template Slots<kAxisPlanes<shared>> axis;
    FindAxes<shared, 4>(k, weights, in, axis);
    for (size_t c = 0; c < 3; ++c) {
      const auto f = in.From(4 * c);
      const V mean = f(0);
      const V along = Abs(Along(f, axis, AxisOf<shared>(c)));
      const V r = Min(Div(along, mean), k(kMaxRatio));
      const V slope = MulAdd(k(static_cast<double>(quadratic)), r, k(static_cast<double>(linear)));
      const auto lit = And(Gt(mean, k(0.0)), Gt(along, k(0.0)));
      k2(c, IfThenElseZero(lit, Mul(mean, Mul(r, slope))));
    }
  }
};

// Order 3 of order 2 and k2.
template <bool shared>
struct Expand {
  template <class K, class In, class InK2, class Out>
  GAUNT_LANES void operator()(const K& k, const In& sh2, const InK2& k2, const Out& sh3) const {
    using V = typename K::V;
    typename K::template Slots<kAxisPlanes<shared>> axis;
    typename K::template Slots<5> band;
    FindAxes<shared, 4>(k, kLuminance, sh2, axis);
    if constexpr (shared) ZonalBand()(k, axis, 0, band);
    for (size_t c = 0; c < 3; ++c) {
      if constexpr (!shared) ZonalBand()(k, axis, AxisOf<shared>(c), band);
      const auto from = sh2.From(4 * c);
      const auto to = sh3.From(9 * c);
      const V zonal = k2(c);
      for (size_t i = 0; i < 4; ++i) to(i, from(i));
      for (size_t m = 0; m < 5; ++m) to(4 + m, Mul(zonal, band(m)));
    }
  }
};

// E/pi as a polynomial of the normal, whose planes are the axes, and of each channel
//   constant, factors of x, y, z, factor of cos^2 to the axis.
template <bool shared>
inline constexpr int kPolynomialPlanes = kAxisPlanes<shared> + 15;

template <bool shared>
struct PreparePolynomial {
  template <class K, class In, class InK2, class Out>
  GAUNT_LANES void operator()(const K& k, const In& sh2, const InK2& k2, Out&& out) const {
    using V = typename K::V;
    using Linear = evaluate::QuadraticConstants<evaluate::IrradianceBands>;
    constexpr double kMean = Linear::kMean, kLinear = Linear::kLinear;
    typename K::template Slots<kAxisPlanes<shared>> axis;
    FindAxes<shared, 4>(k, kLuminance, sh2, axis);
    for (size_t p = 0; p < kAxisPlanes<shared>; ++p) out(p, axis(p));
    for (size_t c = 0; c < 3; ++c) {
      const size_t a = AxisOf<shared>(c), p = kAxisPlanes<shared> + 5 * c;
      const V x = axis(a), y = axis(a + 1), z = axis(a + 2);
      const V squared = MulAdd(x, x, MulAdd(y, y, Mul(z, z)));
      const V zonal = IfThenElseZero(Gt(squared, k(0.5)), Mul(k(kZonal), k2(c)));
      const auto f = sh2.From(4 * c);
      out(p, MulSub(k(kMean), f(0), zonal));
      out(p + 1, Mul(k(-kLinear), f(3)));
      out(p + 2, Mul(k(-kLinear), f(1)));
      out(p + 3, Mul(k(kLinear), f(2)));
      out(p + 4, Mul(k(3.0), zonal));
    }
  }
};

template <bool shared>
struct EvaluatePolynomial {
  template <class K, class In, class InN, class Out>
  GAUNT_LANES void operator()(const K&, const In& in, const InN& normal, const Out& out) const {
    using V = typename K::V;
    const V x = normal(0), y = normal(1), z = normal(2);
    V square = x;
    for (size_t c = 0; c < 3; ++c) {
      const size_t a = AxisOf<shared>(c), p = kAxisPlanes<shared> + 5 * c;
      if (!shared || c == 0) {
        const V cosine = MulAdd(in(a), x, MulAdd(in(a + 1), y, Mul(in(a + 2), z)));
        square = Mul(cosine, cosine);
      }
      V sum = MulAdd(in(p + 1), x, in(p));
      sum = MulAdd(in(p + 2), y, sum);
      sum = MulAdd(in(p + 3), z, sum);
      out(c, MulAdd(in(p + 4), square, sum));
    }
  }
};

template <bool shared>
struct Irradiance {
  template <class K, class In, class InK2, class InN, class Out>
  GAUNT_LANES void operator()(const K& k, const In& sh2, const InK2& k2, const InN& normal,
                              const Out& out) const {
    typename K::template Slots<kPolynomialPlanes<shared>> polynomial;
    PreparePolynomial<shared>()(k, sh2, k2, polynomial);
    EvaluatePolynomial<shared>()(k, polynomial, normal, out);
  }
};

// Geomerics' E/pi = base + peak q^p with q = (1 + cos) / 2 to the channel's axis. Planes: the axes,
// and of each channel base, peak, p.
inline constexpr int kLobePlanes = 9 + 9;

struct PrepareLobe {
  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& sh2, Out&& out) const {
    using V = typename K::V;
    constexpr double kMean = light::kY0;
    typename K::template Slots<9> axis;
    FindAxes<false, 4>(k, kLuminance, sh2, axis);
    for (size_t p = 0; p < 9; ++p) out(p, axis(p));
    for (size_t c = 0; c < 3; ++c) {
      const auto f = sh2.From(4 * c);
      const V length = Along(f, axis, 3 * c);
      // s = |R1| / R0 <= 1 of the mean radiance R0 = L_0 y_0 and R1 = y_0 band 1 / sqrt(3).
      const V ratio = Min(Div(length, Mul(k(kSqrt3), f(0))), k(1.0));
      const V s = IfThenElseZero(Gt(length, k(0.0)), ratio);
      const V mean = IfThenElseZero(Gt(f(0), k(0.0)), Mul(k(kMean), f(0)));
      out(9 + 3 * c, Mul(mean, Div(Sub(k(1.0), s), Add(k(1.0), s))));
      out(10 + 3 * c, Mul(k(4.0), Mul(mean, s)));
      out(11 + 3 * c, MulAdd(k(2.0), s, k(1.0)));
    }
  }
};

struct EvaluateLobe {
  template <class K, class In, class InN, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const InN& normal, const Out& out) const {
    using V = typename K::V;
    const V x = normal(0), y = normal(1), z = normal(2);
    for (size_t c = 0; c < 3; ++c) {
      const size_t a = 3 * c, p = 9 + 3 * c;
      const V cosine = MulAdd(in(a), x, MulAdd(in(a + 1), y, Mul(in(a + 2), z)));
      const V q = Min(Max(MulAdd(k(0.5), cosine, k(0.5)), k(0.0)), k(1.0));
      out(c, MulAdd(in(p + 1), Power(k, q, in(p + 2)), in(p)));
    }
  }
};

struct Geomerics {
  template <class K, class In, class InN, class Out>
  GAUNT_LANES void operator()(const K& k, const In& sh2, const InN& normal, const Out& out) const {
    typename K::template Slots<kLobePlanes> lobe;
    PrepareLobe()(k, sh2, lobe);
    EvaluateLobe()(k, lobe, normal, out);
  }
};

// The refit turns the axis to the n that leaves the least error of irradiance. For a given n the
// best band 1 and k2 are known, and what is left to do is to maximise the gain
//   (p n)^2 + sum over channels of (n Q n)^2,
// with p the weighted sum of bands 1 and Q band 2 as a quadratic form, both scaled. It is even in
// n, which stays in the upper half. Slots: p, then of each channel the xx, yy, xy, yz, xz of Q.
template <int channels>
inline constexpr int kProblemPlanes = 3 + 5 * channels;

// What the entries of a symmetric Q without trace are multiplied by in a Q b.
template <class V, class Out>
GAUNT_LANES void Pair(V ax, V ay, V az, V bx, V by, V bz, Out& out) {
  const V zz = Mul(az, bz);
  out(0, MulSub(ax, bx, zz));
  out(1, MulSub(ay, by, zz));
  out(2, MulAdd(ax, by, Mul(ay, bx)));
  out(3, MulAdd(ay, bz, Mul(az, by)));
  out(4, MulAdd(ax, bz, Mul(az, bx)));
}

template <class Problem, class Pair>
GAUNT_LANES auto Form(const Problem& problem, size_t first, const Pair& pair) {
  auto sum = Mul(problem(first), pair(0));
  for (size_t i = 1; i < 5; ++i) sum = MulAdd(problem(first + i), pair(i), sum);
  return sum;
}

template <class Problem, class V>
GAUNT_LANES V DotMean(const Problem& problem, V x, V y, V z) {
  return MulAdd(problem(0), x, MulAdd(problem(1), y, Mul(problem(2), z)));
}

template <int channels>
struct Climb {
  // The gain, less what it costs to keep kLeastAlong of band 1 along the axis.
  template <class K, class Problem, class V>
  static GAUNT_LANES V Gain(const K& k, const Problem& problem, V x, V y, V z) {
    typename K::template Slots<5> nn;
    Pair(x, y, z, x, y, z, nn);
    const V d = DotMean(problem, x, y, z);
    const V missing = Max(Sub(k(kLeastAlong), Abs(d)), k(0.0));
    V gain = MulSub(d, d, Mul(missing, missing));
    for (size_t q = 3; q < kProblemPlanes<channels>; q += 5) {
      const V form = Form(problem, q, nn);
      gain = MulAdd(form, form, gain);
    }
    return gain;
  }

  // Newton's steps on the sphere, in the plane of u and v across n. Where the curvature is not that
  // of a maximum, it is shifted until it is; a step that gains nothing is not taken, and the next
  // one is shorter.
  template <class K, class Problem, class V>
  static GAUNT_LANES V Run(const K& k, const Problem& problem, int steps, V& x, V& y, V& z) {
    typename K::template Slots<5> nn, un, vn, uu, uv, vv;
    V gain = Gain(k, problem, x, y, z);
    V most = k(0.5);  // length of a step
    for (; steps > 0; --steps) {
      const V a = Div(k(-1.0), Add(k(1.0), z));
      const V ux = MulAdd(Mul(x, x), a, k(1.0)), uy = Mul(Mul(x, y), a), uz = Neg(x);
      const V vx = uy, vy = MulAdd(Mul(y, y), a, k(1.0)), vz = Neg(y);
      Pair(x, y, z, x, y, z, nn);
      Pair(ux, uy, uz, x, y, z, un);
      Pair(vx, vy, vz, x, y, z, vn);
      Pair(ux, uy, uz, ux, uy, uz, uu);
      Pair(ux, uy, uz, vx, vy, vz, uv);
      Pair(vx, vy, vz, vx, vy, vz, vv);

      // Half of the gradient and of the Hessian.
      const V d = DotMean(problem, x, y, z);
      const V du = DotMean(problem, ux, uy, uz), dv = DotMean(problem, vx, vy, vz);
      V gu = Mul(d, du), gv = Mul(d, dv);
      V huu = MulSub(du, du, Mul(d, d)), hvv = MulSub(dv, dv, Mul(d, d)), huv = Mul(du, dv);
      for (size_t q = 3; q < kProblemPlanes<channels>; q += 5) {
        const V fnn = Form(problem, q, nn);
        const V twice = Add(fnn, fnn);
        const V fun = Form(problem, q, un), fvn = Form(problem, q, vn);
        const V four_u = Mul(k(4.0), fun), four_v = Mul(k(4.0), fvn);
        gu = MulAdd(twice, fun, gu);
        gv = MulAdd(twice, fvn, gv);
        huu = MulAdd(four_u, fun, MulAdd(twice, Sub(Form(problem, q, uu), fnn), huu));
        hvv = MulAdd(four_v, fvn, MulAdd(twice, Sub(Form(problem, q, vv), fnn), hvv));
        huv = MulAdd(four_u, fvn, MulAdd(twice, Form(problem, q, uv), huv));
      }

      // Eigenvalues of the Hessian are middle +- radius; the shift leaves both clearly negative.
      const V middle = Mul(k(0.5), Add(huu, hvv)), half = Mul(k(0.5), Sub(huu, hvv));
      const V radius = Sqrt(MulAdd(half, half, Mul(huv, huv)));
      const V margin = Mul(k(0.05), Add(Abs(middle), radius));
      const V shift = Max(Add(Add(middle, radius), margin), k(0.0));
      const V suu = Sub(huu, shift), svv = Sub(hvv, shift);
      const V inverse = Div(k(1.0), MulSub(suu, svv, Mul(huv, huv)));
      V su = Mul(MulSub(huv, gv, Mul(svv, gu)), inverse);
      V sv = Mul(MulSub(huv, gu, Mul(suu, gv)), inverse);
      const V length = Sqrt(MulAdd(su, su, Mul(sv, sv)));
      const V shorter = Min(Div(most, length), k(1.0));
      su = Mul(su, shorter);
      sv = Mul(sv, shorter);

      V nx = MulAdd(su, ux, MulAdd(sv, vx, x));
      V ny = MulAdd(su, uy, MulAdd(sv, vy, y));
      V nz = MulAdd(su, uz, MulAdd(sv, vz, z));
      const V norm = Div(k(1.0), Sqrt(MulAdd(nx, nx, MulAdd(ny, ny, Mul(nz, nz)))));
      const V up = IfThenElse(Lt(nz, k(0.0)), Neg(norm), norm);
      nx = Mul(nx, up);
      ny = Mul(ny, up);
      nz = Mul(nz, up);
      const V next = Gain(k, problem, nx, ny, nz);
      const auto better = Gt(next, gain);
      x = IfThenElse(better, nx, x);
      y = IfThenElse(better, ny, y);
      z = IfThenElse(better, nz, z);
      gain = IfThenElse(better, next, gain);
      most = IfThenElse(better, most, Mul(k(0.25), Min(length, most)));
    }
    return gain;
  }
};

// Bands 0 and 1 and k2 of the channels that share an axis.
template <int channels>
struct RefitAxis {
  static constexpr bool kShared = channels > 1;
  static constexpr double kNorm2 = kShared ? light::kLuminance[0] * light::kLuminance[0] +
                                                 light::kLuminance[1] * light::kLuminance[1] +
                                                 light::kLuminance[2] * light::kLuminance[2]
                                           : 1.0;
  static constexpr double kNorm = ConstexprSqrt(kNorm2);
  static constexpr double Weight(size_t c) { return kShared ? light::kLuminance[c] : 1.0; }

  template <class K, class In, class Out, class OutK2>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& sh2, const OutK2& k2) const {
    using V = typename K::V;
    typename K::template Slots<kProblemPlanes<channels>> problem;
    typename K::template Slots<3> start;
    V px = k(0.0), py = k(0.0), pz = k(0.0), size = k(0.0);
    for (size_t c = 0; c < channels; ++c) {
      const auto f = in.From(9 * c);
      const V weight = k(Weight(c));
      py = NegMulAdd(weight, f(1), py);
      pz = MulAdd(weight, f(2), pz);
      px = NegMulAdd(weight, f(3), px);
      const V linear = Max(Max(Abs(f(1)), Abs(f(2))), Abs(f(3)));
      V square = Abs(f(4));
      for (size_t i = 5; i < 9; ++i) square = Max(square, Abs(f(i)));
      size = Max(size, Max(Mul(k(kBand1), linear), Mul(k(kBand2), square)));
    }
    const V scale = Div(k(1.0), size);
    const V scale1 = Mul(k(kBand1 / kNorm), scale), scale2 = Mul(k(0.5 * kBand2 * kSqrt3), scale);
    problem(0, Mul(px, scale1));
    problem(1, Mul(py, scale1));
    problem(2, Mul(pz, scale1));
    for (size_t c = 0; c < channels; ++c) {
      const auto f = in.From(9 * c);
      const V zz = Mul(Mul(k(1.0 / kSqrt3), scale2), f(6)), difference = Mul(scale2, f(8));
      problem(3 + 5 * c, Sub(difference, zz));
      problem(4 + 5 * c, Neg(Add(difference, zz)));
      problem(5 + 5 * c, Mul(scale2, f(4)));
      problem(6 + 5 * c, Neg(Mul(scale2, f(5))));
      problem(7 + 5 * c, Neg(Mul(scale2, f(7))));
    }

    // From the axis that there is, or the best of what is reached from all around, further on.
    Unit(k, problem(0), problem(1), problem(2), 0, start);
    const auto down = Lt(start(2), k(0.0));
    V x = IfThenElse(down, Neg(start(0)), start(0));
    V y = IfThenElse(down, Neg(start(1)), start(1));
    V z = Abs(start(2));
    V gain = Climb<channels>::Gain(k, problem, x, y, z);
    for (int i = 0; i <= kStarts; ++i) {
      V nx = x, ny = y, nz = z;
      int steps = kLastSteps;
      if (i < kStarts) {
        steps = kFirstSteps;
        nx = k(static_cast<double>(kStart[i][0]));
        ny = k(static_cast<double>(kStart[i][1]));
        nz = k(static_cast<double>(kStart[i][2]));
      }
      const V reached = Climb<channels>::Run(k, problem, steps, nx, ny, nz);
      const auto better = Gt(reached, gain);
      x = IfThenElse(better, nx, x);
      y = IfThenElse(better, ny, y);
      z = IfThenElse(better, nz, z);
      gain = IfThenElse(better, reached, gain);
    }

    const auto known = And(Gt(size, k(kLeastVector)), Gt(gain, k(-1.0)));
    const V d = MulAdd(px, x, MulAdd(py, y, Mul(pz, z)));
    const V least = Mul(k(kLeastAlong * kNorm / kBand1), size);
    const V enough = Max(Abs(d), least);
    const V along = IfThenElse(Lt(d, k(0.0)), Neg(enough), enough);
    const V tx = Mul(along, x), ty = Mul(along, y), tz = Mul(along, z);
    start(0, x);
    start(1, y);
    start(2, z);
    typename K::template Slots<5> band;
    ZonalBand()(k, start, 0, band);
    for (size_t c = 0; c < channels; ++c) {
      const auto f = in.From(9 * c);
      const auto to = sh2.From(4 * c);
      const V zonal = DotBand2(f, band);
      const V mean = f(0), f1 = f(1), f2 = f(2), f3 = f(3);
      to(0, mean);
      if constexpr (kShared) {
        const V share = k(Weight(c) / kNorm2);
        to(1, IfThenElse(known, MulAdd(share, Sub(py, ty), f1), f1));
        to(2, IfThenElse(known, NegMulAdd(share, Sub(pz, tz), f2), f2));
        to(3, IfThenElse(known, MulAdd(share, Sub(px, tx), f3), f3));
      } else {
        to(1, IfThenElse(known, Neg(ty), f1));
        to(2, IfThenElse(known, tz, f2));
        to(3, IfThenElse(known, Neg(tx), f3));
      }
      k2(c, IfThenElseZero(known, zonal));
    }
  }
};

template <bool shared>
struct Refit {
  template <class K, class In, class Out, class OutK2>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& sh2, const OutK2& k2) const {
    if constexpr (shared) {
      RefitAxis<3>()(k, in, sh2, k2);
    } else {
      for (size_t c = 0; c < 3; ++c) {
        RefitAxis<1>()(k, in.From(9 * c), sh2.From(4 * c), k2.From(c));
      }
    }
  }
};

}  // namespace gaunt::zh3::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_ZH3_ZH3_INL_H_
