// SPDX-License-Identifier: MIT
// What every batched function of the library must do, tested from one description of the function.
#ifndef GAUNT_TESTS_SUPPORT_OPERATION_H_
#define GAUNT_TESTS_SUPPORT_OPERATION_H_

#include <functional>
#include <string>
#include <vector>

#include "gaunt/gaunt.h"
#include "tests/support/random.h"

namespace gaunt::test {

struct Operation {
  using Views = std::vector<const gaunt_view*>;
  using Item = std::vector<std::vector<double>>;  // [side][plane]

  std::string name;
  std::vector<size_t> inputs;   // planes of each input view
  std::vector<size_t> outputs;  // planes of each output view
  std::function<gaunt_status(size_t count, const Views& in, const Views& out)> call;
  // Fills one item of input `side`.
  std::function<void(Random& random, size_t side, float* planes)> make;
  // The definition, in double precision.
  std::function<void(const Item& in, Item& out)> reference;
  // Largest error allowed in a plane of an item's output `side`.
  std::function<double(const Item& in, const Item& wanted, size_t side, size_t plane)> tolerance;
  // Inputs that output 0 may be in place of.
  std::vector<size_t> in_place;
  // Whether an input that is one item for all gives the bits of as many equal items.
  bool broadcast_rounds_alike = true;
  // Items on top of every count, for functions that go another way from some count up.
  size_t extra_items = 0;
};

// Runs on the chosen target: every pair of layouts and counts around the lanes, against the
// definition; equal bits in all layouts; canaries and inputs untouched; nothing beyond the end of
// memory; each input broadcast; in place; a NaN stays in its item.
void TestBatches(const Operation& operation);

// Equal bits on all targets with fused multiply-add, and on all others: on this machine, and, by
// the hashes in tests/golden/bits.csv, on all machines. With GAUNT_WRITE_BITS=FILE in the
// environment, rows for that file are appended to FILE.
void TestSameBits(const Operation& operation);

// Each wrong view gives its status, and nothing is written.
void TestErrors(const Operation& operation);

}  // namespace gaunt::test

#endif  // GAUNT_TESTS_SUPPORT_OPERATION_H_
