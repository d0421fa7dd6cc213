// SPDX-License-Identifier: MIT
#include "product/prepared.h"

#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "product/prepared.cc"
#include <hwy/foreach_target.h>

#include "product/matrix-inl.h"
#include "product/product-inl.h"
#include "simd/batch-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::product::prepared::HWY_NAMESPACE {

using namespace gaunt::product::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Runs a kernel on each channel, of functions of orders up to kMax if these are known.
template <int kMaxIn, int kMaxOut, class Kernel>
void ForChannels(const Header& header, const Kernel& kernel, Place place, size_t channels,
                 size_t count, const simd::InView& in, const simd::OutView& out) {
  const size_t in_planes = header.in * header.in, out_planes = header.out * header.out;
  for (size_t c = 0; c < channels; ++c) {
    ForEachBatch(
        count, kernel,
        In<NumCoefficients(kMaxIn)>(in.FromPlane(c * in_planes), in_planes, 0, place),
        Out<NumCoefficients(kMaxOut)>(out.FromPlane(c * out_planes), out_planes, 0, place));
  }
}
using ApplyFn = void (*)(const Header& header, const void* values, size_t channels, size_t count,
                         const simd::InView& in, const simd::OutView& out);

template <int n>
void ApplyMatrix(const Header& header, const void* values, size_t channels, size_t count,
                 const simd::InView& in, const simd::OutView& out) {
  ForChannels<n, n>(header, Matrix<n>{values}, Place::kNearby, channels, count, in, out);
}
template <int... n>
constexpr auto MakeMatrices(std::integer_sequence<int, 0, n...>) {
  struct Matrices {
    ApplyFn apply[sizeof...(n) + 1];
  };
  return Matrices{{nullptr, &ApplyMatrix<n>...}};
}
constexpr auto kMatrices = MakeMatrices(gaunt::Orders<kMinPreparedFixed - 1>());

void ApplyAnyMatrix(const Header& header, const void* values, size_t channels, size_t count,
                    const simd::InView& in, const simd::OutView& out) {
  const AnyMatrix kernel = {values, static_cast<int>(header.out * header.out),
                            static_cast<int>(header.in * header.in)};
  ForChannels<kMaxOrder, MaxMatrixOut()>(header, kernel, Place::kApart, channels, count, in, out);
}

template <int n>
void ApplyFixed(const Header& header, const void* values, size_t channels, size_t count,
                const simd::InView& in, const simd::OutView& out) {
  const PreparedKernel<n> kernel = {values};
  ForChannels<n, n>(header, kernel, Place::kNearby, channels, count, in, out);
}
template <int... i>
constexpr auto MakeFixedCases(std::integer_sequence<int, i...>) {
  struct Cases {
    ApplyFn apply[sizeof...(i)];
  };
  return Cases{{&ApplyFixed<kMinPreparedFixed + i>...}};
}
constexpr auto kFixedCases =
    MakeFixedCases(std::make_integer_sequence<int, kMaxPreparedFixed - kMinPreparedFixed + 1>());

void ApplyValues(const Header& header, const void* values, size_t channels, size_t count,
                 const simd::InView& in, const simd::OutView& out) {
  const Orders orders = OrdersOf(header);
  product::Kernels().prepared({orders.b, orders.a, orders.out}, values, channels, count, in, out);
}

ApplyFn ApplyOf(const Header& header) {
  if (header.kind == kMatrix) {
    return IsEqual(header) && header.in < kMinPreparedFixed ? kMatrices.apply[header.in]
                                                            : &ApplyAnyMatrix;
  }
  return HasFixedKernel(header) ? kFixedCases.apply[header.in - kMinPreparedFixed] : &ApplyValues;
}

void Apply(const void* bytes, size_t channels, size_t count, const simd::InView& in,
           const simd::OutView& out) {
  Header header;
  std::memcpy(&header, bytes, sizeof(header));
  const void* const values = static_cast<const unsigned char*>(bytes) + sizeof(header);
  ApplyOf(header)(header, values, channels, count, in, out);
}

const Table* GetTable() {
  static constexpr Table kTable = {&Apply};
  return &kTable;
}

}  // namespace gaunt::product::prepared::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(product::prepared);
