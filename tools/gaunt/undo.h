// SPDX-License-Identifier: MIT
// What a signal that ends the program must not leave behind.
#ifndef GAUNT_TOOLS_GAUNT_UNDO_H_
#define GAUNT_TOOLS_GAUNT_UNDO_H_

#include <sys/types.h>

#include <string>

namespace gaunt::tool {

// While it lives, signals that end the program remove the file or the empty folder, or end the group
// of processes; the latest first.
class Undo {
 public:
  enum class Kind { kFile, kFolder };
  Undo(Kind kind, const std::string& path);
  explicit Undo(pid_t group);
  ~Undo();
  Undo(const Undo&) = delete;
  Undo& operator=(const Undo&) = delete;

  struct Entry;

 private:
  Entry* entry_;
};

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_UNDO_H_
