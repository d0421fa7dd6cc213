// SPDX-License-Identifier: MIT
// GAUNT_EXPORT_FAMILY(family): defines gaunt::family::Kernels(), the family's table for the chosen
// target, from the GetTable() of each compiled target. The only dispatch code in the library.
#include "simd/target.h"

#undef GAUNT_EXPORT_FAMILY
#if HWY_ONCE
#define GAUNT_EXPORT_FAMILY(family)                                                              \
  namespace gaunt::family {                                                                      \
  HWY_EXPORT(GetTable);                                                                          \
  const Table& Kernels() {                                                                       \
    constexpr bool kOneTarget =                                                                  \
        sizeof(HWY_DISPATCH_TABLE(GetTable)) == sizeof(HWY_DISPATCH_TABLE(GetTable)[0]);         \
    return *HWY_DISPATCH_TABLE(GetTable)[kOneTarget ? 0 : ::gaunt::simd::ChosenTargetIndex()](); \
  }                                                                                              \
  }                                                                                              \
  static_assert(true, "")
#else
#define GAUNT_EXPORT_FAMILY(family) static_assert(true, "")
#endif
