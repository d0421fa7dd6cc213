// SPDX-License-Identifier: MIT
// Kernels of tetrahedra: positions in lanes, each of which walks from one to the next.
#if defined(GAUNT_TETRA_TETRA_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_TETRA_TETRA_INL_H_
#undef GAUNT_TETRA_TETRA_INL_H_
#else
#define GAUNT_TETRA_TETRA_INL_H_
#endif

#include "probe/gather-inl.h"
#include "simd/lanes-inl.h"
#include "tetra/tetra.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::tetra::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Where the fields of a record are, in words.
inline constexpr size_t kRowWords = 0, kCornerWords = 9, kNeighbourWords = 12, kRecordWords = 16;

// What one step computes: barycentrics of positions in their tetrahedra; and, last, below which of
// them a position is beyond a face: never where only rounding says so.
inline constexpr size_t kBeyond = kCorners, kBarycentricSlots = kCorners + 1;
struct Barycentrics {
  template <class K, class Record, class V, class Out>
  GAUNT_LANES void operator()(const K& k, const Record& record, V x, V y, V z, Out& out) const {
    x = Sub(x, record(kCornerWords));
    y = Sub(y, record(kCornerWords + 1));
    z = Sub(z, record(kCornerWords + 2));
    V rest = k(1.0), largest = k(1.0);
    for (size_t i = 0; i < 3; ++i) {
      const size_t row = kRowWords + 3 * i;
      const V rx = record(row), ry = record(row + 1), rz = record(row + 2);
      const V b = MulAdd(rx, x, MulAdd(ry, y, Mul(rz, z)));
      // Rounding is as large as what cancels.
      const V terms = MulAdd(Abs(rx), Abs(x), MulAdd(Abs(ry), Abs(y), Mul(Abs(rz), Abs(z))));
      rest = Sub(rest, b);
      largest = Max(largest, terms);
      out(i, b);
    }
    out(3, rest);
    out(kBeyond, Mul(k(kInside), largest));
  }
};

// Weights from barycentrics of which none is far below 0.
struct Normalise {
  template <class K, class Slots>
  GAUNT_LANES void operator()(const K& k, Slots& b) const {
    using V = typename K::V;
    V sum = k(0.0);
    for (size_t i = 0; i < kCorners; ++i) {
      const V weight = Max(b(i), k(0.0));
      sum = Add(sum, weight);
      b(i, weight);
    }
    const V factor = Div(k(1.0), sum);
    for (size_t i = 0; i < kCorners; ++i) b(i, Mul(factor, b(i)));
  }
};

using IndexTag = hn::RebindToUnsigned<LaneTag>;
using I = hn::Vec<IndexTag>;
using V = hn::Vec<LaneTag>;
using IndexMask = hn::Mask<IndexTag>;

GAUNT_LANES I IndexOf(V bits) { return hn::BitCast(IndexTag(), bits); }
GAUNT_LANES V BitsOf(I index) { return hn::BitCast(LaneTag(), index); }
GAUNT_LANES IndexMask Below(I index, uint32_t count) {
  const I last = hn::Set(IndexTag(), count - 1);
  return hn::Eq(hn::Min(index, last), index);
}

// Words of records, or of corners, that lanes are at.
template <size_t kBytes>
GAUNT_LANES void Fetch(const uint8_t* rows, I at, Lanes::Slots<kBytes / 4>& words) {
  HWY_ALIGN uint32_t lanes[hn::MaxLanes(LaneTag())];
  hn::Store(at, IndexTag(), lanes);
  const uint32_t* const lane_at = lanes;
  probe::HWY_NAMESPACE::LoadWords<kBytes>(
      [=](size_t lane) { return rows + size_t{lane_at[lane]} * kBytes; }, words.data);
}

// A group of positions and where they are.
class Walk {
 public:
  GAUNT_LANES Walk(const Mesh& mesh, V x, V y, V z) : mesh_(mesh) {
    const LaneTag d;
    // Nothing overflows.
    const V farthest = hn::Set(d, static_cast<float>(kFarthest));
    const auto clamp = [&](V v)
                           HWY_ATTR { return hn::Max(hn::Min(v, farthest), hn::Neg(farthest)); };
    position_(0, clamp(x));
    position_(1, clamp(y));
    position_(2, clamp(z));
  }

  // From tetrahedra `at` to those that hold the positions, or as near as the walk gets.
  GAUNT_LANES I Find(IndexMask known, I at) {
    const IndexTag d;
    I previous = hn::Set(d, kNone);
    for (uint32_t step = 0;; ++step) {
      Fetch<sizeof(Record)>(mesh_.records, at, record_);
      Barycentrics()(Lanes(), record_, position_(0), position_(1), position_(2), b_);
      const V first = b_(0);
      const IndexMask flat = hn::Not(hn::RebindMask(d, hn::Eq(first, first)));
      I next = Lowest(at);
      if (!hn::AllFalse(d, flat)) next = hn::IfThenElse(flat, Through(at, previous, step), next);
      const IndexMask moves = hn::And(known, hn::Ne(next, at));
      if (hn::AllFalse(d, moves) || step == mesh_.step_limit) {
        Finish(flat, moves);
        return at;
      }
      previous = hn::IfThenElse(moves, at, previous);
      at = hn::IfThenElse(moves, next, at);
    }
  }

  // Weights at `at`, which changes where the walk was lost.
  GAUNT_LANES I Weigh(IndexMask known, I at) {
    const IndexTag d;
    Normalise()(Lanes(), b_);
    const V zero = hn::Zero(LaneTag());
    const IndexMask odd = hn::And(known, hn::RebindMask(d, hn::Ne(odd_(0), zero)));
    if (hn::AllFalse(d, odd)) return at;
    HWY_ALIGN uint32_t tetrahedra[hn::MaxLanes(LaneTag())];
    HWY_ALIGN uint32_t is_odd[hn::MaxLanes(LaneTag())];
    hn::Store(at, d, tetrahedra);
    hn::Store(hn::IfThenElseZero(odd, hn::Set(d, 1)), d, is_odd);
    for (size_t lane = 0; lane < hn::Lanes(d); ++lane) {
      if (is_odd[lane] == 0) continue;
      float position[3], weights[kCorners];
      for (size_t a = 0; a < 3; ++a) position[a] = position_.data[a * kStride + lane];
      FindNearest(mesh_, position, odd_.data[lane] == kLost, &tetrahedra[lane], weights);
      for (size_t i = 0; i < kCorners; ++i) b_.data[i * kStride + lane] = weights[i];
    }
    return hn::Load(d, tetrahedra);
  }

  GAUNT_LANES V Weight(size_t corner) const { return b_(corner); }

 private:
  static constexpr size_t kStride = hn::MaxLanes(LaneTag());
  // What Finish() leaves to FindNearest().
  static constexpr float kOutside = 1.0f, kLost = 2.0f;

  GAUNT_LANES I Neighbour(size_t i) const { return IndexOf(record_(kNeighbourWords + i)); }

  // The neighbour beyond the face that positions are furthest beyond, or the same again.
  GAUNT_LANES I Lowest(I at) const {
    const IndexTag d;
    V lowest = b_(kBeyond);
    I next = at;
    for (size_t i = 0; i < kCorners; ++i) {
      const V b = b_(i);
      const I neighbour = Neighbour(i);
      const IndexMask better =
          hn::And(hn::RebindMask(d, hn::Lt(b, lowest)), Below(neighbour, mesh_.tetrahedra));
      lowest = hn::IfThenElse(hn::RebindMask(LaneTag(), better), b, lowest);
      next = hn::IfThenElse(better, neighbour, next);
    }
    return next;
  }

  // The way on through a flat tetrahedron, in which no side is known: any of its neighbours, by turns
  // without a period, and back where there is no other.
  GAUNT_LANES I Through(I at, I previous, uint32_t step) const {
    I next = hn::IfThenElse(Below(previous, mesh_.tetrahedra), previous, at);
    const size_t turn = step * 0x9E3779B9u >> 30;
    for (size_t i = 0; i < kCorners; ++i) {
      const I neighbour = Neighbour((i + turn) % kCorners);
      const IndexMask usable = hn::And(Below(neighbour, mesh_.tetrahedra),
                                       hn::And(hn::Ne(neighbour, previous), hn::Ne(neighbour, at)));
      next = hn::IfThenElse(usable, neighbour, next);
    }
    return next;
  }

  // Marks positions that are beyond a face without a neighbour, or still on their way.
  GAUNT_LANES void Finish(IndexMask flat, IndexMask moves) {
    const IndexTag d;
    const LaneTag df;
    IndexMask outside = flat;
    for (size_t i = 0; i < kCorners; ++i) {
      const V b = b_(i);
      const auto beyond = hn::RebindMask(d, hn::Lt(b, b_(kBeyond)));
      outside = hn::Or(outside, hn::AndNot(Below(Neighbour(i), mesh_.tetrahedra), beyond));
    }
    const V marks = hn::IfThenElseZero(hn::RebindMask(df, outside), hn::Set(df, kOutside));
    odd_(0, hn::IfThenElse(hn::RebindMask(df, moves), hn::Set(df, kLost), marks));
  }

  const Mesh& mesh_;
  Lanes::Slots<3> position_;
  Lanes::Slots<kRecordWords> record_;
  Lanes::Slots<kBarycentricSlots> b_;
  Lanes::Slots<1> odd_;
};

// Tetrahedra are moved as the floats of the same bits, and so are indices.
struct Taps {
  Mesh mesh;

  template <class In, class InAt, class Out, class OutAt>
  GAUNT_LANES void operator()(const Lanes&, const In& position, const InAt& start,
                              const OutAt& found, const Out& indices, const Out& weights) const {
    const IndexTag d;
    const V x = position(0), y = position(1), z = position(2);
    // 0 times anything finite is 0.
    const V zero = hn::Zero(LaneTag());
    const V sum = hn::Add(hn::Mul(x, zero), hn::Add(hn::Mul(y, zero), hn::Mul(z, zero)));
    const IndexMask known = hn::RebindMask(d, hn::Eq(sum, zero));
    I at = IndexOf(start(0));
    at = hn::IfThenElseZero(Below(at, mesh.tetrahedra), at);

    Walk walk(mesh, x, y, z);
    at = walk.Weigh(known, walk.Find(known, at));
    found(0, BitsOf(at));
    Lanes::Slots<kCorners> corners;
    Fetch<sizeof(Corners)>(mesh.corners, at, corners);
    const I none = hn::Set(d, kNone);
    for (size_t i = 0; i < kCorners; ++i) {
      indices(i, BitsOf(hn::IfThenElse(known, IndexOf(corners(i)), none)));
      weights(i, hn::IfThenElseZero(hn::RebindMask(LaneTag(), known), walk.Weight(i)));
    }
  }
};

}  // namespace gaunt::tetra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_TETRA_TETRA_INL_H_
