// SPDX-License-Identifier: MIT
#include "byte_file.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "bad_input.h"

namespace gaunt::tool {

ByteReader::ByteReader(const std::string& path) : path_(path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    throw BadInput("cannot read " + path + ": it is a folder");
  }
  file_.reset(std::fopen(path.c_str(), "rb"));
  if (!file_) throw BadInput("cannot read " + path + ": " + std::strerror(errno));
}

size_t ByteReader::Read(char* to, size_t bytes) {
  const size_t read = std::fread(to, 1, bytes, file_.get());
  if (read < bytes && std::ferror(file_.get()) != 0) {
    throw std::runtime_error("cannot read " + path_ + ": " + std::strerror(errno));
  }
  bytes_ += read;
  return read;
}

std::optional<uint64_t> ByteReader::Size() const {
  struct stat status = {};
  if (fstat(fileno(file_.get()), &status) != 0 || !S_ISREG(status.st_mode)) return {};
  return static_cast<uint64_t>(status.st_size);
}

ByteWriter::ByteWriter(const std::string& path, const std::string& name)
    : name_(name), file_(std::fopen(path.c_str(), "wb")) {
  if (!file_) Fail();
}

void ByteWriter::Write(const char* from, size_t bytes) {
  if (std::fwrite(from, 1, bytes, file_.get()) < bytes) Fail();
}

void ByteWriter::Close() {
  if (std::fclose(file_.release()) != 0) Fail();
}

void ByteWriter::Fail() const {
  throw std::runtime_error("cannot write " + name_ + ": " + std::strerror(errno));
}

}  // namespace gaunt::tool
