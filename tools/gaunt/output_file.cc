// SPDX-License-Identifier: MIT
#include "output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "bad_input.h"

namespace gaunt::tool {

namespace fs = std::filesystem;

namespace {

// Where a path leads, also if nothing is there yet.
fs::path FollowLinks(fs::path path) {
  std::error_code none;
  constexpr int kMaxLinks = 40;  // as the system has it; rings have failed before
  for (int k = 0; k < kMaxLinks && fs::is_symlink(path, none); ++k) {
    path = path.parent_path() / fs::read_symlink(path, none);
  }
  return path;
}

// What a new file gets.
fs::perms NewFileMode() {
  const mode_t mask = umask(0);
  umask(mask);
  return static_cast<fs::perms>(0666 & ~mask);
}

}  // namespace

OutputFile::OutputFile(const std::string& path) {
  const auto fail = [&](const std::string& why) -> void {
    throw BadInput("cannot write " + path + ": " + why);
  };
  if (path.empty()) throw BadInput("the file to write has no name");
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::none) fail(error.message());
  if (fs::is_directory(status)) fail("it is a folder");
  const fs::path target = FollowLinks(path);
  // As it is given, for only the system knows where links such as /dev/stdout lead; a file that is
  // deleted but open has no name either.
  if (fs::exists(status) &&
      (!fs::is_regular_file(status) || !fs::equivalent(target, path, error))) {
    in_place_ = true;
    target_ = written_ = path;
    return;
  }
  target_ = target.string();
  if (fs::exists(status) && access(target_.c_str(), W_OK) != 0) fail(std::strerror(errno));
  // A name that nobody has, and that is short, for the target's may be as long as names can be.
  constexpr size_t kMaxEnding = 16;
  std::string ending = target.extension().string();
  if (ending.size() > kMaxEnding) ending.clear();
  for (int k = 0;; ++k) {
    const std::string name =
        ".gaunt-" + std::to_string(getpid()) + "-" + std::to_string(k) + ending;
    written_ = (target.parent_path() / name).string();
    // Private until it is complete, for its target may be so.
    const int file = open(written_.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0600);
    if (file >= 0) {
      close(file);
      undo_.emplace(Undo::Kind::kFile, written_);
      return;
    }
    if (errno != EEXIST) fail(std::strerror(errno));
  }
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (!in_place_ && !committed_) fs::remove(written_, ignored);
}

void OutputFile::Commit() {
  std::error_code error;
  if (!in_place_) {
    const fs::file_status replaced = fs::status(target_, error);
    fs::permissions(written_, fs::exists(replaced) ? replaced.permissions() : NewFileMode(), error);
    fs::rename(written_, target_, error);
  }
  if (error) throw std::runtime_error("cannot write " + target_ + ": " + error.message());
  committed_ = true;
}

bool IsStdout(const std::string& path) {
  struct stat file = {}, out = {};
  return stat(path.c_str(), &file) == 0 && fstat(STDOUT_FILENO, &out) == 0 &&
         file.st_dev == out.st_dev && file.st_ino == out.st_ino;
}

void PrepareFolder(const std::string& path) {
  const fs::path folder = path;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw BadInput("cannot make " + path + ": " + error.message());
  // A new file of a name that nobody can foresee.
  std::string trial = (folder / ".gaunt-XXXXXX").string();
  const int file = mkstemp(trial.data());
  if (file < 0) throw BadInput("cannot write to " + path + ": " + std::strerror(errno));
  close(file);
  unlink(trial.c_str());
}

}  // namespace gaunt::tool
