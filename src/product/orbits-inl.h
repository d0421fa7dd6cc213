// SPDX-License-Identifier: MIT
// Rows of a grid multiplied point by point, orbit by orbit.
#if defined(GAUNT_PRODUCT_ORBITS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PRODUCT_ORBITS_INL_H_
#undef GAUNT_PRODUCT_ORBITS_INL_H_
#else
#define GAUNT_PRODUCT_ORBITS_INL_H_
#endif

#include <utility>

#include "product/grid.h"
#include "product/transform-inl.h"
#include "simd/lanes-inl.h"
#include "simd/order.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::product::HWY_NAMESPACE {

// The four parts of the values of a row, each at points 0 .. M/4.
enum Part { kEvenCosines, kOddCosines, kEvenSines, kOddSines, kParts };

constexpr int PartIndex(int M, Part part, int j) { return part * (M / 4 + 1) + j; }

// The parts of a row of degree L from its coefficients, row(m) of cosines, row(L + m) of sines, and
// back. Odd parts lack factors.
template <int M, int L, bool kFuse>
struct Row {
  static_assert(2 * L < M && (L >= 2 || M == 4), "orders that alias, or no sines");
  using EvenCosines = Waves<Wave::kCosine, M / 2, L / 2, kFuse>;
  using OddCosines = OddWaves<Wave::kCosine, M, L, kFuse, M>;
  using EvenSines = Waves<Wave::kSine, M / 2, L / 2, kFuse>;
  using OddSines = OddWaves<Wave::kSine, M, L, kFuse, M>;

  static constexpr double Factor(Part part, int j) {
    return part == kOddCosines ? OddCosines::Factor(j)
           : part == kOddSines ? OddSines::Factor(j)
                               : 1.0;
  }

  template <class K, class S, class To>
  static GAUNT_LANES void Forward(const K& k, const S& row, To& parts) {
    EvenCosines::Forward(k, Every<2>(row, 0), PartOf<kEvenCosines>(parts));
    OddCosines::Forward(k, Every<1>(row, 0), PartOf<kOddCosines>(parts));
    if constexpr (M > 4) EvenSines::Forward(k, Every<2>(row, L), PartOf<kEvenSines>(parts));
    OddSines::Forward(k, Every<1>(row, L), PartOf<kOddSines>(parts));
  }

  template <class K, class From, class S>
  static GAUNT_LANES void Backward(const K& k, const From& parts, S& row) {
    EvenCosines::Backward(k, PartOf<kEvenCosines>(parts), Every<2>(row, 0));
    OddCosines::Backward(k, PartOf<kOddCosines>(parts), Every<1>(row, 0));
    if constexpr (M > 4) EvenSines::Backward(k, PartOf<kEvenSines>(parts), Every<2>(row, L));
    OddSines::Backward(k, PartOf<kOddSines>(parts), Every<1>(row, L));
  }

 private:
  template <Part part, class S>
  static GAUNT_LANES auto PartOf(S& parts) {
    return Every<1>(parts, PartIndex(M, part, 0));
  }
};

// What is multiplied at each orbit: two values at points 0 and M/4, four between them; as many as
// there are points. With Level::kPoints these are the values at the points.
constexpr int ValueIndex(int j, int i) { return j == 0 ? i : 4 * j - 2 + i; }

template <Level level>
inline constexpr bool kFuses = level != Level::kPoints;

// The values of a row of degree L from its parts.
template <int M, int L, Level level>
struct OrbitValues {
  using R = Row<M, L, kFuses<level>>;
  using B = Butterfly<kFuses<level>>;

  template <class K, class S, class To>
  static GAUNT_LANES void FromParts(const K& k, const S& parts, To& values) {
    Two<kOddCosines, 0>(k, parts, values);
    Fours(k, parts, values, std::make_integer_sequence<int, M / 4 - 1>());
    Two<kOddSines, M / 4>(k, parts, values);
  }

 private:
  // A part with its factor.
  template <Part part, int j, class K, class S>
  static GAUNT_LANES typename K::V Whole(const K& k, const S& parts) {
    constexpr double kFactor = R::Factor(part, j);
    return B::template Whole<kFactor == 1.0>(k, kFactor, parts(PartIndex(M, part, j)));
  }
  template <Part first, Part second, int j, class K, class S>
  static GAUNT_LANES void SumAndDifference(const K& k, const S& parts, typename K::V& sum,
                                           typename K::V& difference) {
    constexpr double kFirst = R::Factor(first, j), kSecond = R::Factor(second, j);
    B::template Both<kFirst == 1.0, kSecond == 1.0>(k, kFirst, parts(PartIndex(M, first, j)),
                                                    kSecond, parts(PartIndex(M, second, j)), sum,
                                                    difference);
  }

  template <Part odd, int j, class K, class S, class To>
  static GAUNT_LANES void Two(const K& k, const S& parts, To& values) {
    typename K::V a, b;
    if constexpr (level == Level::kAll) {
      a = Whole<kEvenCosines, j>(k, parts);
      b = Whole<odd, j>(k, parts);
    } else {
      SumAndDifference<kEvenCosines, odd, j>(k, parts, a, b);
    }
    values(ValueIndex(j, 0), a);
    values(ValueIndex(j, 1), b);
  }
  template <class K, class S, class To, int... j>
  static GAUNT_LANES void Fours(const K& k, const S& parts, To& values,
                                std::integer_sequence<int, j...>) {
    (Four<j + 1>(k, parts, values), ...);
  }
  template <int j, class K, class S, class To>
  static GAUNT_LANES void Four(const K& k, const S& parts, To& values) {
    typename K::V a, b, c, d;
    if constexpr (level == Level::kAll || level == Level::kQuarters) {
      a = Whole<kEvenCosines, j>(k, parts);
      b = Whole<kOddCosines, j>(k, parts);
      c = Whole<kEvenSines, j>(k, parts);
      d = Whole<kOddSines, j>(k, parts);
    } else {  // cosines and sines at phi, and at pi - phi
      SumAndDifference<kEvenCosines, kOddCosines, j>(k, parts, a, c);
      SumAndDifference<kEvenSines, kOddSines, j>(k, parts, b, d);
      if constexpr (level == Level::kPoints) {
        Join(a, b);
        Join(c, d);
      }
    }
    values(ValueIndex(j, 0), a);
    values(ValueIndex(j, 1), b);
    values(ValueIndex(j, 2), c);
    values(ValueIndex(j, 3), d);
  }
  template <class V>
  static GAUNT_LANES void Join(V& a, V& b) {
    const V sum = Add(a, b);
    b = Sub(a, b);
    a = sum;
  }
};

// The parts of a product from the values of both factors, which may be the same. With `level`, two
// points count once where the four of an orbit have something left out.
template <int M, Level level, bool kSame>
struct MultiplyOrbits {
  template <class K, class A, class B, class S>
  static GAUNT_LANES void All(const K& k, const A& a, const B& b, S& parts) {
    Two<kOddCosines, 0>(k, a, b, parts);
    Fours(k, a, b, parts, std::make_integer_sequence<int, M / 4 - 1>());
    Two<kOddSines, M / 4>(k, a, b, parts);
  }

 private:
  template <Part odd, int j, class K, class A, class B, class S>
  static GAUNT_LANES void Two(const K& k, const A& a, const B& b, S& parts) {
    using V = typename K::V;
    const V a0 = a(ValueIndex(j, 0)), a1 = a(ValueIndex(j, 1));
    const V b0 = b(ValueIndex(j, 0)), b1 = b(ValueIndex(j, 1));
    V even, other;
    if constexpr (level == Level::kAll && kSame) {
      even = Mul(k(0.5), MulAdd(a1, a1, Mul(a0, a0)));
      other = Mul(a0, a1);
    } else if constexpr (level == Level::kAll) {
      const V half0 = Mul(k(0.5), a0), half1 = Mul(k(0.5), a1);
      even = MulAdd(half1, b1, Mul(half0, b0));
      other = MulAdd(half1, b0, Mul(half0, b1));
    } else {
      const V x = Mul(a0, b0), y = Mul(a1, b1);
      even = Add(x, y);
      other = Sub(x, y);
      if constexpr (level != Level::kPoints) {
        const V share = k(level == Level::kHalves ? 0.5 : 0.25);
        even = Mul(share, even);
        other = Mul(share, other);
      }
    }
    parts(PartIndex(M, kEvenCosines, j), even);
    parts(PartIndex(M, odd, j), other);
  }

  template <class K, class A, class B, class S, int... j>
  static GAUNT_LANES void Fours(const K& k, const A& a, const B& b, S& parts,
                                std::integer_sequence<int, j...>) {
    (Four<j + 1>(k, a, b, parts), ...);
  }
  template <int j, class K, class A, class B, class S>
  static GAUNT_LANES void Four(const K&, const A& a, const B& b, S& parts) {
    using V = typename K::V;
    const V a0 = a(ValueIndex(j, 0)), a1 = a(ValueIndex(j, 1));
    const V a2 = a(ValueIndex(j, 2)), a3 = a(ValueIndex(j, 3));
    const V b0 = b(ValueIndex(j, 0)), b1 = b(ValueIndex(j, 1));
    const V b2 = b(ValueIndex(j, 2)), b3 = b(ValueIndex(j, 3));
    V even_cosines, odd_cosines, even_sines, odd_sines;
    if constexpr (level == Level::kAll || level == Level::kQuarters) {
      // Parts multiply as the group of their two signs does.
      if constexpr (kSame) {
        const V twice0 = Add(a0, a0), twice1 = Add(a1, a1), twice2 = Add(a2, a2);
        even_cosines = MulAdd(a3, a3, MulAdd(a2, a2, MulAdd(a1, a1, Mul(a0, a0))));
        odd_cosines = MulAdd(twice2, a3, Mul(twice0, a1));
        even_sines = MulAdd(twice1, a3, Mul(twice0, a2));
        odd_sines = MulAdd(twice1, a2, Mul(twice0, a3));
      } else {
        even_cosines = MulAdd(a3, b3, MulAdd(a2, b2, MulAdd(a1, b1, Mul(a0, b0))));
        odd_cosines = MulAdd(a3, b2, MulAdd(a2, b3, MulAdd(a1, b0, Mul(a0, b1))));
        even_sines = MulAdd(a3, b1, MulAdd(a1, b3, MulAdd(a2, b0, Mul(a0, b2))));
        odd_sines = MulAdd(a2, b1, MulAdd(a1, b2, MulAdd(a3, b0, Mul(a0, b3))));
      }
    } else {
      V cosines, sines, cosines2, sines2;
      Half(a0, a1, b0, b1, cosines, sines);
      Half(a2, a3, b2, b3, cosines2, sines2);
      even_cosines = Add(cosines, cosines2);
      odd_cosines = Sub(cosines, cosines2);
      even_sines = Add(sines, sines2);
      odd_sines = Sub(sines, sines2);
    }
    parts(PartIndex(M, kEvenCosines, j), even_cosines);
    parts(PartIndex(M, kOddCosines, j), odd_cosines);
    parts(PartIndex(M, kEvenSines, j), even_sines);
    parts(PartIndex(M, kOddSines, j), odd_sines);
  }

  // The products at phi and -phi.
  template <class V>
  static GAUNT_LANES void Half(V a0, V a1, V b0, V b1, V& cosines, V& sines) {
    if constexpr (level == Level::kHalves && kSame) {
      cosines = MulAdd(a1, a1, Mul(a0, a0));
      sines = Mul(Add(a0, a0), a1);
    } else if constexpr (level == Level::kHalves) {
      cosines = MulAdd(a1, b1, Mul(a0, b0));
      sines = MulAdd(a1, b0, Mul(a0, b1));
    } else {
      const V x = Mul(a0, b0), y = Mul(a1, b1);
      cosines = Add(x, y);
      sines = Sub(x, y);
    }
  }
};

template <int M, int L, Level level, class K, class S, class To>
GAUNT_LANES void ValuesOfRow(const K& k, const S& row, To& values) {
  typename K::template Slots<kParts*(M / 4 + 1)> parts;
  Row<M, L, kFuses<level>>::Forward(k, row, parts);
  OrbitValues<M, L, level>::FromParts(k, parts, values);
}

template <int M, int L, Level level, bool kSame, class K, class A, class B, class S>
GAUNT_LANES void RowOfProduct(const K& k, const A& a, const B& b, const S& row) {
  typename K::template Slots<kParts*(M / 4 + 1)> parts;
  MultiplyOrbits<M, level, kSame>::All(k, a, b, parts);
  Row<M, L, kFuses<level>>::Backward(k, parts, row);
}

}  // namespace gaunt::product::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PRODUCT_ORBITS_INL_H_
