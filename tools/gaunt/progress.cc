// SPDX-License-Identifier: MIT
#include "progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace gaunt::tool {

Progress::Progress(std::string label)
    : label_(std::move(label)), shown_(isatty(STDERR_FILENO) == 1) {
  Set(0.0);
}

Progress::~Progress() {
  if (shown_) std::fprintf(stderr, "\r\033[K");
}

void Progress::Set(double fraction) {
  constexpr int kWidth = 40;
  const int percent = static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0));
  if (!shown_ || percent == drawn_) return;
  drawn_ = percent;
  const int full = percent * kWidth / 100;
  std::fprintf(stderr, "\r%-10s [%s%s] %3d %%", label_.c_str(),
               std::string(static_cast<size_t>(full), '#').c_str(),
               std::string(static_cast<size_t>(kWidth - full), '.').c_str(), percent);
  std::fflush(stderr);
}

}  // namespace gaunt::tool
