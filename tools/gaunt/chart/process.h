// SPDX-License-Identifier: MIT
// Other programs, and a place for their files.
#ifndef GAUNT_TOOLS_GAUNT_CHART_PROCESS_H_
#define GAUNT_TOOLS_GAUNT_CHART_PROCESS_H_

#include <functional>
#include <string>
#include <vector>

namespace gaunt::tool {

// A program's path, as a shell finds it; empty if there is none.
std::string FindProgram(const std::string& name);

// Runs a program without input and waits for it; gives each line that it prints to either output.
// Returns its exit status, or 128 + the signal that ended it. Throws std::runtime_error if it
// cannot be started.
int RunProcess(const std::vector<std::string>& command,
               const std::function<void(const std::string& line)>& on_line);

class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();  // removes it with all that is in it
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string File(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_CHART_PROCESS_H_
