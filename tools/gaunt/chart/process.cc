// SPDX-License-Identifier: MIT
#include "chart/process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <stdexcept>

extern char** environ;

namespace gaunt::tool {

namespace fs = std::filesystem;

std::string FindProgram(const std::string& name) {
  const auto runs = [](const std::string& path) {
    std::error_code error;
    return fs::is_regular_file(path, error) && access(path.c_str(), X_OK) == 0;
  };
  if (name.find('/') != std::string::npos) return runs(name) ? name : "";
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string candidate = folder + "/" + name;
    if (runs(candidate)) return candidate;
  }
  return "";
}

int RunProcess(const std::vector<std::string>& command,
               const std::function<void(const std::string& line)>& on_line) {
  const auto check = [&](int error) {
    if (error != 0) throw std::runtime_error("cannot run " + command[0] + ": " + strerror(error));
  };
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  int ends[2];
  check(pipe2(ends, O_CLOEXEC) == 0 ? 0 : errno);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  // In a group of its own, to be ended with all that it starts. No signal comes between its start
  // and the note of it.
  sigset_t signals, before;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals, signal);
  sigprocmask(SIG_BLOCK, &signals, &before);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
  posix_spawnattr_setsigmask(&attributes, &before);
  pid_t child = 0;
  const int error =
      posix_spawn(&child, command[0].c_str(), &actions, &attributes, arguments.data(), environ);
  std::optional<Undo> undo;
  if (error == 0) undo.emplace(child);
  sigprocmask(SIG_SETMASK, &before, nullptr);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (error != 0) close(ends[0]);
  check(error);

  FILE* output = fdopen(ends[0], "r");
  char* line = nullptr;
  size_t room = 0;
  for (ssize_t length; (length = getline(&line, &room, output)) >= 0;) {
    while (length > 0 && line[length - 1] == '\n') --length;
    on_line(std::string(line, static_cast<size_t>(length)));
  }
  std::free(line);
  std::fclose(output);
  // Its number is its own until it has been waited for.
  siginfo_t ended;
  while (waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
  }
  undo.reset();
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

TemporaryFolder::TemporaryFolder() {
  path_ = (fs::temp_directory_path() / "gaunt-XXXXXX").string();
  if (mkdtemp(path_.data()) == nullptr) {
    throw std::runtime_error("cannot make " + path_ + ": " + strerror(errno));
  }
  undo_.emplace(Undo::Kind::kFolder, path_);
}

std::string TemporaryFolder::File(const std::string& name) {
  const std::string path = path_ + "/" + name;
  files_.try_emplace(name, Undo::Kind::kFile, path);
  return path;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace gaunt::tool
