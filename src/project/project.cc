// SPDX-License-Identifier: MIT
#include "project/project.h"

#include "project/cube.h"
#include "project/legendre.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "project/project.cc"
#include <hwy/foreach_target.h>

#include "project/cubemap-inl.h"
#include "project/equirect-inl.h"
#include "project/samples-inl.h"
#include "simd/export-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::project::HWY_NAMESPACE {

const Table* GetTable() {
  static constexpr Table kTable = {&Equirect, &Cubemap, &Samples};
  return &kTable;
}

}  // namespace gaunt::project::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

GAUNT_EXPORT_FAMILY(project);
