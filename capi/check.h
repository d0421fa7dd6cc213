// SPDX-License-Identifier: MIT
// Validation of the C API's arguments, in constant time, before anything is written.
#ifndef GAUNT_CAPI_CHECK_H_
#define GAUNT_CAPI_CHECK_H_

#include <cstddef>
#include <cstdint>

#include "gaunt/gaunt.h"
#include "simd/view.h"

// Leaves the function with `status` unless the condition holds.
#define GAUNT_REQUIRE(condition, status) \
  do {                                   \
    if (!(condition)) return status;     \
  } while (false)

// Leaves the function with the expression's status unless it is GAUNT_OK.
#define GAUNT_CHECK(expression)                                    \
  do {                                                             \
    const gaunt_status gaunt_check_status = (expression);          \
    if (gaunt_check_status != GAUNT_OK) return gaunt_check_status; \
  } while (false)

namespace gaunt::capi {

constexpr bool InRange(uint32_t value, uint32_t least, uint32_t most) {
  return value >= least && value <= most;
}

// Collects the memory that a call is going to touch and finds the first thing wrong with it. Inputs
// are added before outputs; statuses are looked for in the order NULL, LAYOUT, RANGE, OVERLAP.
class MemoryCheck {
 public:
  explicit MemoryCheck(size_t count) : count_(count) {}

  MemoryCheck& In(const gaunt_view* view, size_t planes);
  MemoryCheck& Out(const gaunt_view* view, size_t planes);
  // An output that may be the same view as an input of as many planes.
  MemoryCheck& OutInPlace(const gaunt_view* view, size_t planes);
  // An output of one item, whatever the count.
  MemoryCheck& OutItem(const gaunt_view* view, size_t planes);
  // `records` of `bytes` each, `stride` apart, any alignment.
  MemoryCheck& InRecords(const void* data, size_t records, size_t bytes, size_t stride);
  MemoryCheck& OutRecords(const void* data, size_t records, size_t bytes, size_t stride);

  gaunt_status status() const;

 private:
  // Bytes from .. to relative to an origin.
  struct Range {
    ptrdiff_t from, to;
  };
  struct Memory {
    uintptr_t origin;
    Range all;     // every element
    Range planes;  // elements of item 0
    Range tile;    // elements of the first tile
    ptrdiff_t item_stride, plane_stride, tile_stride;
    size_t plane_count, tile_items, tiles, items_in_tile;
    bool is_view;
  };
  enum class Kind { kIn, kOut, kOutInPlace };

  void AddView(const gaunt_view* view, size_t count, size_t planes, Kind kind);
  void AddRecords(const void* data, size_t records, size_t bytes, size_t stride, Kind kind);
  void Add(const Memory& memory, Kind kind);
  void Fail(gaunt_status status);

  static bool Nests(const Memory& memory);
  static bool Apart(const Memory& a, const Memory& b);
  static bool Same(const Memory& a, const Memory& b);

  static constexpr int kMost = 11;
  size_t count_;
  gaunt_status status_ = GAUNT_OK;
  Memory memories_[kMost];
  int used_ = 0;
};

// Views as the kernels' drivers take them. Strides that address nothing are made harmless.
simd::InView InputOf(const gaunt_view& view, size_t count);
simd::OutView OutputOf(const gaunt_view& view, size_t count);

}  // namespace gaunt::capi

#endif  // GAUNT_CAPI_CHECK_H_
