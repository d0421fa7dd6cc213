// SPDX-License-Identifier: MIT
// What the subcommands of `gaunt` share.
#ifndef GAUNT_TOOLS_GAUNT_COMMAND_H_
#define GAUNT_TOOLS_GAUNT_COMMAND_H_

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "bad_input.h"

namespace gaunt::tool {

// Exit codes.
inline constexpr int kExitFailure = 1;   // something broke on the way
inline constexpr int kExitBadInput = 2;  // arguments or files are not what they should be

// A check of CLI11's: what it says against a value, or nothing.
inline std::string NotEmpty(const std::string& value) {
  return value.empty() ? "the name is empty" : "";
}

// With text of the user's that need not be UTF-8.
inline void PrintJson(const nlohmann::ordered_json& json, std::FILE* to = stdout) {
  using Json = nlohmann::ordered_json;
  fmt::print(to, "{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

// Each adds a subcommand, whose callback runs it.
void AddInfo(CLI::App& app);
void AddOpcount(CLI::App& app);
void AddFrame(CLI::App& app);
void AddFormats(CLI::App& app);
void AddPoints(CLI::App& app);
void AddRotate(CLI::App& app);
void AddPack(CLI::App& app);
void AddUnpack(CLI::App& app);
void AddTranscode(CLI::App& app);
void AddChart(CLI::App& app);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_COMMAND_H_
