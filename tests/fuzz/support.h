// SPDX-License-Identifier: MIT
// What the fuzzers share: memory that ends where the data does, in the heap, so that the address
// sanitizer finds every access outside, and checks that end the program.
#ifndef GAUNT_TESTS_FUZZ_SUPPORT_H_
#define GAUNT_TESTS_FUZZ_SUPPORT_H_

#include <fuzzer/FuzzedDataProvider.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "gaunt/gaunt.h"

// A crash is what the fuzzer looks for, and keeps the input of.
#define GAUNT_FUZZ_CHECK(condition)                                                \
  do {                                                                             \
    if (!(condition)) {                                                            \
      std::fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #condition); \
      std::abort();                                                                \
    }                                                                              \
  } while (false)

namespace gaunt::fuzz {

// Bytes of the input; where it has no more, 0.
class ExactBytes {
 public:
  ExactBytes(FuzzedDataProvider& input, size_t size) : memory_(new uint8_t[size]), size_(size) {
    const size_t taken = input.ConsumeData(memory_.get(), size);
    std::memset(memory_.get() + taken, 0, size - taken);
  }
  uint8_t* data() const { return memory_.get(); }
  size_t size() const { return size_; }

 private:
  std::unique_ptr<uint8_t[]> memory_;
  size_t size_;
};

// A batch in a layout of the input's choice: interleaved and planar without room behind, tiled in
// whole tiles, as the API asks for it.
class ExactBatch {
 public:
  ExactBatch(FuzzedDataProvider& input, size_t count, size_t planes) {
    const size_t layout = input.ConsumeIntegralInRange<size_t>(0, 2);
    const size_t tiles = (count + GAUNT_TILE_ITEMS - 1) / GAUNT_TILE_ITEMS;
    size_ = planes * (layout == 2 ? tiles * GAUNT_TILE_ITEMS : count);
    floats_.reset(new float[size_]());
    gaunt_view_interleaved(floats_.get(), planes, &view_);
    if (layout == 1) view_ = {floats_.get(), 4, static_cast<ptrdiff_t>(4 * count), 0, 0};
    if (layout == 2) gaunt_view_tiled(floats_.get(), planes, &view_);
  }
  const gaunt_view* view() const { return &view_; }
  float* data() const { return floats_.get(); }
  size_t size() const { return size_; }
  // Any bits.
  void Fill(FuzzedDataProvider& input) const {
    input.ConsumeData(floats_.get(), size_ * sizeof(float));
  }
  template <class Predicate>
  bool All(Predicate predicate) const {
    return std::all_of(floats_.get(), floats_.get() + size_, predicate);
  }

 private:
  std::unique_ptr<float[]> floats_;
  size_t size_;
  gaunt_view view_;
};

struct Format {
  uint32_t id;
  size_t bytes, planes, stride;
  uint32_t order;
};
// Any that there is, with any small gap between records.
inline Format ConsumeFormat(FuzzedDataProvider& input) {
  static const uint32_t count = [] {
    gaunt_format_properties properties = {sizeof(properties), 0, 0, 0};
    uint32_t formats = 0;
    while (gaunt_format_info(formats + 1, &properties) == GAUNT_OK) ++formats;
    return formats;
  }();
  Format format = {};
  format.id = input.ConsumeIntegralInRange<uint32_t>(1, count);
  gaunt_format_properties properties = {sizeof(properties), 0, 0, 0};
  GAUNT_FUZZ_CHECK(gaunt_format_info(format.id, &properties) == GAUNT_OK);
  format.bytes = properties.bytes;
  format.planes = properties.planes;
  format.order = properties.order;
  format.stride = format.bytes + input.ConsumeIntegralInRange<size_t>(0, 9);
  return format;
}

// Bytes of records, of which nothing follows the last.
inline size_t RecordBytes(const Format& format, size_t count) {
  return count == 0 ? 0 : (count - 1) * format.stride + format.bytes;
}

constexpr size_t kMaxCount = 40;  // some vectors and a tail on every target

}  // namespace gaunt::fuzz

#endif  // GAUNT_TESTS_FUZZ_SUPPORT_H_
