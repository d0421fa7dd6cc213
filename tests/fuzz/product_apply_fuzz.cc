// SPDX-License-Identifier: MIT
// Any bytes as a prepared product: outputs of bytes that say what gaunt_product_prepare() writes may
// be anything, but nothing behind the data is read or written. The kernels have no sanitizer, so that
// all data ends before a page that must not be touched.
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
    // Of a function that is 0.
    float zeros[100] = {};
    gaunt_view f;
    gaunt_view_interleaved(zeros, n_f * n_f, &f);
    const std::unique_ptr<uint8_t[]> prepared(new uint8_t[wanted]);
    size_t capacity = wanted;
    GAUNT_FUZZ_CHECK(gaunt_product_prepare(n_f, n_in, n_out, &f, prepared.get(), &capacity) ==
                     GAUNT_OK);
    GAUNT_FUZZ_CHECK(capacity == wanted);
    std::memcpy(op.data(), prepared.get(), kHeaderBytes);
  }
  input.ConsumeData(in.data(), count * in_planes * sizeof(float));
  const gaunt_view in_view = Floats(in, in_planes), out_view = Floats(out, out_planes);
  const gaunt_status status =
      gaunt_product_apply(op.data(), op_size, channels, count, &in_view, &out_view);
  if (right_header) GAUNT_FUZZ_CHECK(status == (op_size == wanted ? GAUNT_OK : GAUNT_ERROR_FORMAT));
  return 0;
}
