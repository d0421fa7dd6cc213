// SPDX-License-Identifier: MIT
// Any floats as probes: what they are packed to decodes to numbers, and nothing beside the records
// is written.
#include <cmath>

#include "tests/fuzz/support.h"

using namespace gaunt::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  FuzzedDataProvider input(data, size);
  const Format format = ConsumeFormat(input);
  const auto count = input.ConsumeIntegralInRange<size_t>(0, kMaxCount);
  const ExactBatch probes(input, count, format.planes), decoded(input, count, format.planes),
      report(input, count, GAUNT_REPORT_PLANES);
  const bool with_report = input.ConsumeBool();
  // Refinement takes long, so it is rare.
  const auto encode =
      input.ConsumeIntegralInRange(0, 255) == 0 ? gaunt_probe_encode_refined : gaunt_probe_encode;
  probes.Fill(input);

  constexpr uint8_t kGap = 0xa5;
  const size_t bytes = RecordBytes(format, count);
  const std::unique_ptr<uint8_t[]> packed(new uint8_t[bytes]);
  std::memset(packed.get(), kGap, bytes);
  GAUNT_FUZZ_CHECK(encode(format.id, count, probes.view(), packed.get(), format.stride,
                          with_report ? report.view() : nullptr) == GAUNT_OK);
  for (size_t i = 0; i + 1 < count; ++i) {
    for (size_t at = format.bytes; at < format.stride; ++at) {
      GAUNT_FUZZ_CHECK(packed[i * format.stride + at] == kGap);
    }
  }
  GAUNT_FUZZ_CHECK(gaunt_probe_decode(format.id, count, packed.get(), format.stride,
                                      decoded.view()) == GAUNT_OK);
  GAUNT_FUZZ_CHECK(decoded.All([&](float value) {
    return format.id == GAUNT_FORMAT_SH3_F32 ? !std::isnan(value) : std::isfinite(value);
  }));
  if (with_report && probes.All([](float value) { return std::isfinite(value); })) {
    GAUNT_FUZZ_CHECK(report.All([](float value) { return value >= 0.0f; }));
  }
  return 0;
}
