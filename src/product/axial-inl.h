// SPDX-License-Identifier: MIT
// Kernels of products with functions that are symmetric about z: for each m, one symmetric matrix
// that is the same for m and -m. That of a zonal function is made from it, others are constants.
// Each m is read before it is written, so that outputs of the same order may be in place.
#if defined(GAUNT_PRODUCT_AXIAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PRODUCT_AXIAL_INL_H_
#undef GAUNT_PRODUCT_AXIAL_INL_H_
#else
#define GAUNT_PRODUCT_AXIAL_INL_H_
#endif

#include <algorithm>
#include <utility>

#include "product/axial_constants.h"
#include "product/product.h"
#include "simd/lanes-inl.h"
#include "simd/order.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::product::axial::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Zonal functions have a kernel for each order up to this, of all factors; others share one.
inline constexpr int kMaxZonalOrder = 8;

// The coefficients +m and -m of order n, times a matrix: Entries gives its elements, and has
// IsZero(l1, l2, m) for those that vanish.
template <int n, int m, class Entries>
struct MultiplyColumn {
  template <class In, class Out>
  GAUNT_LANES void operator()(const Entries& entries, const In& in, const Out& out) const {
    Side<1>(entries, in, out, Bands());
    if constexpr (m != 0) Side<-1>(entries, in, out, Bands());
  }

 private:
  using Bands = std::make_integer_sequence<int, n - m>;

  template <int side, class In, class Out, int... i>
  static GAUNT_LANES void Side(const Entries& entries, const In& in, const Out& out,
                               std::integer_sequence<int, i...>) {
    Write<side>(out, std::integer_sequence<int, i...>(),
                Row<side, m + i, LastOf(m + i, n - 1)>(entries, in)...);
  }

  template <int side, class Out, class... V, int... i>
  static GAUNT_LANES void Write(const Out& out, std::integer_sequence<int, i...>, V... rows) {
    (out(CoefficientIndex(m + i, side * m), rows), ...);
  }

  // The last band, up to l, that row l1 has an entry for; m - 1 if there is none.
  static constexpr int LastOf(int l1, int l) {
    while (l >= m && Entries::IsZero(l1, l, m)) --l;
    return l;
  }

  template <int side, int l1, int l2, class In>
  static GAUNT_LANES auto Row(const Entries& entries, const In& in) {
    constexpr int kBefore = LastOf(l1, l2 - 1);
    const auto entry = entries.template At<l1, l2, m>();
    const auto coefficient = in(CoefficientIndex(l2, side * m));
    if constexpr (kBefore < m) {
      return Mul(entry, coefficient);
    } else {
      return MulAdd(entry, coefficient, Row<side, l1, kBefore>(entries, in));
    }
  }
};

// A zonal function of order n, in slots: its constant band times kConstant, the others, and the
// products of them that entries share.
template <class K, int n>
class ZonalFactors {
 public:
  template <class Zonal>
  GAUNT_LANES ZonalFactors(const K& k, const Zonal& zonal) {
    band_(0, Mul(k(kConstant), zonal(0)));
    Copy(zonal, std::make_integer_sequence<int, n - 1>());
    Multiply(k, std::make_integer_sequence<int, kShared.count>());
  }

  GAUNT_LANES typename K::V Constant() const { return band_(0); }
  // Entry times band l, alone and added to a sum.
  template <int l, int low, int high, int m>
  GAUNT_LANES typename K::V Term(const K& k) const {
    constexpr double kEntry = ZonalEntry(l, low, high, m);
    constexpr int kIndex = kShared.Find(l, kEntry);
    if constexpr (kIndex < 0) {
      return Mul(k(kEntry), band_(l));
    } else if constexpr (kEntry > 0.0) {
      return product_(kIndex);
    } else {
      return Neg(product_(kIndex));
    }
  }
  template <int l, int low, int high, int m>
  GAUNT_LANES typename K::V AddTerm(const K& k, typename K::V sum) const {
    constexpr double kEntry = ZonalEntry(l, low, high, m);
    constexpr int kIndex = kShared.Find(l, kEntry);
    if constexpr (kIndex < 0) {
      return MulAdd(k(kEntry), band_(l), sum);
    } else if constexpr (kEntry > 0.0) {
      return Add(sum, product_(kIndex));
    } else {
      return Sub(sum, product_(kIndex));
    }
  }

 private:
  static constexpr const SharedProducts<n>& kShared = kSharedProducts<n>;

  template <class Zonal, int... i>
  GAUNT_LANES void Copy(const Zonal& zonal, std::integer_sequence<int, i...>) {
    (band_(i + 1, zonal(i + 1)), ...);
  }
  template <int... i>
  GAUNT_LANES void Multiply(const K& k, std::integer_sequence<int, i...>) {
    (product_(i, Mul(k(kShared.factor[i]), band_(kShared.band[i]))), ...);
  }

  typename K::template Slots<n> band_;
  typename K::template Slots<kShared.count + 1> product_;
};

// The entries of one m that a zonal function gives, in slots.
template <class K, int n, int m>
class ZonalEntries {
 public:
  GAUNT_LANES ZonalEntries(const K& k, const ZonalFactors<K, n>& zonal) {
    SetAll(k, zonal, std::make_integer_sequence<int, Index(n, m)>());
  }

  static constexpr bool IsZero(int, int, int) { return false; }
  template <int l1, int l2, int>
  GAUNT_LANES typename K::V At() const {
    return entry_(l1 > l2 ? Index(l1, l2) : Index(l2, l1));
  }

 private:
  static constexpr int Index(int high, int low) {
    return (high - m) * (high - m + 1) / 2 + low - m;
  }
  static constexpr int HighOf(int index) {
    int high = m;
    while (Index(high + 1, m) <= index) ++high;
    return high;
  }

  template <int... i>
  GAUNT_LANES void SetAll(const K& k, const ZonalFactors<K, n>& zonal,
                          std::integer_sequence<int, i...>) {
    (Set<HighOf(i), i - Index(HighOf(i), m) + m>(k, zonal), ...);
  }

  template <int high, int low>
  GAUNT_LANES void Set(const K& k, const ZonalFactors<K, n>& zonal) {
    constexpr int kLast = n - 1 - (n - 1 + high + low) % 2;
    entry_(Index(high, low), Sum<high, low, std::min(kLast, high + low)>(k, zonal));
  }

  // Of the bands of the zonal function from `last` down by twos.
  template <int high, int low, int last>
  static GAUNT_LANES typename K::V Sum(const K& k, const ZonalFactors<K, n>& zonal) {
    if constexpr (last == 0) {
      return zonal.Constant();
    } else if constexpr (last == high - low) {
      return zonal.template Term<last, low, high, m>(k);
    } else if constexpr (ZonalEntry(last, low, high, m) == 0.0) {
      return Sum<high, low, last - 2>(k, zonal);
    } else {
      return zonal.template AddTerm<last, low, high, m>(k, Sum<high, low, last - 2>(k, zonal));
    }
  }

  typename K::template Slots<Index(n, m)> entry_;
};

// Zonal functions times functions, all of order n.
template <int n>
struct MultiplyByZonal {
  size_t channels;

  template <class K, class Zonal, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const Zonal& zonal, const In& in, const Out& out) const {
    for (size_t c = 0; c < channels; ++c) {
      Columns(k, ZonalFactors<K, n>(k, zonal.From(c * n)), in.From(c * kPlanes),
              out.From(c * kPlanes), std::make_integer_sequence<int, n>());
    }
  }

 private:
  static constexpr size_t kPlanes = NumCoefficients(n);

  template <class K, class In, class Out, int... m>
  static GAUNT_LANES void Columns(const K& k, const ZonalFactors<K, n>& zonal, const In& in,
                                  const Out& out, std::integer_sequence<int, m...>) {
    (MultiplyColumn<n, m, ZonalEntries<K, n, m>>()(ZonalEntries<K, n, m>(k, zonal), in, out), ...);
  }
};

template <class K, class Matrix>
struct FixedEntries {
  const K& k;
  static constexpr bool IsZero(int l1, int l2, int m) { return Matrix::Entry(l1, l2, m) == 0.0; }
  template <int l1, int l2, int m>
  GAUNT_LANES typename K::V At() const {
    constexpr double kEntry = Matrix::Entry(l1, l2, m);
    return k(kEntry);
  }
};

// A fixed function times functions of order n.
template <class Matrix, int n>
struct MultiplyByFixed {
  size_t channels;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& out) const {
    for (size_t c = 0; c < channels; ++c) {
      Columns(FixedEntries<K, Matrix>{k}, in.From(c * kPlanes), out.From(c * kPlanes),
              std::make_integer_sequence<int, n>());
    }
  }

 private:
  static constexpr size_t kPlanes = NumCoefficients(n);

  template <class Entries, class In, class Out, int... m>
  static GAUNT_LANES void Columns(const Entries& entries, const In& in, const Out& out,
                                  std::integer_sequence<int, m...>) {
    (MultiplyColumn<n, m, Entries>()(entries, in, out), ...);
  }
};

// Coefficients +m and -m of any order, in slots by their band.
template <class K>
class Column {
 public:
  template <class In>
  GAUNT_LANES Column(const In& in, int order, int m) : m_(m) {
    for (int l = m; l < order; ++l) {
      cosines_(Slot(l), in(Plane(l, m)));
      if (m != 0) sines_(Slot(l), in(Plane(l, -m)));
    }
  }

  // Writes band l of the product, row.count entries row(i) times the coefficients of bands row.Band(i).
  template <class Row, class Out>
  GAUNT_LANES void PutRow(const Row& row, int l, const Out& out) const {
    if (m_ == 0) return out(Plane(l, 0), Sum(row, cosines_));
    auto cosine = Mul(row(0), cosines_(Slot(row.Band(0))));
    auto sine = Mul(row(0), sines_(Slot(row.Band(0))));
    for (int i = 1; i < row.count; ++i) {
      const auto entry = row(i);
      const size_t slot = Slot(row.Band(i));
      cosine = MulAdd(entry, cosines_(slot), cosine);
      sine = MulAdd(entry, sines_(slot), sine);
    }
    out(Plane(l, m_), cosine);
    out(Plane(l, -m_), sine);
  }

 private:
  static size_t Slot(int l) { return static_cast<size_t>(l); }
  static size_t Plane(int l, int m) { return static_cast<size_t>(CoefficientIndex(l, m)); }

  template <class Row, class Slots>
  static GAUNT_LANES typename K::V Sum(const Row& row, const Slots& coefficients) {
    auto sum = Mul(row(0), coefficients(Slot(row.Band(0))));
    for (int i = 1; i < row.count; ++i) {
      sum = MulAdd(row(i), coefficients(Slot(row.Band(i))), sum);
    }
    return sum;
  }

  int m_;
  typename K::template Slots<kMaxOrder> cosines_, sines_;
};

// A fixed function times functions of any order.
template <class Matrix>
struct MultiplyByFixedAny {
  int order;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& in, const Out& out) const {
    for (int m = 0; m < order; ++m) {
      const Column<K> column(in, order, m);
      for (int l = m; l < order; ++l) column.PutRow(RowOf<K>(k, l, m), l, out);
    }
  }

 private:
  using Term = typename FixedTable<Matrix>::Term;
  template <class K>
  struct Row {
    const K& k;
    const Term* term;
    int count;
    int Band(int i) const { return term[i].band; }
    GAUNT_LANES typename K::V operator()(int i) const { return k(term[i].factor); }
  };

  template <class K>
  Row<K> RowOf(const K& k, int l, int m) const {
    const uint16_t* const first = kFixedTable<Matrix>.first + ColumnIndex(l, m);
    const Term* const term = kFixedTable<Matrix>.term + first[0];
    int count = first[1] - first[0];
    while (term[count - 1].band >= order) --count;
    return {k, term, count};
  }
};

// Zonal functions of order a times functions of any order.
template <int a>
struct MultiplyByZonalAny {
  int order;
  int out_order;

  template <class K, class Zonal, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const Zonal& zonal, const In& in, const Out& out) const {
    typename K::template Slots<a> bands;
    bands(0, Mul(k(kConstant), zonal(0)));
    Copy(zonal, bands, std::make_integer_sequence<int, a - 1>());
    Entries<K> entries;
    const int columns = std::min(order, out_order);
    for (int m = 0; m < columns; ++m) {
      for (int low = m; low < columns; ++low) {
        SetEntries<0>(k, bands, low, kZonalTable.factor[ColumnIndex(low, m)], entries);
      }
      const Column<K> column(in, order, m);
      for (int l = m; l < out_order; ++l) {
        const int first = std::max(m, l - a + 1), last = std::min(order, l + a);
        column.PutRow(Row<K>{entries, EntrySlot(l, first), first, last - first}, l, out);
      }
    }
    for (int m = columns; m < out_order; ++m) {
      for (int l = m; l < out_order; ++l) {
        out(static_cast<size_t>(CoefficientIndex(l, m)), k(0.0));
        out(static_cast<size_t>(CoefficientIndex(l, -m)), k(0.0));
      }
    }
  }

 private:
  template <class K>
  using Entries = typename K::template Slots<kMaxOutOrder * kMaxOrder>;
  static size_t EntrySlot(int l_out, int l_in) {
    return static_cast<size_t>(l_out * kMaxOrder + l_in);
  }
  template <class K>
  struct Row {
    const Entries<K>& entries;
    size_t slot;
    int first;
    int count;
    int Band(int i) const { return first + i; }
    GAUNT_LANES typename K::V operator()(int i) const {
      return entries(slot + static_cast<size_t>(i));
    }
  };

  template <class From, class To, int... i>
  static GAUNT_LANES void Copy(const From& from, To& to, std::integer_sequence<int, i...>) {
    (to(i + 1, from(i + 1)), ...);
  }

  // Of the bands low and those from low + difference up.
  template <int difference, class K, class Bands>
  GAUNT_LANES void SetEntries(const K& k, const Bands& bands, int low, const float* factor,
                              Entries<K>& entries) const {
    if constexpr (difference < a) {
      const int high = low + difference;
      if (high >= std::max(order, out_order)) return;
      const auto entry = Entry<difference>(k, bands, low, factor);
      if (high < out_order) entries(EntrySlot(high, low), entry);
      if (high < order) entries(EntrySlot(low, high), entry);
      SetEntries<difference + 1>(k, bands, low, factor, entries);
    }
  }

  template <int difference, class K, class Bands>
  static GAUNT_LANES typename K::V Entry(const K& k, const Bands& bands, int low,
                                         const float* factor) {
    if constexpr (difference == 0) {
      return AddTerms<0, 1>(k, bands, low, factor, bands(0));
    } else {
      return AddTerms<difference, 1>(k, bands, low, factor,
                                     Mul(k(factor[TermIndex(difference, 0)]), bands(difference)));
    }
  }

  template <int difference, int term, class K, class Bands>
  static GAUNT_LANES typename K::V AddTerms(const K& k, const Bands& bands, int low,
                                            const float* factor, typename K::V sum) {
    constexpr int kBand = difference + 2 * term;
    if constexpr (kBand < a) {
      if (low < term) return sum;
      return AddTerms<difference, term + 1>(
          k, bands, low, factor, MulAdd(k(factor[TermIndex(difference, term)]), bands(kBand), sum));
    } else {
      return sum;
    }
  }
};

}  // namespace gaunt::product::axial::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PRODUCT_AXIAL_INL_H_
