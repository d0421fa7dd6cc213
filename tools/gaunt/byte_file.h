// SPDX-License-Identifier: MIT
// Files of any size as streams of bytes, whose errors name them.
#ifndef GAUNT_TOOLS_GAUNT_BYTE_FILE_H_
#define GAUNT_TOOLS_GAUNT_BYTE_FILE_H_

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

namespace gaunt::tool {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using FileHandle = std::unique_ptr<std::FILE, CloseFile>;

class ByteReader {
 public:
  // Throws BadInput if the file cannot be read.
  explicit ByteReader(const std::string& path);

  // Fewer bytes only at the end of the file. Throws std::runtime_error.
  size_t Read(char* to, size_t bytes);
  const std::string& path() const { return path_; }
  uint64_t bytes() const { return bytes_; }  // read up to now
  std::optional<uint64_t> Size() const;      // of the whole file; none of a pipe

 private:
  std::string path_;
  FileHandle file_;
  uint64_t bytes_ = 0;
};

class ByteWriter {
 public:
  // Messages say `name`, the file that `path` will become. Throws std::runtime_error, as do the
  // others.
  ByteWriter(const std::string& path, const std::string& name);

  void Write(const char* from, size_t bytes);
  void Close();

 private:
  [[noreturn]] void Fail() const;

  std::string name_;
  FileHandle file_;
};

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_BYTE_FILE_H_
