// SPDX-License-Identifier: MIT
#include "product/product.h"

#include "check.h"
#include "product/axial.h"
#include "product/prepared.h"

using gaunt::capi::InputOf;
using gaunt::capi::InRange;
using gaunt::capi::MemoryCheck;
using gaunt::capi::OutputOf;
namespace axial = gaunt::product::axial;
namespace prepared = gaunt::product::prepared;

static_assert(GAUNT_MAX_PRODUCT_ORDER == gaunt::product::kMaxOrder,
              "the manual's limits are the kernels'");

namespace {

gaunt_status CheckOrders(uint32_t n_a, uint32_t n_b, uint32_t n_out) {
  GAUNT_REQUIRE(InRange(n_a, 1, GAUNT_MAX_PRODUCT_ORDER), GAUNT_ERROR_ORDER);
  GAUNT_REQUIRE(InRange(n_b, 1, GAUNT_MAX_PRODUCT_ORDER), GAUNT_ERROR_ORDER);
  GAUNT_REQUIRE(InRange(n_out, 1, n_a + n_b - 1), GAUNT_ERROR_ORDER);
  return GAUNT_OK;
}

gaunt::product::Orders OrdersOf(uint32_t n_a, uint32_t n_b, uint32_t n_out) {
  return {static_cast<int>(n_a), static_cast<int>(n_b), static_cast<int>(n_out)};
}

// What a function is multiplied by; no output is in place of it, whatever its planes.
struct Factor {
  const gaunt_view* view;
  size_t planes;
};

// A product that may be in place on `in`, where the orders are the same.
gaunt_status CheckViews(size_t count, const Factor& factor, const gaunt_view* in, size_t in_planes,
                        const gaunt_view* out, size_t out_planes) {
  GAUNT_CHECK(MemoryCheck(count).In(in, in_planes).OutInPlace(out, out_planes).status());
  return MemoryCheck(count).In(factor.view, factor.planes).Out(out, out_planes).status();
}

gaunt_status Fixed(axial::FixedFn kernel, uint32_t n, uint32_t channels, size_t count,
                   const gaunt_view* in, const gaunt_view* out) {
  GAUNT_REQUIRE(InRange(n, 1, GAUNT_MAX_PRODUCT_ORDER), GAUNT_ERROR_ORDER);
  GAUNT_REQUIRE(InRange(channels, 1, GAUNT_MAX_CHANNELS), GAUNT_ERROR_RANGE);
  const size_t planes = channels * n * n;
  GAUNT_CHECK(MemoryCheck(count).In(in, planes).OutInPlace(out, planes).status());
  if (count == 0) return GAUNT_OK;
  kernel(static_cast<int>(n), channels, count, InputOf(*in, count), OutputOf(*out, count));
  return GAUNT_OK;
}

gaunt_status FixedAxis(axial::FixedAxisFn kernel, uint32_t n, uint32_t channels, size_t count,
                       const gaunt_view* axes, const gaunt_view* in, const gaunt_view* out) {
  GAUNT_REQUIRE(InRange(n, 1, GAUNT_MAX_PRODUCT_ORDER), GAUNT_ERROR_ORDER);
  GAUNT_REQUIRE(InRange(channels, 1, GAUNT_MAX_CHANNELS), GAUNT_ERROR_RANGE);
  const size_t planes = channels * n * n;
  GAUNT_CHECK(CheckViews(count, {axes, 3}, in, planes, out, planes));
  if (count == 0) return GAUNT_OK;
  kernel(static_cast<int>(n), channels, count, InputOf(*axes, count), InputOf(*in, count),
         OutputOf(*out, count));
  return GAUNT_OK;
}

}  // namespace

extern "C" {

gaunt_status gaunt_product(uint32_t n_a, uint32_t n_b, uint32_t n_out, uint32_t channels,
                           size_t count, const gaunt_view* a, const gaunt_view* b,
                           const gaunt_view* out) {
  GAUNT_CHECK(CheckOrders(n_a, n_b, n_out));
  GAUNT_REQUIRE(InRange(channels, 1, GAUNT_MAX_CHANNELS), GAUNT_ERROR_RANGE);
  // In place on a factor of as many planes, which has the product's order.
  GAUNT_CHECK(MemoryCheck(count)
                  .In(a, channels * n_a * n_a)
                  .In(b, channels * n_b * n_b)
                  .OutInPlace(out, channels * n_out * n_out)
                  .status());
  if (count == 0) return GAUNT_OK;
  gaunt::product::Kernels().product(OrdersOf(n_a, n_b, n_out), channels, count, InputOf(*a, count),
                                    InputOf(*b, count), OutputOf(*out, count));
  return GAUNT_OK;
}

gaunt_status gaunt_product_square(uint32_t n, uint32_t n_out, uint32_t channels, size_t count,
                                  const gaunt_view* a, const gaunt_view* out) {
  GAUNT_CHECK(CheckOrders(n, n, n_out));
  GAUNT_REQUIRE(InRange(channels, 1, GAUNT_MAX_CHANNELS), GAUNT_ERROR_RANGE);
  GAUNT_CHECK(MemoryCheck(count)
                  .In(a, channels * n * n)
                  .OutInPlace(out, channels * n_out * n_out)
                  .status());
  if (count == 0) return GAUNT_OK;
  gaunt::product::Kernels().square(static_cast<int>(n), static_cast<int>(n_out), channels, count,
                                   InputOf(*a, count), OutputOf(*out, count));
  return GAUNT_OK;
}

gaunt_status gaunt_product_zonal(uint32_t n_z, uint32_t n_b, uint32_t n_out, uint32_t channels,
                                 size_t count, const gaunt_view* zonal, const gaunt_view* b,
                                 const gaunt_view* out) {
  GAUNT_CHECK(CheckOrders(n_z, n_b, n_out));
  GAUNT_REQUIRE(InRange(channels, 1, GAUNT_MAX_CHANNELS), GAUNT_ERROR_RANGE);
  GAUNT_CHECK(CheckViews(count, {zonal, channels * n_z}, b, channels * n_b * n_b, out,
                         channels * n_out * n_out));
  if (count == 0) return GAUNT_OK;
  axial::Kernels().zonal(OrdersOf(n_z, n_b, n_out), channels, count, InputOf(*zonal, count),
                         InputOf(*b, count), OutputOf(*out, count));
  return GAUNT_OK;
}

gaunt_status gaunt_product_zonal_axis(uint32_t n_z, uint32_t n_b, uint32_t n_out, uint32_t channels,
                                      size_t count, const gaunt_view* zonal, const gaunt_view* axes,
                                      const gaunt_view* b, const gaunt_view* out) {
  GAUNT_CHECK(CheckOrders(n_z, n_b, n_out));
  GAUNT_REQUIRE(n_out <= GAUNT_MAX_ROTATE_ORDER, GAUNT_ERROR_ORDER);
  GAUNT_REQUIRE(InRange(channels, 1, GAUNT_MAX_CHANNELS), GAUNT_ERROR_RANGE);
  const size_t out_planes = channels * n_out * n_out;
  GAUNT_CHECK(CheckViews(count, {zonal, channels * n_z}, b, channels * n_b * n_b, out, out_planes));
  GAUNT_CHECK(MemoryCheck(count).In(axes, 3).Out(out, out_planes).status());
  if (count == 0) return GAUNT_OK;
  axial::Kernels().zonal_axis(OrdersOf(n_z, n_b, n_out), channels, count, InputOf(*zonal, count),
                              InputOf(*axes, count), InputOf(*b, count), OutputOf(*out, count));
  return GAUNT_OK;
}

gaunt_status gaunt_product_hemisphere(uint32_t n, uint32_t channels, size_t count,
                                      const gaunt_view* in, const gaunt_view* out) {
  return Fixed(axial::Kernels().hemisphere, n, channels, count, in, out);
}

gaunt_status gaunt_product_hemisphere_axis(uint32_t n, uint32_t channels, size_t count,
                                           const gaunt_view* axes, const gaunt_view* in,
                                           const gaunt_view* out) {
  return FixedAxis(axial::Kernels().hemisphere_axis, n, channels, count, axes, in, out);
}

gaunt_status gaunt_product_cosine(uint32_t n, uint32_t channels, size_t count, const gaunt_view* in,
                                  const gaunt_view* out) {
  return Fixed(axial::Kernels().cosine, n, channels, count, in, out);
}

gaunt_status gaunt_product_cosine_axis(uint32_t n, uint32_t channels, size_t count,
                                       const gaunt_view* axes, const gaunt_view* in,
                                       const gaunt_view* out) {
  return FixedAxis(axial::Kernels().cosine_axis, n, channels, count, axes, in, out);
}

gaunt_status gaunt_product_prepare(uint32_t n_f, uint32_t n_in, uint32_t n_out, const gaunt_view* f,
                                   void* op, size_t* op_size) {
  GAUNT_CHECK(CheckOrders(n_f, n_in, n_out));
  GAUNT_REQUIRE(op_size != nullptr, GAUNT_ERROR_NULL);
  const gaunt::product::Orders orders = OrdersOf(n_f, n_in, n_out);
  const size_t size = prepared::SizeOf(orders.a, orders.b, orders.out);
  if (op != nullptr) {
    GAUNT_REQUIRE(*op_size >= size, GAUNT_ERROR_RANGE);
    GAUNT_CHECK(MemoryCheck(1)
                    .In(f, n_f * n_f)
                    .OutRecords(op, 1, size, size)
                    .OutRecords(op_size, 1, sizeof(*op_size), sizeof(*op_size))
                    .status());
    prepared::Prepare(orders.a, orders.b, orders.out, InputOf(*f, 1), op);
  }
  *op_size = size;
  return GAUNT_OK;
}

gaunt_status gaunt_product_apply(const void* op, size_t op_size, uint32_t channels, size_t count,
                                 const gaunt_view* in, const gaunt_view* out) {
  GAUNT_REQUIRE(op != nullptr, GAUNT_ERROR_NULL);
  int n_in = 0, n_out = 0;
  GAUNT_REQUIRE(prepared::IsValid(op, op_size, &n_in, &n_out), GAUNT_ERROR_FORMAT);
  GAUNT_REQUIRE(InRange(channels, 1, GAUNT_MAX_CHANNELS), GAUNT_ERROR_RANGE);
  GAUNT_CHECK(MemoryCheck(count)
                  .InRecords(op, 1, op_size, op_size)
                  .In(in, channels * static_cast<size_t>(n_in * n_in))
                  .OutInPlace(out, channels * static_cast<size_t>(n_out * n_out))
                  .status());
  if (count == 0) return GAUNT_OK;
  prepared::Kernels().apply(op, channels, count, InputOf(*in, count), OutputOf(*out, count));
  return GAUNT_OK;
}

}  // extern "C"
