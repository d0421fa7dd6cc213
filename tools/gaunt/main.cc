// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <cstdio>
#include <exception>

#include "command.h"

namespace {

// One line, without the colours and hints of libraries.
void PrintError(const std::string& message) {
  fmt::print(stderr, "gaunt: {}\n", message.substr(0, message.find('\n')));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Spherical-harmonic lighting at SIMD speed", "gaunt");
  app.require_subcommand(1);
  gaunt::tool::AddInfo(app);
  gaunt::tool::AddOpcount(app);
  gaunt::tool::AddFrame(app);
  gaunt::tool::AddPoints(app);
  gaunt::tool::AddRotate(app);
  gaunt::tool::AddChart(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    PrintError(error.what());
    return gaunt::tool::kExitBadInput;
  } catch (const gaunt::tool::BadInput& error) {
    PrintError(error.what());
    return gaunt::tool::kExitBadInput;
  } catch (const std::exception& error) {
    PrintError(error.what());
    return gaunt::tool::kExitFailure;
  }
  return 0;
}
