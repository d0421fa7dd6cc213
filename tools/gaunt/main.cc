// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "command.h"

namespace {

// One line, whatever names of files are in it.
void PrintError(std::string message) {
  const auto control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
  std::replace_if(message.begin(), message.end(), control, '?');
  std::fprintf(stderr, "gaunt: %s\n", message.c_str());  // which does not throw if that fails
}

// -.5 as -0.5: CLI11 takes the one for an option.
std::vector<std::string> Arguments(int argc, char** argv) {
  std::vector<std::string> arguments(argv, argv + argc);
  for (std::string& argument : arguments) {
    if (argument == "--") break;
    char* end = nullptr;
    std::strtod(argument.c_str(), &end);
    if (argument.rfind("-.", 0) == 0 && *end == '\0') argument.insert(1, "0");
  }
  return arguments;
}

int Run(int argc, char** argv) {
  CLI::App app("Spherical-harmonic lighting at SIMD speed", "gaunt");
  app.require_subcommand(1);
  gaunt::tool::AddInfo(app);
  gaunt::tool::AddOpcount(app);
  gaunt::tool::AddFrame(app);
  gaunt::tool::AddFormats(app);
  gaunt::tool::AddPoints(app);
  gaunt::tool::AddRotate(app);
  gaunt::tool::AddPack(app);
  gaunt::tool::AddUnpack(app);
  gaunt::tool::AddTranscode(app);
  gaunt::tool::AddChart(app);
  const std::vector<std::string> arguments = Arguments(argc, argv);
  std::vector<const char*> pointers;
  pointers.reserve(arguments.size());
  for (const std::string& argument : arguments) pointers.push_back(argument.c_str());
  try {
    app.parse(argc, pointers.data());
  } catch (const CLI::Success& success) {  // --help
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    PrintError(error.what());
    return gaunt::tool::kExitBadInput;
  } catch (const gaunt::tool::BadInput& error) {
    PrintError(error.what());
    return gaunt::tool::kExitBadInput;
  } catch (const std::bad_alloc&) {
    PrintError("out of memory");
    return gaunt::tool::kExitFailure;
  } catch (const std::exception& error) {
    PrintError(error.what());
    return gaunt::tool::kExitFailure;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const int code = Run(argc, argv);
  // What is left in the buffer may find no room.
  if (std::fflush(stdout) != 0 && code == 0) {
    PrintError(std::string("cannot write to stdout: ") + std::strerror(errno));
    return gaunt::tool::kExitFailure;
  }
  if (std::ferror(stdout) != 0 && code == 0) {
    PrintError("cannot write to stdout");
    return gaunt::tool::kExitFailure;
  }
  return code;
}
