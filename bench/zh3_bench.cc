// SPDX-License-Identifier: MIT
#include "bench/support.h"
namespace gaunt::bench {
GAUNT_BENCHMARKS(zh3) {}
}
