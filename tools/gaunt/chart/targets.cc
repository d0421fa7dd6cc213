// SPDX-License-Identifier: MIT
#include "chart/targets.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace gaunt::tool {
namespace {

struct Target {
  const char* name;
  const char* colour;
};

// Those of a machine get lighter; machines share colours.
constexpr Target kTargets[] = {
    {"AVX10_2", "#0b2f3d"},   {"AVX3_SPR", "#0e4f6e"},
    {"AVX3_ZEN4", "#17155c"}, {"AVX3_DL", "#4b3aa8"},
    {"AVX3", "#861f86"},      {"AVX2", "#cf354e"},
    {"SSE4", "#e87722"},      {"SSSE3", "#dcae1d"},
    {"SSE2", "#9db43a"},      {"SVE2_128", "#0e4f6e"},
    {"SVE2", "#17155c"},      {"SVE_256", "#4b3aa8"},
    {"SVE", "#861f86"},       {"NEON_BF16", "#cf354e"},
    {"NEON", "#e87722"},      {"NEON_WITHOUT_AES", "#dcae1d"},
    {"EMU128", "#5f9e6e"},    {"SCALAR", "#7fc4c0"},
};
constexpr char kUnknown[] = "#2b8f96";

const Target* Find(const std::string& name) {
  return std::find_if(std::begin(kTargets), std::end(kTargets),
                      [&](const Target& target) { return name == target.name; });
}

}  // namespace

bool IsTarget(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

bool TargetBefore(const std::string& a, const std::string& b) {
  const Target *of_a = Find(a), *of_b = Find(b);
  return of_a != of_b ? of_a < of_b : a < b;
}

std::string TargetColour(const std::string& target) {
  const Target* found = Find(target);
  return found == std::end(kTargets) ? kUnknown : found->colour;
}

}  // namespace gaunt::tool
