// SPDX-License-Identifier: MIT
// The matrices of products with functions that are symmetric about z. They are symmetric, couple only
// coefficients of equal m, and are the same for m and -m.
#ifndef GAUNT_PRODUCT_AXIAL_CONSTANTS_H_
#define GAUNT_PRODUCT_AXIAL_CONSTANTS_H_

#include <cstdint>

#include "product/product.h"
#include "product/quadrature.h"
#include "product/tensor.h"

namespace gaunt::product::axial {

// y_00
inline constexpr double kConstant = basis::Sectoral(0);

// Of band l1 of a zonal function: what it contributes to the entry of bands l2 and l3.
constexpr double ZonalEntry(int l1, int l2, int l3, int m) { return Gaunt(l1, 0, l2, m, l3, m); }

// Products of a band of zonal functions and a factor that several entries of order n have, but for
// their signs. They are made once.
template <int n>
class SharedProducts {
 public:
  int count = 0;
  int band[kMaxOrder * kMaxOrder] = {};
  double factor[kMaxOrder * kMaxOrder] = {};

  constexpr SharedProducts() {
    for (int l = 1; l < n; ++l) {
      double known[n * n * n] = {};
      int times = 0;
      for (int low = 0; low < n; ++low) {
        for (int high = low; high < n && high <= low + l; ++high) {
          for (int m = 0; m <= low; ++m) {
            const double entry = ZonalEntry(l, low, high, m);
            if (entry == 0.0) continue;
            bool is_known = false;
            for (int i = 0; i < times && !is_known; ++i) is_known = IsSame(known[i], entry);
            if (!is_known) known[times++] = entry;
            if (!is_known || Find(l, entry) >= 0) continue;
            band[count] = l;
            factor[count++] = entry < 0.0 ? -entry : entry;
          }
        }
      }
    }
  }

  // -1 if it is not shared.
  constexpr int Find(int l, double entry) const {
    for (int i = 0; i < count; ++i) {
      if (band[i] == l && IsSame(factor[i], entry)) return i;
    }
    return -1;
  }

 private:
  static constexpr bool IsSame(double a, double b) {
    const double difference = (a < 0.0 ? -a : a) - (b < 0.0 ? -b : b);
    return difference < 1e-9 && difference > -1e-9;
  }
};
template <int n>
inline constexpr SharedProducts<n> kSharedProducts;

// The hemisphere z >= 0: the integral over it of y_l1,m y_l2,m. Legendre's equation gives it from
// values and slopes at the equator, one of which vanishes.
class Hemisphere {
 public:
  static constexpr double Entry(int l1, int l2, int m) {
    if (l1 == l2) return 0.5;
    if ((l1 + l2) % 2 == 0) return 0.0;
    return (m == 0 ? 2.0 : 1.0) * kPi *
           (Slope(l1, m) * Value(l2, m) - Value(l1, m) * Slope(l2, m)) /
           ((l1 - l2) * (l1 + l2 + 1.0));
  }

 private:
  static constexpr PolarParts kEquator = PolarRecurrence().At(0.0);
  static constexpr double Value(int l, int m) { return kEquator.part[PolarIndex(l, m)]; }
  static constexpr double Slope(int l, int m) {
    if (l == m) return 0.0;
    return ConstexprSqrt((2.0 * l + 1.0) / (2.0 * l - 1.0) * (1.0 * l * l - 1.0 * m * m)) *
           Value(l - 1, m);
  }
};

// max(z, 0), which is z times the hemisphere.
class Cosine {
 public:
  static constexpr double Entry(int l1, int l2, int m) {
    const double above = Step(l2 + 1, m) * Hemisphere::Entry(l1, l2 + 1, m);
    return l2 == m ? above : above + Step(l2, m) * Hemisphere::Entry(l1, l2 - 1, m);
  }

 private:
  // z y_lm = Step(l + 1) y_l+1,m + Step(l) y_l-1,m
  static constexpr double Step(int l, int m) {
    return ConstexprSqrt((1.0 * l * l - 1.0 * m * m) / (4.0 * l * l - 1.0));
  }
};

// The same for loops. Columns of coefficients by order and m <= l.
constexpr int ColumnIndex(int l, int m) { return l * (l + 1) / 2 + m; }
inline constexpr int kColumns = ColumnIndex(kMaxOrder, 0);

// Entries of the bands low and low + difference have a term for every other band of the zonal
// function from `difference` up, which couples while it is at most 2 low + difference.
constexpr int NumTerms(int difference) { return (kMaxOrder + 1 - difference) / 2; }
constexpr int TermIndex(int difference, int term) {
  for (int d = 0; d < difference; ++d) term += NumTerms(d);
  return term;
}
struct ZonalTable {
  static constexpr int kTerms = TermIndex(kMaxOrder, 0);
  float factor[kColumns][kTerms] = {};

  constexpr ZonalTable() {
    for (int low = 0; low < kMaxOrder; ++low) {
      for (int m = 0; m <= low; ++m) {
        for (int difference = 0; difference < kMaxOrder; ++difference) {
          for (int term = 0; term < NumTerms(difference); ++term) {
            factor[ColumnIndex(low, m)][TermIndex(difference, term)] =
                static_cast<float>(ZonalEntry(difference + 2 * term, low, low + difference, m));
          }
        }
      }
    }
  }
};
inline constexpr ZonalTable kZonalTable;

// Rows of a fixed matrix without its zeros, by the band and m of their coefficient.
template <class Matrix>
struct FixedTable {
  struct Term {
    float factor;
    uint8_t band;  // of the column, ascending
  };
  Term term[kColumns * kMaxOrder] = {};
  uint16_t first[kColumns + 1] = {};

  constexpr FixedTable() {
    int terms = 0;
    for (int l = 0; l < kMaxOrder; ++l) {
      for (int m = 0; m <= l; ++m) {
        first[ColumnIndex(l, m)] = static_cast<uint16_t>(terms);
        for (int band = m; band < kMaxOrder; ++band) {
          const double factor = Matrix::Entry(l, band, m);
          if (factor == 0.0) continue;
          term[terms++] = {static_cast<float>(factor), static_cast<uint8_t>(band)};
        }
      }
    }
    first[kColumns] = static_cast<uint16_t>(terms);
  }
};
template <class Matrix>
inline constexpr FixedTable<Matrix> kFixedTable;

}  // namespace gaunt::product::axial

#endif  // GAUNT_PRODUCT_AXIAL_CONSTANTS_H_
