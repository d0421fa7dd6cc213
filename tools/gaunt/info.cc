// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "command.h"
#include "gaunt/gaunt.h"

namespace gaunt::tool {
namespace {

void PrintInfo(bool json) {
  const uint32_t v = gaunt_version();
  const std::string version = fmt::format("{}.{}.{}", v / 10000, v / 100 % 100, v % 100);
  std::vector<std::string> targets;
  for (uint32_t i = 0; gaunt_target_supported(i) != nullptr; ++i) {
    targets.push_back(gaunt_target_supported(i));
  }
  const char* wanted = std::getenv("GAUNT_TARGET");
  const bool ignored = wanted != nullptr && gaunt_target_name() != std::string(wanted);
  if (json) {
    nlohmann::ordered_json info = {
        {"version", version}, {"target", gaunt_target_name()}, {"targets", targets}};
    if (wanted != nullptr) info["GAUNT_TARGET"] = {{"value", wanted}, {"ignored", ignored}};
    PrintJson(info);
    return;
  }
  fmt::print("gaunt {}\n", version);
  fmt::print("target   {}\n", gaunt_target_name());
  fmt::print("targets  {}\n", fmt::join(targets, " "));
  if (wanted != nullptr) {
    fmt::print("GAUNT_TARGET={}{}\n", wanted,
               ignored ? " is unknown or does not run here: ignored" : "");
  }
}

}  // namespace

void AddInfo(CLI::App& app) {
  CLI::App* command = app.add_subcommand("info", "Version, SIMD targets, and the one in use");
  const auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "Print JSON");
  command->callback([json] { PrintInfo(*json); });
}

}  // namespace gaunt::tool
