// SPDX-License-Identifier: MIT
// Any bytes as a prepared product: outputs of bytes that say what gaunt_product_prepare() writes may
// be anything, but nothing behind the data is read or written. The kernels have no sanitizer, so that
// all data ends before a page that must not be touched.
#include <array>
#include <map>

#include "tests/fuzz/support.h"
#include "tests/support/guarded.h"

using namespace gaunt::fuzz;
using gaunt::test::GuardedBytes;
using gaunt::test::GuardedFloats;

namespace {

constexpr size_t kHeaderBytes = 24;  // magic, version, orders, kind

// Interleaved, at the end of guarded memory.
gaunt_view Floats(const GuardedFloats& floats, size_t planes) {
  gaunt_view view;
  gaunt_view_interleaved(floats.data(), planes, &view);
  return view;
}

using Bytes = std::array<uint8_t, kHeaderBytes>;

// What prepared bytes of these orders begin with. They are made once, for large ones take long.
const Bytes& Header(uint32_t n_f, uint32_t n_in, uint32_t n_out, size_t size) {
  static std::map<std::array<uint32_t, 3>, Bytes> headers;
  const auto [at, is_new] = headers.try_emplace({n_f, n_in, n_out});
  if (is_new) {
    float zeros[GAUNT_MAX_PRODUCT_ORDER * GAUNT_MAX_PRODUCT_ORDER] = {};
    gaunt_view f;
    gaunt_view_interleaved(zeros, n_f * n_f, &f);
    const std::unique_ptr<uint8_t[]> prepared(new uint8_t[size]);
    size_t written = size;
    GAUNT_FUZZ_CHECK(gaunt_product_prepare(n_f, n_in, n_out, &f, prepared.get(), &written) ==
                     GAUNT_OK);
    GAUNT_FUZZ_CHECK(written == size);
    std::copy(prepared.get(), prepared.get() + kHeaderBytes, at->second.begin());
  }
  return at->second;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  FuzzedDataProvider input(data, size);
  // Mostly small orders: large ones take long.
  const uint32_t most = input.ConsumeIntegralInRange<int>(0, 7) == 0 ? 10 : 4;
  const auto n_f = input.ConsumeIntegralInRange<uint32_t>(1, most);
  const auto n_in = input.ConsumeIntegralInRange<uint32_t>(1, most);
  const auto n_out = input.ConsumeIntegralInRange<uint32_t>(1, n_f + n_in - 1);
  const auto channels = input.ConsumeIntegralInRange<uint32_t>(1, 3);
  const auto count = input.ConsumeIntegralInRange<size_t>(0, kMaxCount);
  const bool right_header = input.ConsumeBool(), right_size = input.ConsumeBool();

  size_t op_size = 0;
  GAUNT_FUZZ_CHECK(gaunt_product_prepare(n_f, n_in, n_out, nullptr, nullptr, &op_size) == GAUNT_OK);
  const size_t wanted = op_size;
  if (!right_size) op_size = input.ConsumeIntegralInRange<size_t>(0, 2 * wanted);
  const size_t in_planes = channels * n_in * n_in, out_planes = channels * n_out * n_out;
  const GuardedFloats in(count * in_planes), out(count * out_planes);
  const GuardedBytes op(op_size);
  input.ConsumeData(op.data(), op_size);
  if (right_header && op_size >= kHeaderBytes) {
    const Bytes& header = Header(n_f, n_in, n_out, wanted);
    std::copy(header.begin(), header.end(), op.data());
  }
  input.ConsumeData(in.data(), count * in_planes * sizeof(float));
  const gaunt_view in_view = Floats(in, in_planes), out_view = Floats(out, out_planes);
  const gaunt_status status =
      gaunt_product_apply(op.data(), op_size, channels, count, &in_view, &out_view);
  if (right_header) GAUNT_FUZZ_CHECK(status == (op_size == wanted ? GAUNT_OK : GAUNT_ERROR_FORMAT));
  return 0;
}
