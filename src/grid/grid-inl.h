// SPDX-License-Identifier: MIT
// Kernels of trilinear interpolation: positions in lanes.
#if defined(GAUNT_GRID_GRID_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_GRID_GRID_INL_H_
#undef GAUNT_GRID_GRID_INL_H_
#else
#define GAUNT_GRID_GRID_INL_H_
#endif

#include <algorithm>

#include "grid/grid.h"
#include "simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::grid::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Lanes with whole numbers: indices of probes, which are unsigned and wrap.
struct IndexLanes : Lanes {
  using IndexTag = hn::RebindToUnsigned<LaneTag>;
  using I = hn::Vec<IndexTag>;
  using Mask = hn::Mask<LaneTag>;

  GAUNT_LANES Mask IsNumber(V v) const { return hn::Eq(v, v); }
  GAUNT_LANES V Trunc(V v) const { return hn::Trunc(v); }
  GAUNT_LANES I Index(uint32_t i) const { return hn::Set(IndexTag(), i); }
  // `base` + whole * times, of whole numbers from 0 up.
  GAUNT_LANES I Step(I base, V whole, uint32_t times) const {
    const hn::RebindToSigned<LaneTag> di;
    const I steps = hn::BitCast(IndexTag(), hn::ConvertTo(di, whole));
    return hn::Add(base, hn::Mul(steps, Index(times)));
  }
  GAUNT_LANES I Plus(I index, uint32_t more) const { return hn::Add(index, Index(more)); }

  // The brick of a cell: its first probe, its size, and whether there is one.
  GAUNT_LANES Mask FindBrick(const Bricks& bricks, I cell, I& first, V& size) const {
    first = Load(bricks.cells, hn::Add(cell, cell));
    const I cells = Load(bricks.cells + 1, hn::Add(cell, cell));
    const I none = Index(0xFFFF0000u);
    const auto known = hn::And(hn::Eq(hn::And(hn::Sub(cells, Index(1)), none), Index(0)),
                               hn::Eq(hn::Min(first, Index(bricks.last_first)), first));
    const I some = hn::IfThenElse(known, cells, Index(1));
    size = hn::ConvertTo(LaneTag(), hn::BitCast(hn::RebindToSigned<IndexTag>(), some));
    first = hn::IfThenElseZero(known, first);
    return hn::RebindMask(LaneTag(), known);
  }

  // 1 where the probe takes part, else 0. Lanes that are not `known` have an index all the same, of
  // a probe that exists.
  GAUNT_LANES V Validity(ValidBits valid, Mask known, I index) const {
    const I word = Load(valid, hn::ShiftRight<5>(index));
    const I bit = hn::And(hn::Shr(word, hn::And(index, Index(31))), Index(1));
    const V one = hn::ConvertTo(LaneTag(), hn::BitCast(hn::RebindToSigned<IndexTag>(), bit));
    return hn::IfThenElseZero(known, one);
  }

  // An index as the bits of a float, or those of none.
  GAUNT_LANES V IndexOrNone(Mask known, I index) const {
    const IndexTag d;
    const I none = Index(UINT32_MAX);
    return hn::BitCast(LaneTag(), hn::IfThenElse(hn::RebindMask(d, known), index, none));
  }

 private:
  static GAUNT_LANES I Load(const uint32_t* data, I index) {
    return hn::GatherIndex(IndexTag(), data, hn::BitCast(hn::RebindToSigned<IndexTag>(), index));
  }
};

// The coordinate along an axis, in 0 .. last; 0 of what is not a number.
template <class K, class V>
GAUNT_LANES V Coordinate(const K& k, const Lattice& lattice, size_t axis, V position) {
  const V from = Sub(position, k(static_cast<double>(lattice.origin[axis])));
  const V u = Mul(from, k(static_cast<double>(lattice.scale[axis])));
  const V positive = IfThenElseZero(Gt(u, k(0.0)), u);
  return Min(positive, k(static_cast<double>(lattice.last[axis])));
}

// The cell of a coordinate, which is the last one of `cells` at its far end.
template <class K, class V>
GAUNT_LANES V CellOf(const K& k, double cells, V u) {
  return Min(k.Trunc(u), k(cells > 1.0 ? cells - 1.0 : 0.0));
}

// The index of the corner of a cell, for coordinates 0 .. cells_*, which become fractions of it.
template <class K, class I, class V>
GAUNT_LANES I SplitCell(const K& k, I first, const uint32_t* strides, double cells_x,
                        double cells_y, double cells_z, V& x, V& y, V& z) {
  const V cx = CellOf(k, cells_x, x), cy = CellOf(k, cells_y, y), cz = CellOf(k, cells_z, z);
  x = Sub(x, cx), y = Sub(y, cy), z = Sub(z, cz);
  return k.Step(k.Step(k.Step(first, cx, strides[0]), cy, strides[1]), cz, strides[2]);
}

// 1 for the corners of a cell that lie lower along an axis: bit `axis` of the tap is 0.
constexpr float SideOf(uint32_t tap, uint32_t axis) { return (tap >> axis & 1) != 0 ? 0.0f : 1.0f; }

// From the lowest corner to that of a tap.
inline uint32_t StepTo(const uint32_t* steps, uint32_t tap) {
  return ((tap & 1) != 0 ? steps[0] : 0) + ((tap & 2) != 0 ? steps[1] : 0) +
         ((tap & 4) != 0 ? steps[2] : 0);
}

// A grid, of which Find() gives the corner of the cell that a position is in, and fractions of it.
struct InGrid {
  Grid grid;

  // From a corner to the next along each axis.
  void Steps(uint32_t* steps) const {
    for (size_t a = 0; a < 3; ++a) steps[a] = grid.lattice.last[a] > 0.0f ? grid.strides[a] : 0;
  }

  // False where there is none.
  template <class K, class In, class I, class V>
  GAUNT_LANES auto Find(const K& k, const In& position, I& first, V& x, V& y, V& z) const {
    const V px = position(0), py = position(1), pz = position(2);
    const Lattice& lattice = grid.lattice;
    x = Coordinate(k, lattice, 0, px);
    y = Coordinate(k, lattice, 1, py);
    z = Coordinate(k, lattice, 2, pz);
    first = SplitCell(k, k.Index(grid.first), grid.strides, lattice.last[0], lattice.last[1],
                      lattice.last[2], x, y, z);
    return And(And(k.IsNumber(px), k.IsNumber(py)), k.IsNumber(pz));
  }
};

// From the coordinate among cells to that inside a brick of `size` cells, which begins at a multiple
// of its size; cell: the whole part. (cell + 1/2) / size is never near a whole number.
template <class K, class V>
GAUNT_LANES V InBrick(const K& k, V u, V cell, V size, V reciprocal, double edge) {
  const V begin = Mul(k.Trunc(Mul(Add(cell, k(0.5)), reciprocal)), size);
  const V local = Mul(Mul(Sub(u, begin), k(edge)), reciprocal);
  return Min(local, k(edge));
}

// Bricks, in the same way.
struct InBricks {
  Bricks bricks;

  void Steps(uint32_t* steps) const { std::copy_n(bricks.strides, 3, steps); }

  template <class K, class In, class I, class V>
  GAUNT_LANES auto Find(const K& k, const In& position, I& first, V& x, V& y, V& z) const {
    const V px = position(0), py = position(1), pz = position(2);
    const Lattice& lattice = bricks.lattice;
    x = Coordinate(k, lattice, 0, px);
    y = Coordinate(k, lattice, 1, py);
    z = Coordinate(k, lattice, 2, pz);
    const V cx = CellOf(k, lattice.last[0], x);
    const V cy = CellOf(k, lattice.last[1], y);
    const V cz = CellOf(k, lattice.last[2], z);
    I cell = k.Step(k.Index(0), cx, bricks.cell_strides[0]);
    cell = k.Step(cell, cy, bricks.cell_strides[1]);
    cell = k.Step(cell, cz, bricks.cell_strides[2]);
    V size = cx;
    const auto has_brick = k.FindBrick(bricks, cell, first, size);
    const V reciprocal = Div(k(1.0), size);
    const double edge = static_cast<double>(bricks.probes - 1);
    x = InBrick(k, x, cx, size, reciprocal, edge);
    y = InBrick(k, y, cy, size, reciprocal, edge);
    z = InBrick(k, z, cz, size, reciprocal, edge);
    first = SplitCell(k, first, bricks.strides, edge, edge, edge, x, y, z);
    return And(has_brick, And(And(k.IsNumber(px), k.IsNumber(py)), k.IsNumber(pz)));
  }
};

// The corner, and the fractions: what the taps of an item are made of where all probes are valid.
template <class Where>
struct FindCorner {
  Where where;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& position, const Out& corner) const {
    using V = typename K::V;
    V x, y, z;
    auto first = k.Index(0);
    const auto known = where.Find(k, position, first, x, y, z);
    corner(0, k.IndexOrNone(known, first));
    corner(1, x);
    corner(2, y);
    corner(3, z);
  }
};

// A weight of an item: a factor for each axis, 1 - f where `side` is 1 and f where it is 0.
template <class V>
GAUNT_LANES V WeightOf(V x, V y, V z, V side_x, V side_y, V side_z) {
  const V yz = Mul(Abs(Sub(side_y, y)), Abs(Sub(side_z, z)));
  return Mul(yz, Abs(Sub(side_x, x)));
}

// Taps where probes may be not valid.
template <class Where>
struct ValidTaps {
  Where where;
  ValidBits valid;

  template <class K, class In, class Out>
  GAUNT_LANES void operator()(const K& k, const In& position, const Out& indices,
                              const Out& weights) const {
    using V = typename K::V;
    V x, y, z;
    auto first = k.Index(0);
    const auto known = where.Find(k, position, first, x, y, z);
    uint32_t steps[3];
    where.Steps(steps);

    typename K::template Slots<kTaps> valid_of;
    V fewest = k(1.0);
    for (uint32_t t = 0; t < kTaps; ++t) {
      const uint32_t step = StepTo(steps, t);
      const V one = k.Validity(valid, known, k.Plus(first, step));
      fewest = Min(fewest, one);
      valid_of(t, one);
      indices(t, k.IndexOrNone(Gt(one, k(0.0)), k.Plus(first, step)));
    }
    const auto all = Gt(fewest, k(0.0));
    const auto inside = [&](V f) HWY_ATTR {
      const V kept = Min(Max(f, k(kLeastFraction)), k(1.0 - kLeastFraction));
      return IfThenElse(all, f, kept);
    };
    x = inside(x), y = inside(y), z = inside(z);
    V sum = k(0.0);
    for (uint32_t t = 0; t < kTaps; ++t) {
      const V weight = WeightOf(x, y, z, k(SideOf(t, 0)), k(SideOf(t, 1)), k(SideOf(t, 2)));
      const V part = Mul(valid_of(t), weight);
      sum = Add(sum, part);
      valid_of(t, part);
    }
    const V share = IfThenElseZero(Gt(sum, k(0.0)), Div(k(1.0), sum));
    const V factor = IfThenElse(all, k(1.0), share);
    for (size_t t = 0; t < kTaps; ++t) weights(t, Mul(factor, valid_of(t)));
  }
};

}  // namespace gaunt::grid::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_GRID_GRID_INL_H_
