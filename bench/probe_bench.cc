// SPDX-License-Identifier: MIT
#include "bench/support.h"

namespace gaunt::bench {

GAUNT_BENCHMARKS(probe) {
  constexpr size_t kProbes = 2048, kBytes = 28;
  // Records of mid-range means and every kind of ratio.
  const auto packed = std::make_shared<std::vector<uint8_t>>(kLarge * kBytes);
  for (size_t k = 0; k < packed->size(); ++k) {
    (*packed)[k] = static_cast<uint8_t>(k % kBytes == 3 ? 0x7C : k * 2654435761u >> 7);
  }
  BatchBenchmark batch;
  batch.name = "probe/decode/n3";
  batch.operations = OperationsOf("probe_decode", "3", "sh3_28");
  batch.outputs = {27};
  batch.more_read = kBytes;
  batch.call = [=](size_t count, const BatchBenchmark::Views&, const BatchBenchmark::Views& out) {
    return gaunt_probe_decode(GAUNT_FORMAT_SH3_28, count, packed->data(), kBytes, out[0]);
  };
  RegisterBatch(batch);

  const auto indices = std::make_shared<std::vector<uint32_t>>(kLarge * 8);
  const auto weights = std::make_shared<std::vector<float>>(kLarge * 8, 0.125f);
  for (size_t i = 0; i < kLarge; ++i) {
    const uint32_t corner = static_cast<uint32_t>(i * 2654435761u >> 9) % (kProbes - 146);
    for (uint32_t t = 0; t < 8; ++t) {
      (*indices)[8 * i + t] = corner + (t & 1) + 16 * (t >> 1 & 1) + 128 * (t >> 2);
    }
  }
  batch.name = "probe/gather8/n3";
  batch.operations = OperationsOf("probe_gather", "3", "sh3_28_8_taps");
  batch.more_read = 8 * (kBytes + sizeof(uint32_t) + sizeof(float));
  batch.call = [=](size_t count, const BatchBenchmark::Views&, const BatchBenchmark::Views& out) {
    return gaunt_probe_gather(GAUNT_FORMAT_SH3_28, 3, count, 8, indices->data(), weights->data(),
                              packed->data(), kProbes, kBytes, out[0]);
  };
  RegisterBatch(batch);

  const auto records = std::make_shared<std::vector<uint8_t>>(kLarge * kBytes);
  batch = {};
  batch.name = "probe/encode/n3";
  batch.operations = OperationsOf("probe_encode", "3", "sh3_28");
  batch.inputs = {27};
  batch.more_written = kBytes;
  batch.make = [](size_t item, size_t, float* planes) {
    for (size_t p = 0; p < 27; ++p) {
      planes[p] = p % 9 == 0 ? 1.0f : static_cast<float>((item * 7 + p * 13) % 29) / 29.0f;
    }
  };
  batch.call = [=](size_t count, const BatchBenchmark::Views& in, const BatchBenchmark::Views&) {
    return gaunt_probe_encode(GAUNT_FORMAT_SH3_28, count, in[0], records->data(), kBytes, nullptr);
  };
  RegisterBatch(batch);
}

}  // namespace gaunt::bench
