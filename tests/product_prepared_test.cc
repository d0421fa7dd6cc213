// SPDX-License-Identifier: MIT
// Products with a prepared function, and the bytes that it is prepared to.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>

#include "gaunt/gaunt.h"
#include "gaunt/gaunt.hpp"
#include "tests/product_items.h"
#include "tests/support/guarded.h"
#include "tests/support/operation.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

constexpr uint32_t kMaxOrder = GAUNT_MAX_PRODUCT_ORDER;
constexpr unsigned char kCanary = 0xA5;

using Bytes = std::vector<unsigned char>;

// By factor a of the orders.
Bytes Prepared(const Orders& n, const Floats& f) {
  return ProductPrepare(n.a, n.b, n.out, ViewOf(f, n.a));
}

Floats Applied(const Orders& n, const unsigned char* op, size_t op_size, const Floats& in) {
  const size_t count = in.size() / (n.b * n.b);
  Floats out(count * n.out * n.out);
  const gaunt_view vi = ViewOf(in, n.b), vo = ViewOf(out, n.out);
  EXPECT_EQ(gaunt_product_apply(op, op_size, 1, count, &vi, &vo), GAUNT_OK);
  return out;
}

Floats FunctionOf(const Orders& n) {
  Random random(100 * n.a + 10 * n.b + n.out);
  return RandomItems(random, n.a * n.a);
}

// With one function of these orders.
Operation ApplyOperation(const Orders& n, uint32_t channels) {
  const size_t in = n.b * n.b, out = n.out * n.out;
  const Floats f = FunctionOf(n);
  const Bytes op = Prepared(n, f);
  Operation operation;
  operation.name = "product_apply/" + Name(n) + "/channels" + std::to_string(channels);
  operation.inputs = {channels * in};
  operation.outputs = {channels * out};
  operation.call = [=](size_t count, const Operation::Views& i, const Operation::Views& o) {
    return gaunt_product_apply(op.data(), op.size(), channels, count, i[0], o[0]);
  };
  operation.make = [=](Random& random, size_t, float* planes) {
    random.Fill(planes, channels * in, -1.0, 1.0);
  };
  operation.reference = [=](const Operation::Item& i, Operation::Item& o) {
    const std::vector<double> exact(f.begin(), f.end());
    for (uint32_t c = 0; c < channels; ++c) {
      product::ProductReference(static_cast<int>(n.a), static_cast<int>(n.b),
                                static_cast<int>(n.out), exact.data(), i[0].data() + c * in,
                                o[0].data() + c * out);
    }
  };
  operation.tolerance = [=](const Operation::Item& i, const Operation::Item&, size_t, size_t p) {
    return ProductTolerance(n.a, n.b) * Norm(f) * Norm(i[0].data() + p / out * in, in);
  };
  if (n.out == n.b) operation.in_place = {0};
  return operation;
}

float* At(const gaunt_view& view, size_t item, size_t plane) {
  const ptrdiff_t bytes = static_cast<ptrdiff_t>(item) * view.item_stride +
                          static_cast<ptrdiff_t>(plane) * view.plane_stride;
  return view.data + bytes / static_cast<ptrdiff_t>(sizeof(float));
}

// The bytes as planes of an output, for their hash.
Operation PrepareOperation(const Orders& n) {
  size_t size = 0;
  EXPECT_EQ(gaunt_product_prepare(n.a, n.b, n.out, nullptr, nullptr, &size), GAUNT_OK);
  EXPECT_EQ(size % sizeof(float), 0u);
  Operation operation;
  operation.name = "product_prepare/" + Name(n);
  operation.inputs = {n.a * n.a};
  operation.outputs = {size / sizeof(float)};
  operation.call = [=](size_t count, const Operation::Views& in, const Operation::Views& out) {
    for (size_t i = 0; i < count; ++i) {
      gaunt_view f = *in[0];
      f.data = At(f, i, 0);
      size_t capacity = size;
      Bytes op(size);
      const gaunt_status status = gaunt_product_prepare(n.a, n.b, n.out, &f, op.data(), &capacity);
      if (status != GAUNT_OK) return status;
      for (size_t p = 0; p < size / sizeof(float); ++p) {
        std::memcpy(At(*out[0], i, p), op.data() + p * sizeof(float), sizeof(float));
      }
    }
    return gaunt_status{GAUNT_OK};
  };
  operation.make = [=](Random& random, size_t, float* planes) {
    random.Fill(planes, n.a * n.a, -1.0, 1.0);
  };
  return operation;
}

const std::vector<Orders> kMixedOrders = {{6, 6, 3}, {2, 6, 6}, {6, 3, 6}, {1, 4, 4},
                                          {4, 1, 4}, {3, 3, 5}, {7, 3, 5}, {10, 10, 19}};

class ProductPrepared : public TargetTest {};

TEST_P(ProductPrepared, MatchesTheDefinitionInEveryLayout) {
  for (uint32_t n = 1; n <= kMaxOrder; ++n) TestBatches(ApplyOperation({n, n, n}, 1));
  for (const Orders& n : kMixedOrders) TestBatches(ApplyOperation(n, 1));
}

TEST_P(ProductPrepared, ChannelsMatchTheDefinitionInEveryLayout) {
  for (const uint32_t n : {1u, 3u, 4u, 6u, 7u}) TestBatches(ApplyOperation({n, n, n}, 3));
  for (const uint32_t n : {2u, 3u}) TestBatches(ApplyOperation({n, n, n}, 4));
  TestBatches(ApplyOperation({6, 6, 3}, 3));
}

// All 1000 triples of orders. The number of bytes is asked for first, and is all that is written.
TEST_P(ProductPrepared, HasEveryOrder) {
  Random random(3);
  for (uint32_t n_f = 1; n_f <= kMaxOrder; ++n_f) {
    for (uint32_t n_in = 1; n_in <= kMaxOrder; ++n_in) {
      const Floats f = RandomItems(random, n_f * n_f), in = RandomItems(random, n_in * n_in);
      const double tolerance = ProductTolerance(n_f, n_in) * Norm(f) * Norm(in);
      const gaunt_view vf = ViewOf(f, n_f);
      const uint32_t all = n_f + n_in - 1;
      const std::vector<double> wanted = ExactProduct({n_f, n_in, all}, f.data(), in.data());
      for (uint32_t n_out = 1; n_out <= all; ++n_out) {
        const Orders n = {n_f, n_in, n_out};
        SCOPED_TRACE(Name(n));
        size_t size = 0;
        ASSERT_EQ(gaunt_product_prepare(n_f, n_in, n_out, nullptr, nullptr, &size), GAUNT_OK);
        const size_t capacity = size + 64;
        Bytes op(capacity, kCanary);
        size_t written = capacity;
        ASSERT_EQ(gaunt_product_prepare(n_f, n_in, n_out, &vf, op.data(), &written), GAUNT_OK);
        ASSERT_EQ(written, size);
        ASSERT_EQ(std::count(op.begin() + static_cast<ptrdiff_t>(size), op.end(), kCanary), 64);
        const Floats out = Applied(n, op.data(), size, in);
        for (size_t k = 0; k < out.size(); ++k) ASSERT_NEAR(out[k], wanted[k], tolerance) << k;
      }
    }
  }
}

TEST_P(ProductPrepared, RejectsWrongArguments) {
  for (const Orders& n : {Orders{3, 3, 3}, {6, 6, 6}, {6, 6, 3}, {2, 6, 6}, {8, 7, 9}}) {
    TestErrors(ApplyOperation(n, 3));
  }
  const Orders n = {4, 3, 5};
  const Floats f = FunctionOf(n), in(9);
  Floats out(25, 7.0f);
  const gaunt_view vf = ViewOf(f, n.a), vi = ViewOf(in, n.b), vo = ViewOf(out, n.out);
  Bytes op = Prepared(n, f);
  const Bytes untouched(op.size(), kCanary);

  for (const uint32_t bad : {0u, 11u, UINT32_MAX}) {
    size_t size = 77;
    EXPECT_EQ(gaunt_product_prepare(bad, 3, 3, &vf, nullptr, &size), GAUNT_ERROR_ORDER);
    EXPECT_EQ(gaunt_product_prepare(3, bad, 3, &vf, nullptr, &size), GAUNT_ERROR_ORDER);
    EXPECT_EQ(gaunt_product_prepare(3, 3, bad, &vf, nullptr, &size), GAUNT_ERROR_ORDER);
    EXPECT_EQ(gaunt_product_prepare(2, 3, 5, &vf, nullptr, &size), GAUNT_ERROR_ORDER);
    EXPECT_EQ(size, 77u);
  }
  EXPECT_EQ(gaunt_product_prepare(4, 3, 5, &vf, op.data(), nullptr), GAUNT_ERROR_NULL);
  EXPECT_EQ(gaunt_product_prepare(4, 3, 5, nullptr, nullptr, nullptr), GAUNT_ERROR_NULL);
  const auto prepare = [&](const gaunt_view* view, size_t capacity) {
    Bytes bytes = untouched;
    size_t size = capacity;
    const gaunt_status status = gaunt_product_prepare(4, 3, 5, view, bytes.data(), &size);
    EXPECT_EQ(bytes, untouched);
    EXPECT_EQ(size, capacity);
    return status;
  };
  for (const size_t capacity : {size_t{0}, size_t{1}, op.size() - 1}) {
    EXPECT_EQ(prepare(&vf, capacity), GAUNT_ERROR_RANGE) << capacity;
  }
  EXPECT_EQ(prepare(nullptr, op.size()), GAUNT_ERROR_NULL);
  gaunt_view bad = vf;
  bad.data = nullptr;
  EXPECT_EQ(prepare(&bad, op.size()), GAUNT_ERROR_NULL);
  bad = vf;
  bad.plane_stride = 6;
  EXPECT_EQ(prepare(&bad, op.size()), GAUNT_ERROR_LAYOUT);
  bad = vf;
  bad.data = reinterpret_cast<float*>(reinterpret_cast<char*>(bad.data) + 2);
  EXPECT_EQ(prepare(&bad, op.size()), GAUNT_ERROR_LAYOUT);
  bad = vf;
  bad.plane_stride = PTRDIFF_MAX - 3;
  EXPECT_EQ(prepare(&bad, op.size()), GAUNT_ERROR_RANGE);

  // The bytes, their number and the function lie apart.
  Floats shared(op.size() / sizeof(float) + 32, 1.0f);
  const Floats before = shared;
  const gaunt_view inside = ViewOf(shared, n.a);
  size_t size = op.size();
  for (const size_t offset : {size_t{0}, size_t{15}}) {
    EXPECT_EQ(gaunt_product_prepare(4, 3, 5, &inside, shared.data() + offset, &size),
              GAUNT_ERROR_OVERLAP);
  }
  std::vector<size_t> words(op.size() / sizeof(size_t) + 1);
  words[3] = op.size();
  const std::vector<size_t> words_before = words;
  EXPECT_EQ(gaunt_product_prepare(4, 3, 5, &vf, words.data(), &words[3]), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(words, words_before);
  EXPECT_EQ(shared, before);
  EXPECT_EQ(gaunt_product_prepare(4, 3, 5, &inside, shared.data() + 16, &size), GAUNT_OK);

  const auto apply = [&](const void* bytes, size_t bytes_size, uint32_t channels,
                         const gaunt_view* to) {
    const gaunt_status status = gaunt_product_apply(bytes, bytes_size, channels, 1, &vi, to);
    EXPECT_EQ(out, Floats(25, 7.0f));
    return status;
  };
  EXPECT_EQ(apply(nullptr, op.size(), 1, &vo), GAUNT_ERROR_NULL);
  EXPECT_EQ(apply(op.data(), op.size(), 0, &vo), GAUNT_ERROR_RANGE);
  EXPECT_EQ(apply(op.data(), op.size(), 5, &vo), GAUNT_ERROR_RANGE);
  // An output where the bytes are.
  Floats aligned(op.size() / sizeof(float));
  std::memcpy(aligned.data(), op.data(), op.size());
  const gaunt_view over = ViewOf(aligned, n.out);
  EXPECT_EQ(apply(aligned.data(), op.size(), 1, &over), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(std::memcmp(aligned.data(), op.data(), op.size()), 0);
  // Other orders than the input's are no place for the output.
  EXPECT_EQ(gaunt_product_apply(op.data(), op.size(), 1, 1, &vo, &vo), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(out, Floats(25, 7.0f));
  EXPECT_EQ(gaunt_product_apply(op.data(), op.size(), 1, 0, nullptr, nullptr), GAUNT_OK);
}

TEST_P(ProductPrepared, RejectsBytesThatAreNot) {
  for (const Orders& n : {Orders{1, 1, 1}, {3, 3, 3}, {4, 3, 5}, {6, 6, 6}, {10, 10, 19}}) {
    SCOPED_TRACE(Name(n));
    const Bytes op = Prepared(n, FunctionOf(n));
    const Floats in(n.b * n.b);
    Floats out(n.out * n.out, 7.0f);
    const gaunt_view vi = ViewOf(in, n.b), vo = ViewOf(out, n.out);
    const auto apply = [&](const void* bytes, size_t size) {
      const gaunt_status status = gaunt_product_apply(bytes, size, 1, 1, &vi, &vo);
      EXPECT_EQ(out, Floats(out.size(), 7.0f));
      return status;
    };
    // Cut off, at the end of memory, and too long.
    for (const size_t size :
         {size_t{0}, size_t{1}, size_t{4}, size_t{23}, size_t{24}, op.size() - 4, op.size() - 1}) {
      const GuardedBytes cut(size);
      std::memcpy(cut.data(), op.data(), size);
      EXPECT_EQ(apply(cut.data(), size), GAUNT_ERROR_FORMAT) << size;
    }
    Bytes longer = op;
    longer.resize(op.size() + 8);
    EXPECT_EQ(apply(longer.data(), op.size() + 1), GAUNT_ERROR_FORMAT);
    EXPECT_EQ(apply(longer.data(), op.size() + 4), GAUNT_ERROR_FORMAT);
    EXPECT_EQ(apply(longer.data(), SIZE_MAX), GAUNT_ERROR_FORMAT);
    // A header of another kind, version, magic number or byte order, and orders that are none.
    for (size_t byte = 0; byte < 24; ++byte) {
      Bytes wrong = op;
      wrong[byte] ^= 0xFF;
      EXPECT_EQ(apply(wrong.data(), wrong.size()), GAUNT_ERROR_FORMAT) << byte;
    }
    for (size_t bit = 0; bit < 64; ++bit) {
      Bytes wrong = op;
      wrong[bit / 8] ^= static_cast<unsigned char>(1 << bit % 8);
      EXPECT_EQ(apply(wrong.data(), wrong.size()), GAUNT_ERROR_FORMAT) << bit;
    }
    for (size_t word = 2; word < 5; ++word) {
      for (const uint32_t order : {0u, 11u, 20u, UINT32_MAX}) {
        Bytes wrong = op;
        std::memcpy(wrong.data() + 4 * word, &order, sizeof(order));
        EXPECT_EQ(apply(wrong.data(), wrong.size()), GAUNT_ERROR_FORMAT) << word << " " << order;
      }
    }
    Bytes swapped = op;
    for (size_t byte = 0; byte < 24; byte += 4) {
      std::reverse(swapped.begin() + static_cast<ptrdiff_t>(byte),
                   swapped.begin() + static_cast<ptrdiff_t>(byte) + 4);
    }
    EXPECT_EQ(apply(swapped.data(), swapped.size()), GAUNT_ERROR_FORMAT);
    const Bytes zeros(op.size());
    EXPECT_EQ(apply(zeros.data(), zeros.size()), GAUNT_ERROR_FORMAT);
  }
}

// Copies at any address and at the very end of memory give the same bits.
TEST_P(ProductPrepared, BytesMayLieAnywhere) {
  Random random(5);
  for (const Orders& n : {Orders{2, 2, 2}, {5, 5, 5}, {6, 6, 6}, {6, 6, 3}, {10, 10, 10}}) {
    const Floats f = FunctionOf(n), in = RandomItems(random, 37 * n.b * n.b);
    const Bytes op = Prepared(n, f);
    const Floats wanted = Applied(n, op.data(), op.size(), in);
    for (size_t offset = 0; offset < 4; ++offset) {
      const GuardedBytes memory(op.size() + offset);
      unsigned char* const moved = reinterpret_cast<unsigned char*>(memory.data());
      std::memcpy(moved, op.data(), op.size());
      EXPECT_EQ(Applied(n, moved, op.size(), in), wanted) << Name(n) << " " << offset;
      // They are written anywhere, too.
      std::memset(moved, 0, op.size());
      const gaunt_view vf = ViewOf(f, n.a);
      size_t size = op.size();
      ASSERT_EQ(gaunt_product_prepare(n.a, n.b, n.out, &vf, moved, &size), GAUNT_OK);
      EXPECT_EQ(std::memcmp(moved, op.data(), size), 0) << Name(n) << " " << offset;
    }
  }
}

// One function is taken from any layout, and nothing else is read.
TEST_P(ProductPrepared, TakesTheFunctionFromAnyView) {
  const Orders n = {6, 6, 6};
  const Floats f = FunctionOf(n);
  const Bytes wanted = Prepared(n, f);
  for (const ptrdiff_t stride : {1, 3, 16, -1, -2}) {
    const size_t step = static_cast<size_t>(std::abs(stride));
    Floats spread(36 * step, std::numeric_limits<float>::quiet_NaN());
    for (size_t p = 0; p < 36; ++p) spread[step * (stride < 0 ? 35 - p : p)] = f[p];
    gaunt_view view = ViewOf(spread, n.a);
    view.data += stride < 0 ? 35 * step : 0;
    view.plane_stride = stride * static_cast<ptrdiff_t>(sizeof(float));
    view.item_stride = 0;
    EXPECT_EQ(ProductPrepare(6, 6, 6, view), wanted) << stride;
    view.item_stride = PTRDIFF_MIN;  // there is no other item
    EXPECT_EQ(ProductPrepare(6, 6, 6, view), wanted) << stride;
  }
}

TEST_P(ProductPrepared, KeepsANumberThatIsNone) {
  Random random(8);
  for (const Orders& n : {Orders{2, 2, 2}, {5, 5, 5}, {6, 6, 6}}) {
    const Floats nan(n.a * n.a, std::numeric_limits<float>::quiet_NaN());
    const Bytes op = Prepared(n, nan);
    for (const float x : Applied(n, op.data(), op.size(), RandomItems(random, 20 * n.b * n.b))) {
      ASSERT_TRUE(std::isnan(x)) << Name(n);
    }
  }
}

TEST_P(ProductPrepared, IsTheProductWithABroadcast) {
  Random random(12);
  for (uint32_t n = 1; n <= kMaxOrder; ++n) {
    const Orders orders = {n, n, n};
    const Floats f = FunctionOf(orders), in = RandomItems(random, 20 * n * n);
    Floats out(in.size());
    gaunt_view vf;
    gaunt_view_broadcast(const_cast<float*>(f.data()), &vf);
    const gaunt_view vi = ViewOf(in, n), vo = ViewOf(out, n);
    ASSERT_EQ(gaunt_product(n, n, n, 1, 20, &vf, &vi, &vo), GAUNT_OK);
    const Bytes op = Prepared(orders, f);
    const Floats applied = Applied(orders, op.data(), op.size(), in);
    for (size_t k = 0; k < out.size(); ++k) {
      const double norm = Norm(f) * Norm(in.data() + k / (n * n) * n * n, n * n);
      ASSERT_NEAR(applied[k], out[k], 2.0 * ProductTolerance(n, n) * norm) << "order " << n;
    }
  }
}

// The bytes too: a file of one machine serves them all.
TEST(ProductPreparedBits, AreTheSameOnTargetsOfAClass) {
  for (uint32_t n = 1; n <= kMaxOrder; ++n) {
    TestSameBits(ApplyOperation({n, n, n}, 1));
    TestSameBits(PrepareOperation({n, n, n}));
  }
  for (const Orders& n : kMixedOrders) {
    TestSameBits(ApplyOperation(n, 1));
    TestSameBits(PrepareOperation(n));
  }
  TestSameBits(ApplyOperation({6, 6, 6}, 3));
}

TEST(ProductPreparedBits, BytesAreTheSameOnEveryTarget) {
  for (const Orders& n : {Orders{3, 3, 3}, {6, 6, 6}, {6, 6, 3}, {10, 10, 10}}) {
    Bytes first;
    for (const std::string& target : SupportedTargets()) {
      ASSERT_EQ(gaunt_target_select(target.c_str()), GAUNT_OK);
      const Bytes op = Prepared(n, FunctionOf(n));
      if (first.empty()) first = op;
      EXPECT_EQ(op, first) << Name(n) << " on " << target;
    }
  }
  gaunt_target_select(nullptr);
}

GAUNT_INSTANTIATE_TARGETS(ProductPrepared);

}  // namespace
}  // namespace gaunt::test
