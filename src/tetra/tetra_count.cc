// SPDX-License-Identifier: MIT
// Operations of a step from tetrahedron to tetrahedron, and of the weights at its end, by running
// them on counting lanes.
#include "simd/count.h"
#include "tetra/tetra-inl.h"

namespace gaunt::tetra {

void AppendOperations(OperationRows& rows);

void AppendOperations(OperationRows& rows) {
  namespace kernels = HWY_NAMESPACE;
  CountLanes::Slots<kernels::kBarycentricSlots> b;
  CountedOperations() = Operations();
  kernels::Barycentrics()(CountLanes(), CountPlanes(), Counted(), Counted(), Counted(), b);
  const Operations step = CountedOperations();
  CountedOperations() = Operations();
  kernels::Normalise()(CountLanes(), b);
  const Operations weights = CountedOperations();
  rows.push_back({"tetrahedra_taps", "1", "step", step});
  rows.push_back({"tetrahedra_taps", "1", "weights", weights});
}

}  // namespace gaunt::tetra
