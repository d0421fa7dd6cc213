#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# check.sh [OPTION...]: installs what is missing with apt, builds everything, and runs all tests on every
# SIMD target of this machine. Times are for two cores.
#   (none)       release build with g++, tests, examples, benchmarks run once: 18 minutes
#   --clang      the same with clang++: 18 minutes more
#   --sanitize   tests of AVX2 under address and undefined-behaviour sanitizers: 6 minutes more
#   --fuzz       a million inputs in each fuzzer, with clang++ and sanitizers: 8 minutes more
#   --arm        tests on NEON, SVE and SVE2 under qemu-user: about an hour more
#   --all        all of these
# Closes with the numbers of tests passed and failed.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/packages.sh

clang=no sanitize=no fuzz=no arm=no
for argument in "$@"; do
  case "$argument" in
    --clang) clang=yes ;;
    --sanitize) sanitize=yes ;;
    --fuzz) fuzz=yes ;;
    --arm) arm=yes ;;
    --all) clang=yes sanitize=yes fuzz=yes arm=yes ;;
    -h|--help) sed -n '3,11s/^# \{0,1\}//p' "$0"; exit 0 ;;
    *) echo "check.sh: unknown option $argument; see --help" >&2; exit 2 ;;
  esac
done

log=$(mktemp)
trap 'rm -f "$log"' EXIT

# run_tests NAME DIRECTORY: adds to passed and failed.
passed=0 failed=0
run_tests() {
  echo "== $1"
  local status=0
  ctest --test-dir "$2" --output-on-failure -j "$(nproc)" >"$log" 2>&1 || status=$?
  local all bad
  all=$(sed -n 's/.*tests failed out of \([0-9]*\).*/\1/p' "$log")
  bad=$(sed -n 's/.* \([0-9]*\) tests failed out of.*/\1/p' "$log")
  if [ "$status" -ne 0 ]; then
    grep -vE '^ *(Start|[0-9]+/[0-9]+ Test .* Passed)' "$log" || true
  fi
  if [ -z "$all" ]; then
    echo "check.sh: ctest did not finish in $2" >&2
    exit 1
  fi
  passed=$((passed + all - bad))
  failed=$((failed + bad))
  echo "$((all - bad)) of $all passed"
}

tools/install_packages.sh $packages_build $packages_test $packages_panorama
cmake --preset all-targets
cmake --build --preset all-targets
run_tests "g++, all targets of this machine" build/all-targets

if [ $clang = yes ]; then
  tools/install_packages.sh $packages_clang
  cmake --preset all-targets -B build/clang -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_C_COMPILER=clang
  cmake --build build/clang
  run_tests "clang++, all targets of this machine" build/clang
fi
if [ $sanitize = yes ]; then
  cmake --preset asan
  cmake --build --preset asan
  run_tests "sanitizers" build/asan
fi
if [ $fuzz = yes ]; then
  tools/install_packages.sh $packages_clang
  cmake --preset fuzz
  cmake --build --preset fuzz
  run_tests "fuzzers" build/fuzz
fi
if [ $arm = yes ]; then
  tools/install_packages.sh $packages_arm
  tools/arm_root.sh build/arm-root
  # Emulated CPUs on which Highway picks NEON, SVE2 (512 bits), SVE_256 and SVE2_128.
  cmake --preset arm
  cmake --build --preset arm
  for cpu in cortex-a53 max,sve-max-vq=4 max,sve-max-vq=2 max,sve128=on,sve256=off,sve512=off; do
    rm -f build/arm/*_tests*.cmake  # lists of tests, which depend on the CPU
    QEMU_CPU=$cpu run_tests "Arm, -cpu $cpu" build/arm
  done
fi

echo
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
