// SPDX-License-Identifier: MIT
// Products of one function with many, from bytes that are made once: its values at the nodes of a
// quadrature, or its matrix.
#ifndef GAUNT_PRODUCT_PREPARED_H_
#define GAUNT_PRODUCT_PREPARED_H_

#include <cstddef>
#include <cstdint>

#include "product/grid.h"
#include "product/product.h"

namespace gaunt::product::prepared {

// At the start of the bytes, which have any alignment; floats follow.
struct Header {
  uint32_t magic, version;
  uint32_t f, in, out;  // orders
  uint32_t kind;
};

// A matrix, out^2 rows of in^2 entries, or values on the grid. Measured: grids are faster than
// matrices where they have kernels of their own, for equal orders from 6 on; without, if the matrix
// is large; and large matrices round more.
enum Kind : uint32_t { kMatrix, kValues };
inline constexpr int kMinPreparedFixed = 6, kMaxPreparedFixed = 10;
inline constexpr uint32_t kMaxMatrixEntries = 64 * 64;
// The highest order of a product that has a matrix.
constexpr int MaxMatrixOut() {
  int out = 1;
  for (int in = 1; in <= kMaxOrder; ++in) {
    for (int n = out; n < kMaxOrder + in; ++n) {
      if (static_cast<uint32_t>(n * n * in * in) <= kMaxMatrixEntries) out = n;
    }
  }
  return out;
}

constexpr bool IsEqual(const Header& header) {
  return header.f == header.in && header.in == header.out;
}
constexpr bool HasFixedKernel(const Header& header) {
  return IsEqual(header) && header.f >= kMinPreparedFixed && header.f <= kMaxPreparedFixed;
}
constexpr Kind KindOf(const Header& header) {
  const uint32_t entries = header.out * header.out * header.in * header.in;
  return !HasFixedKernel(header) && entries <= kMaxMatrixEntries ? kMatrix : kValues;
}

constexpr Orders OrdersOf(const Header& header) {
  return {static_cast<int>(header.f), static_cast<int>(header.in), static_cast<int>(header.out)};
}
constexpr Degrees DegreesOf(const Header& header) { return Coupled(OrdersOf(header)); }
constexpr int GridOf(const Header& header) {
  const Degrees degrees = DegreesOf(header);
  return product::GridOf(degrees.a + degrees.b + degrees.out);
}

size_t SizeOf(int order_f, int order_in, int order_out);
// Writes SizeOf() bytes from an item of order_f^2 planes.
void Prepare(int order_f, int order_in, int order_out, const simd::InView& f, void* bytes);
// Whether they are what Prepare() writes, by their header and size.
bool IsValid(const void* bytes, size_t size, int* order_in, int* order_out);

struct Table {
  void (*apply)(const void* bytes, size_t channels, size_t count, const simd::InView& in,
                const simd::OutView& out);
};

const Table& Kernels();

}  // namespace gaunt::product::prepared

#endif  // GAUNT_PRODUCT_PREPARED_H_
