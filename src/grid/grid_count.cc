// SPDX-License-Identifier: MIT
// Operations of the kernels of trilinear interpolation, by running them on counting lanes.
#include "grid/grid-inl.h"
#include "simd/count.h"

namespace gaunt::grid {

void AppendOperations(OperationRows& rows);

namespace {

// Twin of IndexLanes: arithmetic of whole numbers counts as nothing.
struct CountIndexLanes : CountLanes {
  CountedMask IsNumber(Counted) const { return {}; }
  Counted Trunc(Counted) const { return {}; }
  Counted Index(uint32_t) const { return {}; }
  Counted Step(Counted, Counted, uint32_t) const { return {}; }
  Counted Plus(Counted, uint32_t) const { return {}; }
  CountedMask FindBrick(const Bricks&, Counted, Counted&, Counted&) const { return {}; }
  Counted Validity(ValidBits, CountedMask, Counted) const { return {}; }
  Counted IndexOrNone(CountedMask, Counted) const { return {}; }
};

// Finding the corner, and the weights of the taps.
template <class Where>
Operations CountAll() {
  const CountPlanes planes;
  CountedOperations() = Operations();
  HWY_NAMESPACE::FindCorner<Where>()(CountIndexLanes(), planes, planes);
  const Operations corner = CountedOperations();
  CountedOperations() = Operations();
  const Counted one;
  HWY_NAMESPACE::WeightOf(one, one, one, one, one, one);
  return corner + kTaps * CountedOperations();
}

template <class Where>
Operations CountValid() {
  const CountPlanes planes;
  CountedOperations() = Operations();
  HWY_NAMESPACE::ValidTaps<Where>()(CountIndexLanes(), planes, planes, planes);
  return CountedOperations();
}

template <class Where>
void Append(OperationRows& rows, const char* op) {
  rows.push_back({op, "1", "all", CountAll<Where>()});
  rows.push_back({op, "1", "valid", CountValid<Where>()});
}

}  // namespace

void AppendOperations(OperationRows& rows) {
  Append<HWY_NAMESPACE::InGrid>(rows, "grid_taps");
  Append<HWY_NAMESPACE::InBricks>(rows, "brick_taps");
}

}  // namespace gaunt::grid
