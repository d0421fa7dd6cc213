// SPDX-License-Identifier: MIT
#include "product/product.h"

#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "product/product.cc"
#include <hwy/foreach_target.h>

#include "product/product-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::product::HWY_NAMESPACE {

// Views of one channel of functions of an order, of which a kernel reads some first planes.
template <class View>
View Channel(const View& view, size_t channel, int order) {
  return view.FromPlane(channel * static_cast<size_t>(NumCoefficients(order)));
}

// Kernels of orders that are known when they are compiled. They write an item when they have read
// all of it.
template <int kA, int kB, int kOut>
void FixedProduct(const Orders& orders, size_t channels, size_t count, const simd::InView& a,
                  const simd::InView& b, const simd::OutView& out) {
  constexpr size_t kPlanesA = NumCoefficients(kA), kPlanesB = NumCoefficients(kB);
  for (size_t c = 0; c < channels; ++c) {
    ForEachBatch(count, ProductKernel<kA, kB, kOut>(),
                 In<kPlanesA>(Channel(a, c, orders.a), kPlanesA, 0, Place::kNearby),
                 In<kPlanesB>(Channel(b, c, orders.b), kPlanesB, 0, Place::kNearby),
                 Out<NumCoefficients(kOut)>(Channel(out, c, orders.out)));
  }
}

template <int n>
void FixedSquare(int, int, size_t channels, size_t count, const simd::InView& in,
                 const simd::OutView& out) {
  constexpr size_t kPlanes = NumCoefficients(n);
  for (size_t c = 0; c < channels; ++c) {
    ForEachBatch(count, SquareKernel<n>(), In<kPlanes>(Channel(in, c, n), kPlanes, 0, Place::kNearby),
                 Out<kPlanes>(Channel(out, c, n)));
  }
}

// The others. Bands that couple with nothing are not read.
template <int M>
void AnyProduct(const Orders& orders, const Degrees& degrees, size_t channels, size_t count,
                const simd::InView& a, const simd::InView& b, const simd::OutView& out) {
  constexpr size_t kMaxPlanes = NumCoefficients(kMaxOrder);
  const AnyGrid<M, kLevel> kernel = {degrees};
  const auto planes = [](int L) { return static_cast<size_t>(NumCoefficients(L + 1)); };
  for (size_t c = 0; c < channels; ++c) {
    In<kMaxPlanes> side_a(Channel(a, c, orders.a), planes(degrees.a), 0, Place::kApart);
    In<kMaxPlanes> side_b(Channel(b, c, orders.b), planes(degrees.b), 0, Place::kApart);
    const simd::OutView to = Channel(out, c, orders.out);
    if (orders.out <= kMaxOrder) {
      ForEachBatch(count, kernel, side_a, side_b,
                   Out<kMaxPlanes>(to, planes(degrees.out), 0, Place::kApart));
    } else {
      ForEachBatch(count, kernel, side_a, side_b,
                   Out<NumCoefficients(kMaxOutOrder)>(to, planes(degrees.out), 0, Place::kApart));
    }
  }
}

struct FixedCase {
  Orders orders;
  ProductFn product;
};
template <int a, int b, int out>
inline constexpr FixedCase kFixedCase = {{a, b, out}, &FixedProduct<a, b, out>};
constexpr FixedCase kFixedCases[] = {
    kFixedCase<1, 1, 1>, kFixedCase<2, 2, 2>, kFixedCase<3, 3, 3>, kFixedCase<4, 4, 4>,
    kFixedCase<5, 5, 5>, kFixedCase<6, 6, 6>, kFixedCase<7, 7, 7>, kFixedCase<8, 8, 8>,
    kFixedCase<6, 6, 3>, kFixedCase<6, 6, 4>, kFixedCase<2, 6, 6>, kFixedCase<3, 6, 6>};

using AnyFn = void (*)(const Orders&, const Degrees&, size_t, size_t, const simd::InView&,
                       const simd::InView&, const simd::OutView&);
template <int... i>
constexpr auto MakeAnyCases(std::integer_sequence<int, i...>) {
  struct Cases {
    int points[sizeof...(i)];
    AnyFn product[sizeof...(i)];
  };
  return Cases{{kPointCounts[i]...}, {&AnyProduct<kPointCounts[i]>...}};
}
constexpr auto kAnyCases = MakeAnyCases(std::make_integer_sequence<int, kNumPointCounts>());

void Product(const Orders& orders, size_t channels, size_t count, const simd::InView& a,
             const simd::InView& b, const simd::OutView& out) {
  if (orders.a > orders.b) {
    return Product({orders.b, orders.a, orders.out}, channels, count, b, a, out);
  }
  const Degrees degrees = Coupled(orders);
  for (const FixedCase& fixed : kFixedCases) {
    const Orders& have = fixed.orders;
    if (have.a == degrees.a + 1 && have.b == degrees.b + 1 && have.out == orders.out) {
      return fixed.product(orders, channels, count, a, b, out);
    }
  }
  const int i = PointCase(GridOf(degrees.a + degrees.b + degrees.out));
  kAnyCases.product[i](orders, degrees, channels, count, a, b, out);
}

template <int... n>
constexpr auto MakeSquares(std::integer_sequence<int, 0, n...>) {
  struct Squares {
    SquareFn square[sizeof...(n) + 1];
  };
  return Squares{{nullptr, &FixedSquare<n>...}};
}
constexpr auto kSquares = MakeSquares(gaunt::Orders<kMaxFixedSquare>());

void Square(int order, int out_order, size_t channels, size_t count, const simd::InView& in,
            const simd::OutView& out) {
  if (order == out_order && order <= kMaxFixedSquare) {
    kSquares.square[order](order, out_order, channels, count, in, out);
  } else {
    Product({order, order, out_order}, channels, count, in, in, out);
  }
}

const Table* GetTable() {
  static constexpr Table kTable = {&Product, &Square};
  return &kTable;
}

}  // namespace gaunt::product::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(product);
