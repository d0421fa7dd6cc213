// SPDX-License-Identifier: MIT
// Operations of the project kernels, by running them on counting lanes.
#include "project/project-inl.h"
#include "simd/count.h"
#include "simd/order.h"

namespace gaunt::project {

void AppendOperations(OperationRows& rows);

// Per texel of one channel: one pass of the sum per moment; what a row adds at its end is not
// counted.
void AppendOperations(OperationRows& rows) {
  for (int n = 1; n <= kMaxUnrolledOrder; ++n) {
    constexpr uint64_t kGroups = 1024;
    CountedOperations() = Operations();
    for (int moment = 0; moment < 2 * n - 1; ++moment) {
      HWY_NAMESPACE::WeightedSum()(CountLanes(), CountPlanes(), CountPlanes(), kGroups);
    }
    const Operations& all = CountedOperations();
    const Operations texel = {all.mul / kGroups, all.fma / kGroups,  all.add / kGroups,
                              all.div / kGroups, all.load / kGroups, all.store / kGroups};
    rows.push_back({"project_equirect", std::to_string(n), "mono", texel});
  }
}

}  // namespace gaunt::project
