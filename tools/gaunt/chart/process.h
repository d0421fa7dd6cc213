// SPDX-License-Identifier: MIT
// Other programs, and a place for their files.
#ifndef GAUNT_TOOLS_GAUNT_CHART_PROCESS_H_
#define GAUNT_TOOLS_GAUNT_CHART_PROCESS_H_

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "undo.h"

namespace gaunt::tool {

// A program's path, as a shell finds it; empty if there is none.
std::string FindProgram(const std::string& name);

// Runs a program without input and waits for it; gives each line that it prints to either output.
// Returns its exit status, or 128 + the signal that ended it. Throws std::runtime_error if it
// cannot be started. A signal that ends this program ends it too.
int RunProcess(const std::vector<std::string>& command,
               const std::function<void(const std::string& line)>& on_line);

// Signals remove it with the files that File() named.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();  // removes it with all that is in it
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string File(const std::string& name);

 private:
  std::string path_;
  std::optional<Undo> undo_;
  std::map<std::string, Undo> files_;
};

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_CHART_PROCESS_H_
