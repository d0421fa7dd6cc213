// SPDX-License-Identifier: MIT
// The library's own choice of SIMD target, apart from the process-wide one of Highway, which other
// users of the shared Highway library may change.
#ifndef GAUNT_SIMD_TARGET_H_
#define GAUNT_SIMD_TARGET_H_

#include <cstddef>

namespace gaunt::simd {

// Index of the chosen target in a table made by HWY_EXPORT. Chooses on first use: the target named
// by the environment variable GAUNT_TARGET if it is known and runs here, else the best.
size_t ChosenTargetIndex();

const char* ChosenTargetName();

// Chooses by name; null goes back to the choice of first use. False, changing nothing, if unknown,
// not compiled in, or not supported by this CPU.
bool SelectTarget(const char* name);

// Name of the index-th target that is compiled in and supported here, best first; null past the
// end.
const char* SupportedTargetName(size_t index);

}  // namespace gaunt::simd

#endif  // GAUNT_SIMD_TARGET_H_
