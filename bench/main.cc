// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "families.h"  // generated: GAUNT_FOR_EACH_FAMILY
#include "gaunt/gaunt.h"

#define GAUNT_DECLARE(family)         \
  namespace gaunt::bench {            \
  void RegisterBenchmarks_##family(); \
  }
GAUNT_FOR_EACH_FAMILY(GAUNT_DECLARE)

int main(int argc, char** argv) {
#define GAUNT_REGISTER(family) gaunt::bench::RegisterBenchmarks_##family();
  GAUNT_FOR_EACH_FAMILY(GAUNT_REGISTER)
  benchmark::AddCustomContext("target", gaunt_target_name());
  benchmark::AddCustomContext("compiler", GAUNT_BASELINE_COMPILER);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
