// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/bounded_run.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <stdexcept>

namespace assay::fuzz {

namespace {

constexpr std::size_t most_said = std::size_t{1} << 20;

void bound(int resource, std::int64_t most) {
  rlimit limit{};
  ::getrlimit(static_cast<decltype(RLIMIT_AS)>(resource), &limit);
  limit.rlim_cur = std::min<rlim_t>(static_cast<rlim_t>(most), limit.rlim_max);
  ::setrlimit(static_cast<decltype(RLIMIT_AS)>(resource), &limit);
}

[[noreturn]] void become(const std::string& program, std::vector<char*>& argv, const std::string& folder,
                         const Bounds& bounds) {
  ::setpgid(0, 0);
  const int in = ::open("/dev/null", O_RDONLY);
  const bool there = ::chdir(folder.c_str()) == 0;
  const int out = ::open("stdout", O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int error = ::open("stderr", O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (!there || in < 0 || out < 0 || error < 0) ::_exit(127);
  ::dup2(in, STDIN_FILENO), ::dup2(out, STDOUT_FILENO), ::dup2(error, STDERR_FILENO);
  bound(RLIMIT_CPU, static_cast<std::int64_t>(std::ceil(bounds.cpu_s)));
  bound(RLIMIT_FSIZE, bounds.file_bytes);
  bound(RLIMIT_CORE, 0);
  if (bounds.address_bytes > 0) bound(RLIMIT_AS, bounds.address_bytes);
  ::execv(program.c_str(), argv.data());
  ::_exit(127);
}

/// Until the process ends or its time is up; whether it ended.
bool ends_within(pid_t child, double seconds) {
  const int handle = static_cast<int>(::syscall(SYS_pidfd_open, child, 0));
  if (handle < 0) throw std::runtime_error("pidfd_open");
  pollfd ended{handle, POLLIN, 0};
  const int found = ::poll(&ended, 1, static_cast<int>(1000 * seconds));
  ::close(handle);
  return found != 0;
}

std::string said(const std::string& file) {
  std::string text(most_said, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

double seconds_of(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

}  // namespace

Outcome run_bounded(const std::string& program, const std::vector<std::string>& words, const std::string& folder,
                    const Bounds& bounds) {
  std::string name = program;
  std::vector<char*> argv{name.data()};
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("fork");
  if (child == 0) become(program, argv, folder, bounds);
  ::setpgid(child, child);  // as it does itself, maybe only when its time is up
  Outcome outcome;
  outcome.timed_out = !ends_within(child, bounds.wall_s);
  if (outcome.timed_out) ::kill(-child, SIGKILL);
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  ::kill(-child, SIGKILL);  // processes of its own that it may have left
  outcome.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  outcome.cpu_s = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  outcome.resident_bytes = usage.ru_maxrss * std::int64_t{1024};
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.out = said(folder + "/stdout");
  outcome.error = said(folder + "/stderr");
  return outcome;
}

}  // namespace assay::fuzz
