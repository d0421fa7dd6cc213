// SPDX-License-Identifier: MIT
#include "simd/count.h"

#include <cstdio>
#include <cstdlib>

#include "families.h"  // generated: GAUNT_FOR_EACH_FAMILY

#define GAUNT_DECLARE(family)                 \
  namespace gaunt::family {                   \
  void AppendOperations(OperationRows& rows); \
  }
GAUNT_FOR_EACH_FAMILY(GAUNT_DECLARE)
#undef GAUNT_DECLARE

namespace gaunt {

OperationRows AllOperations() {
  OperationRows rows;
#define GAUNT_APPEND(family) family::AppendOperations(rows);
  GAUNT_FOR_EACH_FAMILY(GAUNT_APPEND)
#undef GAUNT_APPEND
  return rows;
}

Operations OperationsOf(const std::string& op, const std::string& order,
                        const std::string& variant) {
  for (const OperationRow& row : AllOperations()) {
    if (row.op == op && row.order == order && row.variant == variant) return row.operations;
  }
  std::fprintf(stderr, "no operations of %s %s %s\n", op.c_str(), order.c_str(), variant.c_str());
  std::abort();
}

}  // namespace gaunt
