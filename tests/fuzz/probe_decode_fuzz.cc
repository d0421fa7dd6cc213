// SPDX-License-Identifier: MIT
// Any bytes as packed probes: they decode to finite values, and nothing beside them is read.
#include <cmath>
#include <vector>

#include "tests/fuzz/support.h"

using namespace gaunt::fuzz;

namespace {

bool IsFinite(float value) { return std::isfinite(value); }

void Gather(FuzzedDataProvider& input, const Format& format, const uint8_t* packed,
            size_t packed_count) {
  const auto count = input.ConsumeIntegralInRange<size_t>(0, kMaxCount);
  const auto taps = input.ConsumeIntegralInRange<uint32_t>(1, 9);
  const auto order = input.ConsumeIntegralInRange<uint32_t>(1, format.order);
  const ExactBatch out(input, count, size_t{3} * order * order);
  const bool any_weight = input.ConsumeBool();
  const size_t all_taps = count * taps;
  const std::unique_ptr<float[]> weights(new float[all_taps]());
  const std::unique_ptr<uint32_t[]> indices(new uint32_t[all_taps]());
  for (size_t t = 0; t < all_taps; ++t) {
    // Mostly probes that there are, and a few others.
    indices[t] = input.ConsumeIntegral<uint8_t>();
    if (indices[t] >= 2 * kMaxCount) indices[t] = GAUNT_NO_PROBE - (255 - indices[t]);
    if (!any_weight) weights[t] = 4e9f / 127.0f * input.ConsumeIntegral<int8_t>();
  }
  if (any_weight) input.ConsumeData(weights.get(), all_taps * sizeof(float));
  GAUNT_FUZZ_CHECK(gaunt_probe_gather(format.id, order, count, taps, indices.get(), weights.get(),
                                      packed, packed_count, format.stride, out.view()) == GAUNT_OK);
  if (!any_weight && format.id != GAUNT_FORMAT_SH3_F32) GAUNT_FUZZ_CHECK(out.All(IsFinite));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  FuzzedDataProvider input(data, size);
  const Format format = ConsumeFormat(input);
  const auto count = input.ConsumeIntegralInRange<size_t>(0, kMaxCount);
  const ExactBatch out(input, count, format.planes);
  const ExactBytes packed(input, RecordBytes(format, count));
  GAUNT_FUZZ_CHECK(gaunt_probe_decode(format.id, count, packed.data(), format.stride, out.view()) ==
                   GAUNT_OK);
  if (format.id != GAUNT_FORMAT_SH3_F32) GAUNT_FUZZ_CHECK(out.All(IsFinite));
  Gather(input, format, packed.data(), count);
  return 0;
}
