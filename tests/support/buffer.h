// SPDX-License-Identifier: MIT
// Batches in memory for tests, in any layout, with canaries in every byte that is not an element.
#ifndef GAUNT_TESTS_SUPPORT_BUFFER_H_
#define GAUNT_TESTS_SUPPORT_BUFFER_H_

#include <cstddef>
#include <string>
#include <vector>

#include "gaunt/gaunt.h"

namespace gaunt::test {

enum class Layout {
  kPlanar,
  kPlanarPowerOfTwo,  // 4 KiB from plane to plane
  kInterleaved,
  kRecord,     // interleaved, with other fields around
  kTiled,      // tiles of 16
  kOddTiles,   // tiles of 5, which no vector fits
  kBackwards,  // negative item stride
  kScattered,  // no stride is that of a neighbour
  kBroadcast   // one item for all: for inputs
};

// Where the first element lies: anywhere, or on a cache line, as each plane of kPlanar then does.
enum class Start { kAnywhere, kLine };

// Every layout that outputs can have too.
const std::vector<Layout>& Layouts();
std::string Name(Layout layout);

class Buffer {
 public:
  Buffer(Layout layout, size_t count, size_t planes, Start start = Start::kAnywhere);
  // A copy has memory, and so a view, of its own.
  Buffer(const Buffer& other);
  Buffer(Buffer&&) = default;
  Buffer& operator=(const Buffer&) = delete;

  const gaunt_view* view() const { return &view_; }
  float Get(size_t item, size_t plane) const;
  void Set(size_t item, size_t plane, float value);
  // All bytes; equal before and after means that nothing was written.
  const std::vector<float>& memory() const { return memory_; }
  // Elements may have changed, other bytes must not.
  bool CanariesIntact() const;

 private:
  size_t Index(size_t item, size_t plane) const;

  size_t count_;
  size_t planes_;
  gaunt_view view_;
  std::vector<float> memory_;
};

}  // namespace gaunt::test

#endif  // GAUNT_TESTS_SUPPORT_BUFFER_H_
