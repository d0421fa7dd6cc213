// SPDX-License-Identifier: MIT
// What the subcommands of `gaunt` share.
#ifndef GAUNT_TOOLS_GAUNT_COMMAND_H_
#define GAUNT_TOOLS_GAUNT_COMMAND_H_

#include <CLI/CLI.hpp>
#include <string>

#include "bad_input.h"

namespace gaunt::tool {

// Exit codes.
inline constexpr int kExitFailure = 1;   // something broke on the way
inline constexpr int kExitBadInput = 2;  // arguments or files are not what they should be

// Each adds a subcommand, whose callback runs it.
void AddInfo(CLI::App& app);
void AddOpcount(CLI::App& app);
void AddFrame(CLI::App& app);
void AddPoints(CLI::App& app);
void AddRotate(CLI::App& app);
void AddChart(CLI::App& app);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_COMMAND_H_
