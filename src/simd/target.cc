// SPDX-License-Identifier: MIT
#include "simd/target.h"

#include <hwy/highway.h>
#include <hwy/targets.h>

#include <cstdlib>
#include <cstring>

namespace gaunt::simd {
namespace {

// Constant-initialised, so usable from other static initialisers.
hwy::ChosenTarget chosen_target;

// Targets are bits, the best one lowest.
int64_t LowestBit(int64_t targets) { return targets & -targets; }

// Highway's fallback is always there, whether or not it is in the mask of supported targets.
int64_t RunnableTargets() { return (hwy::SupportedTargets() & HWY_TARGETS) | HWY_STATIC_TARGET; }

int64_t TargetByName(const char* name) {
  for (int64_t left = RunnableTargets(); left != 0; left &= left - 1) {
    if (std::strcmp(hwy::TargetName(LowestBit(left)), name) == 0) return LowestBit(left);
  }
  return 0;
}

int64_t DefaultTarget() {
  if (const char* name = std::getenv("GAUNT_TARGET")) {
    if (const int64_t target = TargetByName(name)) return target;
  }
  return LowestBit(RunnableTargets());
}

const hwy::ChosenTarget& Chosen() {
  if (!chosen_target.IsInitialized()) chosen_target.Update(DefaultTarget());
  return chosen_target;
}

}  // namespace

size_t ChosenTargetIndex() { return Chosen().GetIndex(); }

const char* ChosenTargetName() {
  const size_t index = ChosenTargetIndex();
  hwy::ChosenTarget candidate;
  for (int64_t left = RunnableTargets(); left != 0; left &= left - 1) {
    candidate.Update(LowestBit(left));
    if (candidate.GetIndex() == index) return hwy::TargetName(LowestBit(left));
  }
  return hwy::TargetName(HWY_STATIC_TARGET);
}

bool SelectTarget(const char* name) {
  const int64_t target = name == nullptr ? DefaultTarget() : TargetByName(name);
  if (target == 0) return false;
  chosen_target.Update(target);
  return true;
}

const char* SupportedTargetName(size_t index) {
  for (int64_t left = RunnableTargets(); left != 0; left &= left - 1) {
    if (index-- == 0) return hwy::TargetName(LowestBit(left));
  }
  return nullptr;
}

}  // namespace gaunt::simd
