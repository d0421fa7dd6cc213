// SPDX-License-Identifier: MIT
#include "undo.h"

#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>

namespace gaunt::tool {

// Never freed: a handler may read it at any time.
struct Undo::Entry {
  void (*action)(const Entry& entry);
  const char* path;
  pid_t group;
  Entry* next;
  std::atomic<bool> active{true};
};

namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGALRM, SIGPIPE, SIGXCPU};
std::atomic<Undo::Entry*> latest{nullptr};

void UndoAllAndEnd(int signal) {
  for (const Undo::Entry* entry = latest; entry != nullptr; entry = entry->next) {
    if (entry->active) entry->action(*entry);
  }
  raise(signal);  // when the handler has returned; its action is the default again
}

void InstallHandler() {
  signal(SIGXFSZ, SIG_IGN);  // a write that passes the limit fails instead
  for (const int signal : kSignals) {
    struct sigaction action = {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_DFL) continue;  // such as ignored ones, of nohup
    action.sa_handler = UndoAllAndEnd;
    action.sa_flags = SA_RESETHAND;
    for (const int other : kSignals) sigaddset(&action.sa_mask, other);
    sigaction(signal, &action, nullptr);
  }
}

Undo::Entry* Add(void (*action)(const Undo::Entry& entry), const char* path, pid_t group) {
  auto* entry = new Undo::Entry{action, path, group, latest};
  while (!latest.compare_exchange_weak(entry->next, entry)) {
  }
  InstallHandler();
  return entry;
}

void RemoveFile(const Undo::Entry& entry) { unlink(entry.path); }
void RemoveFolder(const Undo::Entry& entry) { rmdir(entry.path); }
// Waits for its leader, which could write until then.
void EndGroup(const Undo::Entry& entry) {
  kill(-entry.group, SIGKILL);
  waitpid(entry.group, nullptr, 0);
}

}  // namespace

Undo::Undo(Kind kind, const std::string& path)
    : entry_(Add(kind == Kind::kFile ? RemoveFile : RemoveFolder, strdup(path.c_str()), 0)) {}
Undo::Undo(pid_t group) : entry_(Add(EndGroup, nullptr, group)) {}
Undo::~Undo() { entry_->active = false; }

}  // namespace gaunt::tool
