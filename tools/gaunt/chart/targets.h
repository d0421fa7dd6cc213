// SPDX-License-Identifier: MIT
// SIMD targets, which look the same in every chart.
#ifndef GAUNT_TOOLS_GAUNT_CHART_TARGETS_H_
#define GAUNT_TOOLS_GAUNT_CHART_TARGETS_H_

#include <string>
#include <vector>

namespace gaunt::tool {

// The last part of a benchmark's name is a target, in capitals, or a baseline: a scalar loop.
bool IsTarget(const std::string& name);

// Better targets first, unknown ones last.
bool TargetBefore(const std::string& a, const std::string& b);

std::string TargetColour(const std::string& target);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_CHART_TARGETS_H_
