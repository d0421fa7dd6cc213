// SPDX-License-Identifier: MIT
#include <cstring>

#include "bench/support.h"
#include "format_table.h"

namespace gaunt::bench {
namespace {

// Means of 1 and every kind of ratio.
void MakeProbe(size_t item, size_t size, float* planes) {
  for (size_t p = 0; p < 3 * size; ++p) {
    planes[p] = p % size == 0 ? 1.0f : static_cast<float>((item * 7 + p * 13) % 29) / 29.0f;
  }
}

// As many bytes as a decoder writes, copied: what it can be measured by.
void RegisterCopy(const std::string& name, size_t planes) {
  ScalarBenchmark copy;
  copy.name = name;
  copy.baseline = "memcpy";
  copy.inputs = {planes};
  copy.output = planes;
  copy.large = true;
  copy.call = [=](size_t count, const std::vector<const float*>& in, float* out) {
    std::memcpy(out, in[0], count * planes * sizeof(float));
    benchmark::ClobberMemory();
  };
  RegisterScalar(copy);
}

void RegisterFormat(const tool::FormatName& format) {
  constexpr size_t kProbes = 2048;
  gaunt_format_properties properties = {sizeof(properties), 0, 0, 0};
  gaunt_format_info(format.format, &properties);
  const size_t bytes = properties.bytes, planes = properties.planes;
  const std::string name = format.name, order = std::to_string(properties.order);
  const std::string suffix = "_" + name + "/n" + order;

  // The same thousand, over and over.
  const auto packed = std::make_shared<std::vector<uint8_t>>();
  {
    constexpr size_t kDifferent = 1024;
    std::vector<float> probes(kDifferent * planes);
    for (size_t i = 0; i < kDifferent; ++i) MakeProbe(i, planes / 3, &probes[i * planes]);
    gaunt_view view;
    gaunt_view_interleaved(probes.data(), planes, &view);
    std::vector<uint8_t> records(kDifferent * bytes);
    gaunt_probe_encode(format.format, kDifferent, &view, records.data(), bytes, nullptr);
    while (packed->size() < kLarge * bytes) {
      packed->insert(packed->end(), records.begin(), records.end());
    }
  }
  BatchBenchmark batch;
  batch.name = "probe/decode" + suffix;
  batch.operations = OperationsOf("probe_decode", order, name);
  batch.outputs = {planes};
  batch.more_read = bytes;
  batch.large = true;
  batch.call = [=](size_t count, const BatchBenchmark::Views&, const BatchBenchmark::Views& out) {
    return gaunt_probe_decode(format.format, count, packed->data(), bytes, out[0]);
  };
  RegisterBatch(batch);
  RegisterCopy(batch.name, planes);
  batch.large = false;

  const auto indices = std::make_shared<std::vector<uint32_t>>(kLarge * 8);
  const auto weights = std::make_shared<std::vector<float>>(kLarge * 8, 0.125f);
  for (size_t i = 0; i < kLarge; ++i) {
    const uint32_t corner = static_cast<uint32_t>(i * 2654435761u >> 9) % (kProbes - 146);
    for (uint32_t t = 0; t < 8; ++t) {
      (*indices)[8 * i + t] = corner + (t & 1) + 16 * (t >> 1 & 1) + 128 * (t >> 2);
    }
  }
  batch.name = "probe/gather8" + suffix;
  batch.operations = OperationsOf("probe_gather", order, name + "_8_taps");
  batch.more_read = 8 * (bytes + sizeof(uint32_t) + sizeof(float));
  batch.call = [=](size_t count, const BatchBenchmark::Views&, const BatchBenchmark::Views& out) {
    return gaunt_probe_gather(format.format, properties.order, count, 8, indices->data(),
                              weights->data(), packed->data(), kProbes, bytes, out[0]);
  };
  RegisterBatch(batch);

  const auto records = std::make_shared<std::vector<uint8_t>>(kLarge * bytes);
  batch = {};
  batch.name = "probe/encode" + suffix;
  batch.operations = OperationsOf("probe_encode", order, name);
  batch.inputs = {planes};
  batch.more_written = bytes;
  batch.make = [=](size_t item, size_t, float* p) { MakeProbe(item, planes / 3, p); };
  batch.call = [=](size_t count, const BatchBenchmark::Views& in, const BatchBenchmark::Views&) {
    return gaunt_probe_encode(format.format, count, in[0], records->data(), bytes, nullptr);
  };
  RegisterBatch(batch);
}

}  // namespace

GAUNT_BENCHMARKS(probe) {
  for (const tool::FormatName& format : tool::kFormatNames) RegisterFormat(format);
}

}  // namespace gaunt::bench
