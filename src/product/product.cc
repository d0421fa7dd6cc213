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
    ForEachBatch(count, SquareKernel<n>(),
                 In<kPlanes>(Channel(in, c, n), kPlanes, 0, Place::kNearby),
                 Out<kPlanes>(Channel(out, c, n)));
  }
}

// The others, of one factor or two. Bands that couple with nothing are not read.
inline constexpr size_t kMaxPlanes = NumCoefficients(kMaxOrder);
constexpr size_t PlanesOf(int degree) { return static_cast<size_t>(NumCoefficients(degree + 1)); }
auto InOfAny(const simd::InView& view, size_t channel, int order, int degree) {
  return In<kMaxPlanes>(Channel(view, channel, order), PlanesOf(degree), 0, Place::kApart);
}

template <class Kernel, class... Sides>
void AnyBatch(const Kernel& kernel, size_t count, const simd::OutView& out, Sides&&... ins) {
  const size_t planes = PlanesOf(kernel.degrees.out);
  if (planes <= kMaxPlanes) {
    ForEachBatch(count, kernel, ins..., Out<kMaxPlanes>(out, planes, 0, Place::kApart));
  } else {
    ForEachBatch(count, kernel, ins...,
                 Out<NumCoefficients(kMaxOutOrder)>(out, planes, 0, Place::kApart));
  }
}

template <int M>
void AnyProduct(const Orders& orders, const Degrees& degrees, size_t channels, size_t count,
                const simd::InView& a, const simd::InView& b, const simd::OutView& out) {
  for (size_t c = 0; c < channels; ++c) {
    AnyBatch(AnyGrid<M, kLevel>{degrees}, count, Channel(out, c, orders.out),
             InOfAny(a, c, orders.a, degrees.a), InOfAny(b, c, orders.b, degrees.b));
  }
}
// The square of a or, if there are values, its product with the function that has them.
template <int M>
void AnyProductOfOne(const Orders& orders, const Degrees& degrees, const void* values,
                     size_t channels, size_t count, const simd::InView& a,
                     const simd::OutView& out) {
  for (size_t c = 0; c < channels; ++c) {
    AnyBatch(AnyGrid<M, kLevel>{degrees, values}, count, Channel(out, c, orders.out),
             InOfAny(a, c, orders.a, degrees.a));
  }
}

struct FixedCase {
  Orders orders;
  ProductFn product;
};
template <int a, int b, int out>
inline constexpr FixedCase kFixedCase = {{a, b, out}, &FixedProduct<a, b, out>};
constexpr FixedCase kFixedCases[] = {kFixedCase<1, 1, 1>, kFixedCase<2, 2, 2>, kFixedCase<3, 3, 3>,
                                     kFixedCase<4, 4, 4>, kFixedCase<5, 5, 5>, kFixedCase<6, 6, 6>,
                                     kFixedCase<7, 7, 7>, kFixedCase<8, 8, 8>, kFixedCase<6, 6, 3>,
                                     kFixedCase<6, 6, 4>, kFixedCase<2, 6, 6>, kFixedCase<3, 6, 6>};

// The kernel of orders that have one of their own, or null.
ProductFn FixedProductOf(const Degrees& degrees) {
  for (const FixedCase& fixed : kFixedCases) {
    const Orders& have = fixed.orders;
    if (have.a == degrees.a + 1 && have.b == degrees.b + 1 && have.out == degrees.out + 1) {
      return fixed.product;
    }
  }
  return nullptr;
}

template <int... i>
constexpr auto MakeAnyCases(std::integer_sequence<int, i...>) {
  struct Cases {
    decltype(&AnyProduct<kPointCounts[0]>) product[sizeof...(i)];
    decltype(&AnyProductOfOne<kPointCounts[0]>) of_one[sizeof...(i)];
  };
  return Cases{{&AnyProduct<kPointCounts[i]>...}, {&AnyProductOfOne<kPointCounts[i]>...}};
}
constexpr auto kAnyCases = MakeAnyCases(std::make_integer_sequence<int, kNumPointCounts>());
int AnyCaseOf(const Degrees& degrees) {
  return PointCase(GridOf(degrees.a + degrees.b + degrees.out));
}

void Product(const Orders& orders, size_t channels, size_t count, const simd::InView& a,
             const simd::InView& b, const simd::OutView& out) {
  if (orders.a > orders.b) {
    return Product({orders.b, orders.a, orders.out}, channels, count, b, a, out);
  }
  const Degrees degrees = Coupled(orders);
  if (const ProductFn fixed = FixedProductOf(degrees)) {
    return fixed(orders, channels, count, a, b, out);
  }
  kAnyCases.product[AnyCaseOf(degrees)](orders, degrees, channels, count, a, b, out);
}

void Prepared(const Orders& orders, const void* values, size_t channels, size_t count,
              const simd::InView& a, const simd::OutView& out) {
  const Degrees degrees = Coupled(orders);
  kAnyCases.of_one[AnyCaseOf(degrees)](orders, degrees, values, channels, count, a, out);
}

template <int... n>
constexpr auto MakeSquares(std::integer_sequence<int, 0, n...>) {
  struct Squares {
    SquareFn square[sizeof...(n) + 1];
  };
  return Squares{{nullptr, &FixedSquare<n>...}};
}
constexpr auto kSquares = MakeSquares(gaunt::Orders<kMaxFixed>());

void Square(int order, int out_order, size_t channels, size_t count, const simd::InView& in,
            const simd::OutView& out) {
  const Orders orders = {order, order, out_order};
  const Degrees degrees = Coupled(orders);
  if (order == out_order && order <= kMaxFixed) {
    kSquares.square[order](order, out_order, channels, count, in, out);
  } else if (const ProductFn fixed = FixedProductOf(degrees)) {
    fixed(orders, channels, count, in, in, out);
  } else {
    kAnyCases.of_one[AnyCaseOf(degrees)](orders, degrees, nullptr, channels, count, in, out);
  }
}

const Table* GetTable() {
  static constexpr Table kTable = {&Product, &Square, &Prepared};
  return &kTable;
}

}  // namespace gaunt::product::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(product);
