// SPDX-License-Identifier: MIT
#include "tests/support/operation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <memory>

#include "tests/support/buffer.h"
#include "tests/support/golden.h"
#include "tests/support/guarded.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

constexpr size_t kMostItems = 83;

// Around the lanes of every target, and around whole stack tiles of the driver.
const std::vector<size_t> kCounts = {0, 1, 3, 4, 5, 7, 8, 9, 15, 16, 17, 33, kMostItems};

size_t Count(const Operation& operation, size_t count) { return count + operation.extra_items; }
size_t MostItems(const Operation& operation) { return Count(operation, kMostItems); }

using Values = std::vector<std::vector<std::vector<float>>>;  // [side][item][plane]

Values MakeInputs(const Operation& operation, size_t count) {
  Random random(count + operation.name.size());
  Values values(operation.inputs.size());
  for (size_t side = 0; side < values.size(); ++side) {
    for (size_t i = 0; i < count; ++i) {
      values[side].emplace_back(operation.inputs[side]);
      operation.make(random, side, values[side].back().data());
    }
  }
  return values;
}

Operation::Item ItemOf(const Values& inputs, size_t i) {
  Operation::Item item;
  for (const auto& side : inputs) item.emplace_back(side[i].begin(), side[i].end());
  return item;
}

bool SameBits(const float a, const float b) { return std::memcmp(&a, &b, sizeof(a)) == 0; }

struct Run {
  std::vector<Buffer> in, out;

  Run(const Operation& operation, size_t count, const std::vector<Layout>& in_layouts,
      Layout out_layout, const Values& inputs) {
    for (size_t s = 0; s < operation.inputs.size(); ++s) {
      in.emplace_back(in_layouts[s], count, operation.inputs[s]);
      for (size_t i = 0; i < count; ++i) {
        for (size_t p = 0; p < operation.inputs[s]; ++p) in[s].Set(i, p, inputs[s][i][p]);
      }
    }
    for (const size_t planes : operation.outputs) out.emplace_back(out_layout, count, planes);
  }

  gaunt_status Call(const Operation& operation, size_t count) {
    Operation::Views in_views, out_views;
    for (const Buffer& buffer : in) in_views.push_back(buffer.view());
    for (const Buffer& buffer : out) out_views.push_back(buffer.view());
    return operation.call(count, in_views, out_views);
  }
};

std::vector<Layout> AllIn(const Operation& operation, Layout layout) {
  return std::vector<Layout>(operation.inputs.size(), layout);
}

void ExpectMatchesReference(const Operation& operation, const Values& inputs, size_t count,
                            const std::vector<Buffer>& out) {
  for (size_t i = 0; i < count; ++i) {
    const Operation::Item item = ItemOf(inputs, i);
    Operation::Item wanted;
    for (const size_t planes : operation.outputs) wanted.emplace_back(planes);
    operation.reference(item, wanted);
    for (size_t s = 0; s < out.size(); ++s) {
      for (size_t p = 0; p < operation.outputs[s]; ++p) {
        ASSERT_NEAR(out[s].Get(i, p), wanted[s][p], operation.tolerance(item, wanted, s, p))
            << operation.name << ": item " << i << " of " << count << ", output " << s << ", plane "
            << p;
      }
    }
  }
}

void ExpectSameOutputs(const Operation& operation, size_t count, const std::vector<Buffer>& a,
                       const std::vector<Buffer>& b, size_t except_item) {
  for (size_t s = 0; s < a.size(); ++s) {
    for (size_t i = 0; i < count; ++i) {
      if (i == except_item) continue;
      for (size_t p = 0; p < operation.outputs[s]; ++p) {
        ASSERT_TRUE(SameBits(a[s].Get(i, p), b[s].Get(i, p)))
            << operation.name << ": item " << i << " of " << count << ", output " << s << ", plane "
            << p << ": " << a[s].Get(i, p) << " against " << b[s].Get(i, p);
      }
    }
  }
}

constexpr size_t kNoItem = std::numeric_limits<size_t>::max();

void TestLayouts(const Operation& operation, size_t count) {
  const Values inputs = MakeInputs(operation, count);
  Run first(operation, count, AllIn(operation, Layout::kPlanar), Layout::kPlanar, inputs);
  ASSERT_EQ(first.Call(operation, count), GAUNT_OK);
  ExpectMatchesReference(operation, inputs, count, first.out);
  for (const Layout in_layout : Layouts()) {
    for (const Layout out_layout : Layouts()) {
      SCOPED_TRACE(Name(in_layout) + " to " + Name(out_layout));
      Run run(operation, count, AllIn(operation, in_layout), out_layout, inputs);
      const std::vector<Buffer> before = run.in;
      ASSERT_EQ(run.Call(operation, count), GAUNT_OK);
      ExpectSameOutputs(operation, count, first.out, run.out, kNoItem);
      for (const Buffer& buffer : run.out) ASSERT_TRUE(buffer.CanariesIntact());
      for (size_t s = 0; s < run.in.size(); ++s) {
        ASSERT_EQ(std::memcmp(run.in[s].memory().data(), before[s].memory().data(),
                              before[s].memory().size() * sizeof(float)),
                  0)
            << "input " << s << " was written";
      }
    }
  }
}

void TestBroadcast(const Operation& operation, size_t side) {
  Values inputs = MakeInputs(operation, MostItems(operation));
  for (auto& item : inputs[side]) item = inputs[side][0];
  for (const Layout layout : {Layout::kPlanar, Layout::kInterleaved, Layout::kTiled}) {
    SCOPED_TRACE("input " + std::to_string(side) + " broadcast, others " + Name(layout));
    std::vector<Layout> layouts = AllIn(operation, layout);
    layouts[side] = Layout::kBroadcast;
    Run run(operation, MostItems(operation), layouts, layout, inputs);
    ASSERT_EQ(run.Call(operation, MostItems(operation)), GAUNT_OK);
    ExpectMatchesReference(operation, inputs, MostItems(operation), run.out);
    if (!operation.broadcast_rounds_alike) continue;
    Run each(operation, MostItems(operation), AllIn(operation, layout), layout, inputs);
    ASSERT_EQ(each.Call(operation, MostItems(operation)), GAUNT_OK);
    ExpectSameOutputs(operation, MostItems(operation), each.out, run.out, kNoItem);
  }
}

void TestInPlace(const Operation& operation, size_t side, size_t count) {
  const Values inputs = MakeInputs(operation, count);
  Run apart(operation, count, AllIn(operation, Layout::kPlanar), Layout::kPlanar, inputs);
  ASSERT_EQ(apart.Call(operation, count), GAUNT_OK);
  for (const Layout layout : Layouts()) {
    SCOPED_TRACE("in place in " + Name(layout));
    Run run(operation, count, AllIn(operation, layout), layout, inputs);
    Operation::Views in_views, out_views = {run.in[side].view()};
    for (const Buffer& buffer : run.in) in_views.push_back(buffer.view());
    ASSERT_EQ(operation.call(count, in_views, out_views), GAUNT_OK);
    ExpectSameOutputs(operation, count, apart.out, {run.in[side]}, kNoItem);
    ASSERT_TRUE(run.in[side].CanariesIntact());
  }
}

// Interleaved and planar batches that end where memory does.
void TestEndOfMemory(const Operation& operation, size_t count) {
  const Values inputs = MakeInputs(operation, count);
  for (const bool planar : {false, true}) {
    std::vector<std::unique_ptr<GuardedFloats>> memory;
    std::vector<gaunt_view> views;
    const auto add = [&](size_t planes) {
      memory.push_back(std::make_unique<GuardedFloats>(count * planes));
      views.emplace_back();
      if (planar) {
        const size_t stride = count * sizeof(float);
        gaunt_view_planar(memory.back()->data(), static_cast<ptrdiff_t>(stride), &views.back());
      } else {
        gaunt_view_interleaved(memory.back()->data(), planes, &views.back());
      }
    };
    for (size_t s = 0; s < inputs.size(); ++s) {
      add(operation.inputs[s]);
      for (size_t i = 0; i < count; ++i) {
        for (size_t p = 0; p < operation.inputs[s]; ++p) {
          memory[s]->data()[planar ? p * count + i : i * operation.inputs[s] + p] = inputs[s][i][p];
        }
      }
    }
    for (const size_t planes : operation.outputs) add(planes);
    Operation::Views in, out;
    for (size_t v = 0; v < views.size(); ++v) {
      (v < inputs.size() ? in : out).push_back(&views[v]);
    }
    ASSERT_EQ(operation.call(count, in, out), GAUNT_OK);
  }
}

void TestNotANumber(const Operation& operation) {
  constexpr size_t kBad = 21;
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    for (size_t side = 0; side < operation.inputs.size(); ++side) {
      Values inputs = MakeInputs(operation, MostItems(operation));
      for (const Layout layout : {Layout::kPlanar, Layout::kInterleaved}) {
        Run clean(operation, MostItems(operation), AllIn(operation, layout), layout, inputs);
        ASSERT_EQ(clean.Call(operation, MostItems(operation)), GAUNT_OK);
        Values spoilt = inputs;
        for (float& plane : spoilt[side][kBad]) plane = bad;
        Run run(operation, MostItems(operation), AllIn(operation, layout), layout, spoilt);
        ASSERT_EQ(run.Call(operation, MostItems(operation)), GAUNT_OK);
        ExpectSameOutputs(operation, MostItems(operation), clean.out, run.out, kBad);
      }
    }
  }
}

// FNV-1a over the bits of all outputs.
std::string HashOf(const Operation& operation, const std::vector<Buffer>& out) {
  uint64_t hash = 14695981039346656037u;
  for (size_t s = 0; s < out.size(); ++s) {
    for (size_t i = 0; i < MostItems(operation); ++i) {
      for (size_t p = 0; p < operation.outputs[s]; ++p) {
        const float value = out[s].Get(i, p);
        uint32_t bits;
        std::memcpy(&bits, &value, sizeof(bits));
        for (int byte = 0; byte < 4; ++byte)
          hash = (hash ^ (bits >> (8 * byte) & 255)) * 1099511628211u;
      }
    }
  }
  char text[17];
  std::snprintf(text, sizeof(text), "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

void ExpectKnownBits(const std::string& name, bool fma, const std::string& hash) {
  const std::string kind = fma ? "fma" : "plain";
  if (const char* file = std::getenv("GAUNT_WRITE_BITS")) {
    std::ofstream(file, std::ios::app) << name << "," << kind << "," << hash << "\n";
    return;
  }
  for (const auto& row : ReadGolden("bits.csv")) {
    if (row[0] == name && row[1] == kind) {
      EXPECT_EQ(row[2], hash) << name << " " << kind;
      return;
    }
  }
  ADD_FAILURE() << "tests/golden/bits.csv has no row for " << name << " " << kind;
}

}  // namespace

void TestBatches(const Operation& operation) {
  SCOPED_TRACE(operation.name);
  for (const size_t count : kCounts) TestLayouts(operation, Count(operation, count));
  for (const size_t count : {1, 3, 8, 16, 17}) TestEndOfMemory(operation, Count(operation, count));
  for (size_t side = 0; side < operation.inputs.size(); ++side) TestBroadcast(operation, side);
  for (const size_t side : operation.in_place) {
    for (const size_t count : {size_t{1}, size_t{17}, kMostItems}) {
      TestInPlace(operation, side, Count(operation, count));
    }
  }
  TestNotANumber(operation);
}

void TestSameBits(const Operation& operation) {
  const Values inputs = MakeInputs(operation, MostItems(operation));
  std::map<bool, std::vector<Buffer>> first;
  for (const std::string& target : SupportedTargets()) {
    SCOPED_TRACE(operation.name + " on " + target);
    ASSERT_EQ(gaunt_target_select(target.c_str()), GAUNT_OK);
    Run run(operation, MostItems(operation), AllIn(operation, Layout::kPlanar), Layout::kPlanar,
            inputs);
    ASSERT_EQ(run.Call(operation, MostItems(operation)), GAUNT_OK);
    const auto [entry, inserted] = first.emplace(HasFma(target), run.out);
    if (inserted) {
      ExpectKnownBits(operation.name, HasFma(target), HashOf(operation, run.out));
    } else {
      ExpectSameOutputs(operation, MostItems(operation), entry->second, run.out, kNoItem);
    }
  }
  gaunt_target_select(nullptr);
}

void TestErrors(const Operation& operation) {
  SCOPED_TRACE(operation.name);
  constexpr size_t kCount = 19;
  const Values inputs = MakeInputs(operation, kCount);
  Run run(operation, kCount, AllIn(operation, Layout::kInterleaved), Layout::kInterleaved, inputs);
  const size_t num_in = run.in.size(), num_out = run.out.size();
  std::vector<gaunt_view> views;
  for (const Buffer& buffer : run.in) views.push_back(*buffer.view());
  for (const Buffer& buffer : run.out) views.push_back(*buffer.view());
  const std::vector<Buffer> before = run.out;

  const auto call = [&](size_t count, const std::vector<gaunt_view>& used, size_t null_view) {
    Operation::Views in, out;
    for (size_t v = 0; v < used.size(); ++v) {
      (v < num_in ? in : out).push_back(v == null_view ? nullptr : &used[v]);
    }
    return operation.call(count, in, out);
  };
  const auto expect = [&](gaunt_status status, const std::vector<gaunt_view>& used) {
    EXPECT_EQ(call(kCount, used, kNoItem), status);
    for (size_t s = 0; s < num_out; ++s) {
      EXPECT_EQ(std::memcmp(run.out[s].memory().data(), before[s].memory().data(),
                            before[s].memory().size() * sizeof(float)),
                0)
          << "output " << s << " was written";
    }
  };

  EXPECT_EQ(operation.call(0, Operation::Views(num_in), Operation::Views(num_out)), GAUNT_OK);
  // Counts that no array has, such as a -1 of the caller.
  for (const Layout layout : {Layout::kTiled, Layout::kOddTiles, Layout::kInterleaved}) {
    Run huge(operation, kCount, AllIn(operation, layout), layout, inputs);
    for (const size_t count : {SIZE_MAX, SIZE_MAX - 15, SIZE_MAX / 4}) {
      EXPECT_EQ(huge.Call(operation, count), GAUNT_ERROR_RANGE) << Name(layout) << " " << count;
    }
  }
  for (size_t v = 0; v < views.size(); ++v) {
    SCOPED_TRACE("view " + std::to_string(v));
    EXPECT_EQ(call(kCount, views, v), GAUNT_ERROR_NULL);
    std::vector<gaunt_view> bad = views;
    bad[v].data = nullptr;
    expect(GAUNT_ERROR_NULL, bad);
    bad = views;
    bad[v].item_stride += 2;
    expect(GAUNT_ERROR_LAYOUT, bad);
    bad = views;
    bad[v].data = reinterpret_cast<float*>(reinterpret_cast<char*>(bad[v].data) + 1);
    expect(GAUNT_ERROR_LAYOUT, bad);
    bad = views;
    bad[v].item_stride = PTRDIFF_MAX - 3;
    expect(GAUNT_ERROR_RANGE, bad);
    bad = views;
    bad[v].item_stride = PTRDIFF_MIN;
    expect(GAUNT_ERROR_RANGE, bad);
  }
  for (size_t s = 0; s < num_out; ++s) {
    SCOPED_TRACE("output " + std::to_string(s));
    const size_t v = num_in + s;
    std::vector<gaunt_view> bad = views;
    bad[v].item_stride = 0;
    expect(GAUNT_ERROR_LAYOUT, bad);
    if (operation.outputs[s] > 1) {
      bad = views;
      bad[v].plane_stride = 0;
      expect(GAUNT_ERROR_LAYOUT, bad);
      bad = views;
      bad[v].item_stride = 4;
      expect(GAUNT_ERROR_LAYOUT, bad);
    }
    for (size_t other = 0; other < v; ++other) {
      bad = views;
      bad[v].data = views[other].data + 1;
      bad[v].item_stride += 4096;  // no field of the other's record
      expect(GAUNT_ERROR_OVERLAP, bad);
    }
  }
}

}  // namespace gaunt::test
