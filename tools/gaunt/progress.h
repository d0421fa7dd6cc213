// SPDX-License-Identifier: MIT
// A progress bar on stderr, where that is a terminal.
#ifndef GAUNT_TOOLS_GAUNT_PROGRESS_H_
#define GAUNT_TOOLS_GAUNT_PROGRESS_H_

#include <string>

namespace gaunt::tool {

class Progress {
 public:
  explicit Progress(std::string label);
  ~Progress();  // removes the bar
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void Set(double fraction);

 private:
  std::string label_;
  bool shown_;
  int drawn_ = -1;
};

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_PROGRESS_H_
