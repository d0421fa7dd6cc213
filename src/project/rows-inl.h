// SPDX-License-Identifier: MIT
// Rows of texels as streams of floats. A row is never taken apart into channels: in a stream of 1, 2
// or 4 floats per texel, the channel of a lane is its number modulo that pattern, so that a sum per
// moment will do. Three floats per texel are spread to four in registers; everything else goes
// through a buffer.
#if defined(GAUNT_PROJECT_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROJECT_ROWS_INL_H_
#undef GAUNT_PROJECT_ROWS_INL_H_
#else
#define GAUNT_PROJECT_ROWS_INL_H_
#endif

#include <algorithm>
#include <array>
#include <cstring>

#include "project/project-inl.h"
#include "project/project.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::project::HWY_NAMESPACE {

using V = hn::Vec<LaneTag>;

// Texels whose moments are summed in float.
constexpr size_t kMaxRun = 128;
// One lane alone cannot hold a pattern: its texels take as many steps as they have floats.
constexpr bool kOneLane = HWY_TARGET == HWY_SCALAR;

constexpr size_t RoundUp(size_t n, size_t to) { return (n + to - 1) / to * to; }

// Room for what cannot be used in place, of two rows.
struct RunBuffer {
  static constexpr size_t kFloats = kMaxRun * kMaxChannels + kMaxLanes;
  HWY_ALIGN float floats[2][kFloats];
  HWY_ALIGN uint16_t halves[kFloats];
};

// Bits of f16 to float. In integers where the target has no instruction for it: Highway's own way
// takes an infinity for a number.
GAUNT_LANES V PromoteHalves(const uint16_t* halves) {
  const LaneTag d;
#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128 && \
    (HWY_ARCH_ARM_A64 || (HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2))
  const hn::Rebind<hwy::float16_t, LaneTag> half;
  return hn::PromoteTo(d, hn::LoadU(half, reinterpret_cast<const hwy::float16_t*>(halves)));
#else
  const hn::Rebind<uint16_t, LaneTag> half;
  const hn::RebindToUnsigned<LaneTag> bits;
  const auto wide = hn::PromoteTo(bits, hn::LoadU(half, halves));
  const auto sign = hn::ShiftLeft<16>(hn::And(wide, hn::Set(bits, 0x8000u)));
  const auto magnitude = hn::ShiftLeft<13>(hn::And(wide, hn::Set(bits, 0x7FFFu)));
  // The exponents differ by 127 - 15, for numbers below the normal ones too.
  const V value = hn::Mul(hn::BitCast(d, magnitude), hn::Set(d, 0x1p112f));
  const V special = hn::BitCast(d, hn::Or(magnitude, hn::Set(bits, 0x7F800000u)));
  const V finite_end = hn::Set(d, 65536.0f);
  return hn::Or(hn::IfThenElse(hn::Lt(value, finite_end), value, special), hn::BitCast(d, sign));
#endif
}

// A run of texels of one row or two, in steps of whole lanes: what can be used in place, and then a
// copy of the rest.
struct Run {
  const float* main[2];
  const float* tail[2];
  size_t main_steps;
  size_t tail_steps;
};

class RowReader {
 public:
  RowReader(const Image& image, size_t channels)
      : width_(image.width),
        channels_(channels),
        pixel_stride_(image.pixel_stride),
        half_(image.half),
        clamp_(image.clamp) {
    const size_t component = half_ ? sizeof(uint16_t) : sizeof(float);
    const size_t stride = static_cast<size_t>(pixel_stride_);
    // Texels back to back are taken with the channels that are not wanted.
    packed_ = pixel_stride_ > 0 && width_ > 1 && stride / component <= kMaxChannels;
    stream_ = packed_ ? stride / component : channels;
    const size_t lanes = hn::Lanes(LaneTag());
    pattern_ = stream_ == 3 && !kOneLane ? 4 : stream_;
    phases_ = kOneLane ? pattern_ : 1;
    step_ = lanes * phases_;
    step_texels_ = step_ / pattern_;
  }

  // Floats per texel of the tables that go with the texels.
  size_t pattern() const { return pattern_; }
  bool triples() const { return stream_ != pattern_; }
  size_t phases() const { return phases_; }
  // Floats of a table from step to step.
  size_t step() const { return step_; }

  // Texels first .. first + n of the rows `upper` and `lower`, which may be one. Past the end, copies
  // hold zeros.
  Run Read(const unsigned char* upper, const unsigned char* lower, size_t first, size_t n,
           RunBuffer& buffer) const {
    const ptrdiff_t offset = static_cast<ptrdiff_t>(first) * pixel_stride_;
    const size_t steps = StepsInPlace(first, n), done = steps * step_texels_;
    const ptrdiff_t rest = offset + static_cast<ptrdiff_t>(done) * pixel_stride_;
    Run run = {};
    run.main_steps = steps;
    run.tail_steps = (n - done + step_texels_ - 1) / step_texels_;
    run.main[0] = reinterpret_cast<const float*>(upper + offset);
    run.main[1] = reinterpret_cast<const float*>(lower + offset);
    run.tail[0] = run.tail[1] = buffer.floats[0];
    if (done == n) return run;
    Copy(upper + rest, n - done, buffer.halves, buffer.floats[0]);
    if (lower == upper) return run;
    Copy(lower + rest, n - done, buffer.halves, buffer.floats[1]);
    run.tail[1] = buffer.floats[1];
    return run;
  }

  // Texels first .. first + n of a row, all of them copied; ChannelOf() takes them apart.
  void ReadChannels(const unsigned char* row, size_t first, size_t n, RunBuffer& buffer) const {
    Copy(row + static_cast<ptrdiff_t>(first) * pixel_stride_, n, buffer.halves, buffer.floats[0]);
  }
  float ChannelOf(const RunBuffer& buffer, size_t texel, size_t channel) const {
    return buffer.floats[0][texel * stream_ + channel];
  }

 private:
  // Steps whose vectors end inside of the row.
  size_t StepsInPlace(size_t first, size_t n) const {
    if (!packed_ || half_ || clamp_) return 0;
    const size_t readable = (width_ - first - 1) * stream_ + channels_;
    const size_t read = triples() ? step_ : step_texels_ * stream_;
    if (readable < read) return 0;
    return std::min(n / step_texels_, (readable - read) / (step_texels_ * stream_) + 1);
  }

  HWY_NOINLINE void Copy(const unsigned char* from, size_t n, uint16_t* halves,
                         float* floats) const {
    const LaneTag d;
    const size_t lanes = hn::Lanes(d);
    const size_t end = RoundUp(n, step_texels_) * stream_ + lanes;
    if (half_) {
      size_t i = 0;
      if (packed_) {
        const uint16_t* const source = reinterpret_cast<const uint16_t*>(from);
        const size_t last = (n - 1) * stream_ + channels_;
        for (; i + lanes <= last; i += lanes) hn::StoreU(PromoteHalves(source + i), d, floats + i);
      }
      CopyComponents(from, n, i, end, halves);
      for (; i < end; i += lanes) {
        // The end is whole texels and one vector more.
        if (i + lanes > end) i = end - lanes;
        hn::StoreU(PromoteHalves(halves + i), d, floats + i);
      }
    } else {
      CopyComponents(from, n, 0, end, floats);
    }
    if (!clamp_) return;
    for (size_t i = 0; i < end; i += lanes) {
      if (i + lanes > end) i = end - lanes;
      float* const at = floats + i;
      hn::StoreU(Clamp()(Lanes(), hn::LoadU(d, at)), d, at);
    }
  }

  // From component `first` on, or from somewhere before it; zeros from the last texel to `end`.
  template <typename T>
  void CopyComponents(const unsigned char* from, size_t n, size_t first, size_t end, T* to) const {
    const size_t last = (n - 1) * stream_ + channels_;
    if (packed_) {
      first -= std::min(first, hn::Lanes(LaneTag()));
      std::memcpy(to + first, from + first * sizeof(T), (last - first) * sizeof(T));
    } else {
      for (size_t i = 0; i < n; ++i, from += pixel_stride_) {
        for (size_t c = 0; c < channels_; ++c) {
          std::memcpy(to + i * stream_ + c, from + c * sizeof(T), sizeof(T));
        }
      }
    }
    std::fill(to + last, to + end, T());
  }

  size_t width_, channels_;
  ptrdiff_t pixel_stride_;
  bool half_, clamp_, packed_;
  size_t stream_;       // floats per texel, as they lie
  size_t pattern_;      // floats per texel, in lanes
  size_t phases_;       // vectors of a step
  size_t step_;         // lanes of a step
  size_t step_texels_;  // texels of a step
};

// Vectors of texels in which each texel takes `pattern` lanes.
struct FlatTexels {
  const float* const* rows;
  size_t phase;
  size_t step;
  GAUNT_LANES V operator()(size_t row, size_t i) const {
    return hn::LoadU(LaneTag(), rows[row] + phase + i * step);
  }
};

// The same of texels of three floats; the fourth lane holds anything.
struct TripleTexels {
  const float* const* rows;
  size_t phase;
  size_t step;
  GAUNT_LANES V operator()(size_t row, size_t i) const {
    const LaneTag d;
    HWY_ALIGN static constexpr int32_t kSpread[kMaxLanes] = {0, 1, 2, 2, 3, 4,  5,  5,
                                                             6, 7, 8, 8, 9, 10, 11, 11};
    return hn::TableLookupLanes(hn::LoadU(d, rows[row] + i * (step / 4 * 3)),
                                hn::SetTableIndices(d, kSpread));
  }
};

struct MomentTables {
  const float* data;
  size_t step;
  size_t stride;  // floats from table to table
  GAUNT_LANES V operator()(size_t i, size_t at) const {
    return hn::LoadU(LaneTag(), data + i * stride + at * step);
  }
};

// Sums of lanes of equal number modulo 4, as doubles.
template <class D>
GAUNT_LANES void StoreFolded([[maybe_unused]] D d, hn::Vec<D> v, double* to) {
#if HWY_TARGET == HWY_SCALAR
  *to = static_cast<double>(hn::GetLane(v));
#elif HWY_HAVE_SCALABLE
  HWY_ALIGN float lanes[kMaxLanes];
  hn::Store(v, d, lanes);
  for (size_t c = 0; c < 4; ++c) to[c] = 0.0;
  for (size_t i = 0; i < hn::Lanes(d); ++i) to[i % 4] += static_cast<double>(lanes[i]);
#else
  if constexpr (hn::MaxLanes(D()) > 4) {
    const hn::Half<D> half;
    StoreFolded(half, hn::Add(hn::LowerHalf(half, v), hn::UpperHalf(half, v)), to);
  } else {
    HWY_ALIGN float lanes[4];
    hn::Store(v, d, lanes);
    for (size_t c = 0; c < 4; ++c) to[c] = static_cast<double>(lanes[c]);
  }
#endif
}

struct FoldedOut {
  double* const* sums;
  size_t first;
  GAUNT_LANES void operator()(size_t row, size_t i, V v) const {
    StoreFolded(LaneTag(), v, sums[row] + first + 4 * i);
  }
};

template <class Texels, size_t kRows, size_t kMoments>
HWY_NOINLINE void SumRun(const Run& run, size_t phase, const MomentTables& tables,
                         const FoldedOut& out) {
  // Values of their own: no store changes them.
  const float* const main[2] = {run.main[0], run.main[1]};
  const float* const tail[2] = {run.tail[0], run.tail[1]};
  Moments<kRows, kMoments>()(Lanes(), Texels{main, phase, tables.step}, run.main_steps,
                             Texels{tail, phase, tables.step}, run.tail_steps, tables, out);
}

using SumRunFn = void (*)(const Run& run, size_t phase, const MomentTables& tables,
                          const FoldedOut& out);
// Moments that two chains keep in the registers of a target with 16.
constexpr size_t kMomentBlock = 6;

template <class Texels, size_t kRows, size_t... i>
constexpr std::array<SumRunFn, sizeof...(i)> SumRunFns(std::index_sequence<i...>) {
  return {&SumRun<Texels, kRows, i + 1>...};
}

// Sums of the texels of a run times each of the tables, of one row or two: sums[row][4 i + channel].
inline void RowMoments(const RowReader& reader, const Run& run, size_t rows, const float* tables,
                       size_t stride, size_t moments, double* const* sums) {
  using Block = std::make_index_sequence<kMomentBlock>;
  static constexpr std::array<SumRunFn, kMomentBlock> kFns[2][2] = {
      {SumRunFns<FlatTexels, 1>(Block()), SumRunFns<FlatTexels, 2>(Block())},
      {SumRunFns<TripleTexels, 1>(Block()), SumRunFns<TripleTexels, 2>(Block())}};
  const auto& sum = kFns[reader.triples() ? 1 : 0][rows - 1];
  for (size_t first = 0, n; first < moments; first += n) {
    // Blocks of about equal size.
    const size_t blocks = (moments - first + kMomentBlock - 1) / kMomentBlock;
    n = (moments - first + blocks - 1) / blocks;
    for (size_t phase = 0; phase < reader.phases(); ++phase) {
      sum[n - 1](run, phase, {tables + first * stride + phase, reader.step(), stride},
                 {sums, 4 * first + phase});
    }
  }
  if (kOneLane || reader.pattern() == 4) return;
  for (size_t row = 0; row < rows; ++row) {
    double* to = sums[row];
    for (size_t i = 0; i < moments; ++i, to += 4) {
      to[0] += to[2], to[1] += to[3];
      if (reader.pattern() == 1) to[0] += to[1];
    }
  }
}

// Vectors of the channels of a moment: no wider than they were stored, or reading them would wait
// for the stores.
using ChannelTag = hn::CappedTag<double, kMaxChannels>;

// to += from
GAUNT_LANES void AddMoments(size_t moments, const double* from, double* to) {
  const ChannelTag d;
  for (size_t i = 0; i < kMaxChannels * moments; i += hn::Lanes(d)) {
    hn::StoreU(hn::Add(hn::LoadU(d, to + i), hn::LoadU(d, from + i)), d, to + i);
  }
}

// The sum and the difference of both, in their places.
GAUNT_LANES void SumAndDifference(size_t moments, double* a, double* b) {
  const ChannelTag d;
  for (size_t i = 0; i < kMaxChannels * moments; i += hn::Lanes(d)) {
    const auto first = hn::LoadU(d, a + i), second = hn::LoadU(d, b + i);
    hn::StoreU(hn::Add(first, second), d, a + i);
    hn::StoreU(hn::Sub(first, second), d, b + i);
  }
}

// Lanes f .. of a table of one number per texel, repeated for each float of the pattern.
GAUNT_LANES V Repeat(const float* numbers, const int32_t* lane_texels, size_t f, size_t pattern) {
  const LaneTag d;
  return hn::TableLookupLanes(hn::LoadU(d, numbers + f / pattern),
                              hn::SetTableIndices(d, lane_texels));
}

// Which texel of a vector each lane belongs to.
struct LaneTexels {
  HWY_ALIGN int32_t index[kMaxLanes];
  explicit LaneTexels(size_t pattern) {
    for (size_t i = 0; i < kMaxLanes; ++i) {
      index[i] = kOneLane ? 0 : static_cast<int32_t>(i / pattern);
    }
  }
};

// Floats of tables: they share a frame of the stack with what else a run needs.
constexpr size_t kTableFloats = 2816;
// Tables that fit for the shortest run.
constexpr size_t kMaxTables = kTableFloats / (32 * kMaxChannels);

// Texels of a run: as many as leave room for the tables, and no more than a row has.
constexpr size_t RunLength(size_t tables, size_t pattern, size_t width) {
  size_t run = kMaxRun;
  while (run * tables * pattern > kTableFloats) run /= 2;
  return std::min(run, RoundUp(width, kMaxLanes));
}

}  // namespace gaunt::project::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROJECT_ROWS_INL_H_
