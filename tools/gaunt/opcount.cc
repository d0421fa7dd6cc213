// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "simd/count.h"

namespace gaunt::tool {
namespace {

struct OpcountOptions {
  bool csv = false;
  bool json = false;
};

void PrintRows(const OperationRows& rows) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const OperationRow& row : rows) {
    const Operations& o = row.operations;
    out.push_back({{"op", row.op},
                   {"order", row.order},
                   {"variant", row.variant},
                   {"mul", o.mul},
                   {"fma", o.fma},
                   {"add", o.add},
                   {"ports", o.Ports()},
                   {"div", o.div}});
  }
  PrintJson(out);
}

void PrintOpcount(const OpcountOptions& options) {
  const OperationRows rows = AllOperations();
  if (options.json) return PrintRows(rows);
  if (options.csv) {
    fmt::print("op,order,variant,mul,fma,add,ports\n");
    for (const OperationRow& row : rows) {
      const Operations& o = row.operations;
      fmt::print("{},{},{},{},{},{},{}\n", row.op, row.order, row.variant, o.mul, o.fma, o.add,
                 o.Ports());
    }
    return;
  }
  fmt::print("{:22}{:8}{:18}{:>6}{:>6}{:>6}{:>7}\n", "op", "order", "variant", "mul", "fma", "add",
             "ports");
  for (const OperationRow& row : rows) {
    const Operations& o = row.operations;
    fmt::print("{:22}{:8}{:18}{:>6}{:>6}{:>6}{:>7}\n", row.op, row.order, row.variant, o.mul, o.fma,
               o.add, o.Ports());
  }
}

}  // namespace

void AddOpcount(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "opcount",
      "Multiplications, fused multiply-adds and additions that each kernel executes "
      "for one item; multiplies = mul + fma, ports = mul + fma + add");
  const auto options = std::make_shared<OpcountOptions>();
  CLI::Option* csv = command->add_flag("--csv", options->csv, "Print comma-separated values");
  command->add_flag("--json", options->json, "Print JSON")->excludes(csv);
  command->callback([options] { PrintOpcount(*options); });
}

}  // namespace gaunt::tool
