// SPDX-License-Identifier: MIT
#include "output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "bad_input.h"

namespace gaunt::tool {

namespace fs = std::filesystem;

namespace {

// What a signal that ends the program removes; nullptr: nothing. A copy, which a handler may read
// at any time.
std::atomic<char*> unfinished{nullptr};

void RemoveAndEnd(int signal) {
  if (const char* file = unfinished) unlink(file);
  raise(signal);  // whose action is the default again
}

void RemoveOnSignals(const std::string& file) {
  std::free(unfinished.exchange(strdup(file.c_str())));
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action = {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_DFL) continue;  // such as ignored ones, of nohup
    action.sa_handler = RemoveAndEnd;
    action.sa_flags = SA_RESETHAND | SA_NODEFER;
    sigaction(signal, &action, nullptr);
  }
}

}  // namespace

OutputFile::OutputFile(const std::string& path) {
  const auto fail = [&](const std::string& why) -> void {
    throw BadInput("cannot write " + path + ": " + why);
  };
  std::error_code error;
  const fs::path target = fs::weakly_canonical(path, error);
  if (error) fail(error.message());
  target_ = target.string();
  if (fs::is_directory(target, error)) fail("it is a folder");
  if (fs::exists(target, error) && !fs::is_regular_file(target, error)) {
    in_place_ = true;
    written_ = target_;
    return;
  }
  if (fs::exists(target, error) && access(target_.c_str(), W_OK) != 0) fail(std::strerror(errno));
  // A name that nobody has.
  for (int k = 0;; ++k) {
    const std::string name = "." + target.stem().string() + "-" + std::to_string(getpid()) + "-" +
                             std::to_string(k) + target.extension().string();
    written_ = (target.parent_path() / name).string();
    const int file = open(written_.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0666);
    if (file >= 0) {
      close(file);
      RemoveOnSignals(written_);
      return;
    }
    if (errno != EEXIST) fail(std::strerror(errno));
  }
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (!in_place_ && !committed_) fs::remove(written_, ignored);
  std::free(unfinished.exchange(nullptr));
}

void OutputFile::Commit() {
  std::error_code error;
  if (!in_place_) {
    const fs::file_status replaced = fs::status(target_, error);
    if (fs::exists(replaced)) fs::permissions(written_, replaced.permissions(), error);
    fs::rename(written_, target_, error);
  }
  if (error) throw std::runtime_error("cannot write " + target_ + ": " + error.message());
  committed_ = true;
}

void PrepareFolder(const std::string& path) {
  const fs::path folder = path;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw BadInput("cannot make " + path + ": " + error.message());
  const fs::path trial = folder / ".gaunt-trial";
  const bool writable = std::ofstream(trial).put('x').good();
  fs::remove(trial, error);
  if (!writable) throw BadInput("cannot write to " + path);
}

}  // namespace gaunt::tool
