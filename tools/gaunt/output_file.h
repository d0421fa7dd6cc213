// SPDX-License-Identifier: MIT
// Files that are written whole or not at all, and folders for them.
#ifndef GAUNT_TOOLS_GAUNT_OUTPUT_FILE_H_
#define GAUNT_TOOLS_GAUNT_OUTPUT_FILE_H_

#include <optional>
#include <string>

#include "undo.h"

namespace gaunt::tool {

// A new file beside the target, which takes its place when it is complete. Links are followed; what
// is no regular file, such as a device or a pipe, is written itself. Nobody else can read the new
// file before it is complete, and a signal that ends the program removes it.
class OutputFile {
 public:
  // Throws BadInput if the file cannot be written.
  explicit OutputFile(const std::string& path);
  ~OutputFile();  // without Commit() nothing has changed
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  // Where to write; it has the target's ending, unless that is very long.
  const std::string& path() const { return written_; }
  // Throws std::runtime_error.
  void Commit();

 private:
  std::string target_;
  std::string written_;
  bool in_place_ = false;
  bool committed_ = false;
  std::optional<Undo> undo_;
};

// Whether a path leads to the program's stdout, which then has no room for other text.
bool IsStdout(const std::string& path);

// Makes a folder if there is none. Throws BadInput if no file can be written there.
void PrepareFolder(const std::string& path);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_OUTPUT_FILE_H_
