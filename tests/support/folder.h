// SPDX-License-Identifier: MIT
// Tests that read and write files, in a folder of their own.
#ifndef GAUNT_TESTS_SUPPORT_FOLDER_H_
#define GAUNT_TESTS_SUPPORT_FOLDER_H_

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace gaunt::test {

class FolderTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) / ("gaunt-" + std::to_string(getpid()));
    std::filesystem::create_directory(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string Path(const std::string& name) const { return (folder_ / name).string(); }

  static void Write(const std::string& path, const std::string& bytes) {
    // A new file is faster: a file system may flush one that is cut to nothing.
    std::filesystem::remove(path);
    std::ofstream(path, std::ios::binary) << bytes;
  }
  static std::string Read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  size_t FilesInFolder() const {
    return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
  }

  std::filesystem::path folder_;
};

}  // namespace gaunt::test

#endif  // GAUNT_TESTS_SUPPORT_FOLDER_H_
