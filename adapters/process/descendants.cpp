// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/process/descendants.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <vector>

#include "adapters/process/private_files.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::adapters {

namespace {

pid_t adopter = -1;  ///< children are forked with it

/// Whose parent that is, as /proc says it, and that is no zombie.
bool is_living_child(pid_t process, pid_t parent) {
  const ProcText stat(process, "stat");
  const char* after_name = std::strrchr(stat.text, ')');  // a name may hold anything
  char state = 'Z';
  int found = 0;
  return after_name && std::sscanf(after_name + 1, " %c %d", &state, &found) == 2 && state != 'Z' && found == parent;
}

std::vector<pid_t> living_children() {
  std::vector<pid_t> all;
  std::error_code code;
  for (std::filesystem::directory_iterator at("/proc", code), end; !code && at != end; at.increment(code)) {
    const auto process = static_cast<pid_t>(std::strtol(at->path().filename().c_str(), nullptr, 10));
    if (process > 0 && is_living_child(process, ::getpid())) all.push_back(process);
  }
  return all;
}

/// True where no child is left.
bool bury_the_dead() {
  pid_t buried = 0;
  do {
    buried = ::waitpid(-1, nullptr, WNOHANG);
  } while (buried > 0 || (buried < 0 && errno == EINTR));
  return buried < 0;
}

/// A warden or a worker, which end by themselves when their host has gone (`assay worker`).
bool is_of_workers(pid_t process) {
  const ProcText line(process, "cmdline");
  const std::size_t second = std::strlen(line.text) + 1;
  // of a process that is about to end there is nothing to read
  return line.length == 0 || (second < line.length && std::strcmp(line.text + second, "worker") == 0);
}

}  // namespace

ProcText::ProcText(pid_t process, const char* name) {
  char path[64];
  std::snprintf(path, sizeof path, "/proc/%d/%s", static_cast<int>(process), name);
  const OpenFile file(::open(path, O_RDONLY | O_CLOEXEC));
  for (ssize_t got = 1; file.number() >= 0 && got > 0 && length < sizeof text - 1;) {
    got = ::read(file.number(), text + length, sizeof text - 1 - length);
    if (got > 0) length += static_cast<std::size_t>(got);
  }
  text[length] = '\0';
}

void adopt_orphans() {
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  adopter = ::getpid();
}

bool parent_adopts() { return adopter > 0 && ::getppid() == adopter; }

void await_end(pid_t child) {
  constexpr int patience_ms = 5000;
  for (int waited = 0; ::waitpid(child, nullptr, WNOHANG) == 0; ++waited) {
    ::kill(child, waited == patience_ms ? SIGKILL : SIGCONT);  // a model may have stopped it
    ::usleep(1000);
  }
}

bool end_descendants() {
  constexpr std::int64_t patience_ns = 2'000'000'000;
  const std::int64_t begin = now_ns();
  bool any = false;
  while (!bury_the_dead() && now_ns() - begin < patience_ns) {
    const std::vector<pid_t> children = living_children();
    any = any || std::any_of(children.begin(), children.end(), [](pid_t child) { return !is_of_workers(child); });
    for (const pid_t child : children) ::kill(child, SIGKILL);
    if (children.empty()) ::usleep(1000);
  }
  return any;
}

}  // namespace assay::adapters
