// SPDX-License-Identifier: MIT
// Samples at directions: the basis of each, weighted and added.
#if defined(GAUNT_PROJECT_SAMPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROJECT_SAMPLES_INL_H_
#undef GAUNT_PROJECT_SAMPLES_INL_H_
#else
#define GAUNT_PROJECT_SAMPLES_INL_H_
#endif

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>
#include <utility>

#include "basis/basis-inl.h"
#include "project/project-inl.h"
#include "project/project.h"
#include "simd/batch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::project::HWY_NAMESPACE {

// Columns first <= m < last of an order's coefficients, of channels first_channel ..
struct SampleBlock {
  int order, first, last;
  size_t first_channel, channels;
};

// Lanes of sums in memory, a vector each.
struct LaneSums {
  float* data;
  GAUNT_LANES hn::Vec<LaneTag> operator()(size_t i) const {
    return hn::Load(LaneTag(), data + i * kMaxLanes);
  }
  GAUNT_LANES void operator()(size_t i, hn::Vec<LaneTag> v) const {
    hn::Store(v, LaneTag(), data + i * kMaxLanes);
  }
};

// Takes down which coefficients a basis visits, in its order.
struct ListVisits {
  Pass& pass;
  GAUNT_LANES void operator()(size_t index, hn::Vec<LaneTag>) {
    pass.index[pass.count++] = static_cast<uint16_t>(index);
  }
};

struct SampleViews {
  const simd::InView& directions;
  const simd::InView& values;
  const simd::InView& weights;
};

struct SampleFns {
  void (*list)(const SampleBlock& block, Pass& pass);
  // Adds `count` samples, whole groups of lanes, to sums in lanes.
  void (*add[kMaxChannels + 1])(const SampleBlock& block, const SampleViews& views, size_t first,
                                size_t count, float* sums);
};

template <int n>
basis::HWY_NAMESPACE::Eval<n> MakeBasis(const SampleBlock&, std::integral_constant<int, n>) {
  return {};
}
inline basis::HWY_NAMESPACE::EvalColumns MakeBasis(const SampleBlock& block,
                                                   std::integral_constant<int, 0>) {
  return {block.order, block.first, block.last};
}

// n = 0: any order.
template <int n>
HWY_NOINLINE void ListBasis(const SampleBlock& block, Pass& pass) {
  HWY_ALIGN const float zeros[kMaxLanes] = {};
  MakeBasis(block, std::integral_constant<int, n>())(
      Lanes(), PlanesIn{reinterpret_cast<const unsigned char*>(zeros), 0}, ListVisits{pass});
}

template <int n, int kChannels>
HWY_NOINLINE void AddGroups(const SampleBlock& block, const SampleViews& views, size_t first,
                            size_t count, float* sums) {
  const auto basis = MakeBasis(block, std::integral_constant<int, n>());
  const AddSamples<std::remove_const_t<decltype(basis)>, kChannels, LaneSums> kernel = {basis,
                                                                                        {sums}};
  ForEachBatch(count, kernel, In<3>(views.directions, 3, first),
               In<kChannels>(views.values.FromPlane(block.first_channel), kChannels, first),
               In<1>(views.weights, 1, first));
}

template <int n>
constexpr SampleFns MakeSampleFns() {
  return {&ListBasis<n>,
          {nullptr, &AddGroups<n, 1>, &AddGroups<n, 2>, &AddGroups<n, 3>, &AddGroups<n, 4>}};
}
template <int... n>
constexpr std::array<SampleFns, sizeof...(n)> SampleFnsByOrder(std::integer_sequence<int, n...>) {
  return {MakeSampleFns<n>()...};
}

// Sums of a block: lanes in float over a stretch of samples, then in double.
class SampleSums {
 public:
  static constexpr size_t kMaxSums = 144;  // order 6 with all channels

  SampleSums(const SampleBlock& block, Pass& pass) : block_(block), pass_(pass) {
    static constexpr auto kFns = SampleFnsByOrder(Orders<kMaxUnrolledOrder>());
    fns_ = &kFns[block.order <= kMaxUnrolledOrder ? block.order : 0];
    pass.first_channel = block.first_channel;
    pass.channels = block.channels;
    pass.count = 0;
    fns_->list(block, pass);
    std::fill(lanes_, lanes_ + pass.count * block.channels * kMaxLanes, 0.0f);
  }

  // Samples first .. first + count of the views, whole groups of lanes.
  void Add(const SampleViews& views, size_t first, size_t count) {
    const size_t lanes = hn::Lanes(LaneTag());
    while (count > 0) {
      const size_t n = std::min(count, left_ * lanes);
      fns_->add[block_.channels](block_, views, first, n, lanes_);
      first += n;
      count -= n;
      left_ -= n / lanes;
      if (left_ == 0) Flush();
    }
  }

  HWY_NOINLINE void Flush() {
    const LaneTag d;
    float* sum = lanes_;
    for (size_t i = 0; i < pass_.count; ++i) {
      for (size_t c = 0; c < block_.channels; ++c, sum += kMaxLanes) {
        pass_.sums[i][c] += static_cast<double>(hn::GetLane(hn::SumOfLanes(d, hn::Load(d, sum))));
        hn::Store(hn::Zero(d), d, sum);
      }
    }
    left_ = kMostGroups;
  }

 private:
  static constexpr size_t kMostGroups = 64;

  const SampleBlock& block_;
  Pass& pass_;
  const SampleFns* fns_;
  size_t left_ = kMostGroups;
  HWY_ALIGN float lanes_[kMaxSums * kMaxLanes];
};

template <class Source>
HWY_NOINLINE void SumBlock(const SampleBlock& block, const Source& source, Pass& pass) {
  SampleSums sums(block, pass);
  source(block, sums);
  sums.Flush();
}

template <class Source>
HWY_NOINLINE void TakeBlock(const SampleBlock& block, const Source& source, Sink& sink) {
  Pass pass;
  SumBlock(block, source, pass);
  sink.Take(pass);
}

// Runs source(block, sums), which adds all samples to the sums, for blocks that cover all
// coefficients of all channels.
template <class Source>
void ForEachSampleBlock(int order, size_t channels, const Source& source, Sink& sink) {
  const auto column = [order](int m) {
    return static_cast<size_t>((m == 0 ? 1 : 2) * (order - m));
  };
  // All channels of a column at once, if they fit.
  const size_t widest = std::max(column(0), order > 1 ? column(1) : 0);
  const size_t most = std::min(channels, SampleSums::kMaxSums / widest);
  for (size_t channel = 0; channel < channels; channel += most) {
    const size_t n = std::min(most, channels - channel);
    for (int first = 0, last = 0; first < order; first = last) {
      size_t sums = 0;
      do {
        sums += n * column(last++);
      } while (last < order && sums + n * column(last) <= SampleSums::kMaxSums);
      TakeBlock(SampleBlock{order, first, last, channel, n}, source, sink);
    }
  }
}

// Less than a group of samples, as a group whose other lanes weigh nothing.
HWY_NOINLINE void AddTail(const SampleBlock& block, const SampleViews& views, size_t first,
                          size_t count, SampleSums& sums) {
  HWY_ALIGN float directions[3 * kMaxLanes], values[kMaxChannels * kMaxLanes] = {};
  HWY_ALIGN float weights[kMaxLanes] = {};
  std::fill(directions, directions + 3 * kMaxLanes, 0.0f);
  const auto copy = [&](const simd::InView& view, size_t planes, float* to) {
    for (size_t p = 0; p < planes; ++p) {
      for (size_t i = 0; i < count; ++i) {
        std::memcpy(to + p * kMaxLanes + i,
                    view.Item(first + i) + static_cast<ptrdiff_t>(p) * view.plane_stride,
                    sizeof(float));
      }
    }
  };
  copy(views.directions, 3, directions);
  copy(views.values, block.first_channel + block.channels, values);
  copy(views.weights, 1, weights);
  sums.Add({simd::PlanarIn(directions, kMaxLanes), simd::PlanarIn(values, kMaxLanes),
            simd::PlanarIn(weights, kMaxLanes)},
           0, hn::Lanes(LaneTag()));
}

void Samples(int order, size_t channels, size_t count, const simd::InView& directions,
             const simd::InView& values, const simd::InView& weights, Sink& sink) {
  const SampleViews views = {directions, values, weights};
  const size_t whole = count / hn::Lanes(LaneTag()) * hn::Lanes(LaneTag());
  ForEachSampleBlock(
      order, channels,
      [&](const SampleBlock& block, SampleSums& sums) {
        sums.Add(views, 0, whole);
        if (whole < count) AddTail(block, views, whole, count - whole, sums);
      },
      sink);
}

}  // namespace gaunt::project::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROJECT_SAMPLES_INL_H_
