// SPDX-License-Identifier: MIT
// Operations of the project kernels, by running them on counting lanes.
#include <algorithm>

#include "basis/basis-inl.h"
#include "project/cube.h"
#include "project/project-inl.h"
#include "simd/count.h"
#include "simd/order.h"

namespace gaunt::project {

void AppendOperations(OperationRows& rows);

namespace {

// Texels by row and step, tables by number and step.
struct CountSteps {
  Counted operator()(size_t, size_t) const { return ++CountedOperations().load, Counted(); }
};
struct NoOut {
  void operator()(size_t, Counted) const {}
  void operator()(size_t, size_t, Counted) const {}
};

// Rounded to nearest.
Operations DividedBy(const Operations& o, uint64_t n) {
  const auto share = [n](uint64_t x) { return (x + n / 2) / n; };
  return {share(o.mul), share(o.fma), share(o.add), share(o.div), share(o.load), share(o.store)};
}

// One pass of the sum per moment; what a run adds at its end is not counted.
Operations MomentsPerTexel(uint64_t moments) {
  constexpr uint64_t kSteps = 1024;
  CountedOperations() = Operations();
  HWY_NAMESPACE::Moments<2, 1>()(CountLanes(), CountSteps(), kSteps, CountSteps(), 0, CountSteps(),
                                 NoOut());
  return moments * DividedBy(CountedOperations(), 2 * kSteps);
}

// Weights and tables are made for two rows of six faces; they have as many lanes as the texels.
constexpr uint64_t kCubeTexels = 12;
Operations CubeTables(int order, uint64_t channels) {
  const CubeDegrees degrees(order);
  const HWY_NAMESPACE::CubeWeights weights = {0.5, 0.1, degrees.even, degrees.odd};
  Operations all = CountKernel(weights, CountPlanes(), NoOut());
  for (const int degree : {degrees.even, degrees.odd}) {
    if (degree < 0) continue;
    CountedOperations() = Operations();
    HWY_NAMESPACE::Powers{degree}(CountLanes(), Counted(), Counted(), CountPlanes());
    all = all + channels * CountedOperations();
  }
  return all;
}

template <class Basis, int kChannels>
Operations Sample(const Basis& basis) {
  const HWY_NAMESPACE::AddSamples<Basis, kChannels, CountPlanes> kernel = {basis, {}};
  return CountKernel(kernel, CountPlanes(), CountPlanes(), CountPlanes());
}

template <int n>
void AppendUnrolledSamples(OperationRows& rows) {
  using Basis = basis::HWY_NAMESPACE::Eval<n>;
  rows.push_back({"project_samples", std::to_string(n), "mono", Sample<Basis, 1>({})});
  rows.push_back({"project_samples", std::to_string(n), "rgb", Sample<Basis, 3>({})});
  if constexpr (n < kMaxUnrolledOrder) AppendUnrolledSamples<n + 1>(rows);
}

}  // namespace

void AppendOperations(OperationRows& rows) {
  constexpr int kOrders[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 16, 32, kMaxOrder};
  const auto append = [&](const char* op, int n, const auto& texel) {
    rows.push_back({op, std::to_string(n), "mono", texel(n, uint64_t{1})});
    rows.push_back({op, std::to_string(n), "rgb", texel(n, uint64_t{3})});
  };
  for (const int n : kOrders) {
    append("project_equirect", n, [](int order, uint64_t channels) {
      return channels * MomentsPerTexel(static_cast<uint64_t>(2 * order - 1));
    });
  }
  for (const int n : kOrders) {
    if (n > kMaxCubeMomentOrder) break;  // by samples
    append("project_cubemap", n, [](int order, uint64_t channels) {
      const uint64_t passes = kCubeTexels * channels;
      const Operations moments = passes * MomentsPerTexel(CubeDegrees(order).Moments());
      return DividedBy(moments + CubeTables(order, channels), kCubeTexels);
    });
  }
  AppendUnrolledSamples<1>(rows);
  for (const int n : kOrders) {
    if (n <= kMaxUnrolledOrder) continue;
    using Basis = basis::HWY_NAMESPACE::EvalColumns;
    const Basis basis = {n, 0, n};
    rows.push_back({"project_samples", std::to_string(n), "mono", Sample<Basis, 1>(basis)});
    rows.push_back({"project_samples", std::to_string(n), "rgb", Sample<Basis, 3>(basis)});
  }
}

}  // namespace gaunt::project
