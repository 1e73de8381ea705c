// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/tool_process.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "drivers/system/exit_guard.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/interrupt.hpp"

namespace assay::drivers {

namespace {

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// That of this process, in English, with its own folder for temporary files.
std::vector<std::string> environment_for(const ToolCall& call) {
  std::vector<std::string> all{"LC_ALL=C"};
  if (!call.temporary.empty()) all.push_back("TMPDIR=" + call.temporary);
  for (char** each = environ; each && *each; ++each) {
    const std::string text = *each;
    const bool replaced = text.starts_with("LC_ALL=") || text.starts_with("LANGUAGE=") ||
                          (!call.temporary.empty() && text.starts_with("TMPDIR="));
    if (!replaced) all.push_back(text);
  }
  return all;
}

/// What the child needs, made before it is: between fork and exec nothing may be allocated.
struct Prepared {
  explicit Prepared(const ToolCall& call) : words{call.program}, environment(environment_for(call)) {
    words.insert(words.end(), call.arguments.begin(), call.arguments.end());
    word_pointers = pointers_to(words);
    environment_pointers = pointers_to(environment);
  }
  std::vector<std::string> words, environment;
  std::vector<char*> word_pointers, environment_pointers;
};

[[noreturn]] void become_tool(const ToolCall& call, const Prepared& prepared, int said, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) leave_process(3);
  const auto most = static_cast<rlim_t>(call.limit_s) + 1;  // of what outlives this process, too
  const rlimit time{most, most}, no_core{0, 0};
  ::setrlimit(RLIMIT_CPU, &time);
  ::setrlimit(RLIMIT_CORE, &no_core);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXFSZ, SIGXCPU}) std::signal(signal, SIG_DFL);
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(said, STDOUT_FILENO);
  ::dup2(said, STDERR_FILENO);
  if (!call.folder.empty() && ::chdir(call.folder.c_str()) != 0) leave_process(126);
  ::execve(call.program.c_str(), prepared.word_pointers.data(), prepared.environment_pointers.data());
  leave_process(127);
}

/// Stands between the program and the tool: a compiler has children of its own, which outlive it. Whatever ends the
/// program, this process ends them all. Its status is that of the tool.
[[noreturn]] void mind_tool(const ToolCall& call, const Prepared& prepared, int said, pid_t parent) {
  ::setpgid(0, 0);  // not ended by the terminal's Ctrl-C: the program ends it, with what it has started
  sigset_t awaited, before;
  ::sigemptyset(&awaited);
  ::sigaddset(&awaited, SIGHUP);
  ::sigaddset(&awaited, SIGCHLD);
  ::sigprocmask(SIG_BLOCK, &awaited, &before);
  std::signal(SIGCHLD, SIG_DFL);  // who ignores it gets no status
  ::prctl(PR_SET_PDEATHSIG, SIGHUP);
  if (::getppid() != parent) leave_process(3);
  const pid_t own = ::getpid(), tool = ::fork();
  if (tool == 0) {
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
    become_tool(call, prepared, said, own);
  }
  if (tool < 0) leave_process(126);
  for (;;) {
    int signal = 0, status = 0;
    ::sigwait(&awaited, &signal);
    if (::waitpid(tool, &status, WNOHANG) == tool)
      leave_process(WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status));
    if (signal == SIGHUP) ::kill(0, SIGKILL);
  }
}

class Tool {
 public:
  explicit Tool(const ToolCall& call) {
    const Prepared prepared(call);
    said_ = ::memfd_create("assay-tool", MFD_CLOEXEC);
    if (said_ < 0) throw_system_error("memfd_create");
    std::fflush(nullptr);
    const pid_t parent = ::getpid();
    process_ = ::fork();
    if (process_ == 0) mind_tool(call, prepared, said_, parent);
    if (process_ < 0) {
      ::close(said_);
      throw_system_error("fork");
    }
    ::setpgid(process_, process_);  // whichever comes first
  }
  ~Tool() {
    end();
    ::close(said_);
  }
  Tool(const Tool&) = delete;
  Tool& operator=(const Tool&) = delete;

  /// Whether it has ended, by now.
  bool is_over(int& status) {
    const pid_t found = ::waitpid(process_, &status, WNOHANG);
    if (found == process_) process_ = -1;
    return found == -1 ? errno != EINTR : process_ == -1;
  }

  /// With all that it has started.
  void end() {
    if (process_ <= 0) return;
    ::kill(-process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
  }

  std::string said() const {
    constexpr off_t most = 1 << 20;
    const off_t size = std::min(::lseek(said_, 0, SEEK_END), most);
    std::string text(static_cast<std::size_t>(std::max<off_t>(size, 0)), '\0');
    const ssize_t length = ::pread(said_, text.data(), text.size(), 0);
    text.resize(length > 0 ? static_cast<std::size_t>(length) : 0);
    return text;
  }

 private:
  pid_t process_ = -1;
  int said_ = -1;
};

}  // namespace

ToolEnd run_tool(const ToolCall& call) {
  using Clock = std::chrono::steady_clock;
  const InterruptWatch watch;
  const auto start = Clock::now();
  Tool tool(call);
  ToolEnd end;
  int status = 0;
  for (useconds_t pause = 200; !tool.is_over(status); pause = std::min<useconds_t>(2 * pause, 20000)) {
    stop_if_interrupted();
    if (std::chrono::duration<double>(Clock::now() - start).count() > call.limit_s) {
      tool.end();
      end.stopped = true;
      end.status = 128 + SIGKILL;
      break;
    }
    ::usleep(pause);
  }
  stop_if_interrupted();
  if (!end.stopped) end.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  end.said = tool.said();
  return end;
}

std::string tool_in_path(const std::string& name) {
  namespace fs = std::filesystem;
  const char* value = std::getenv("PATH");
  const std::string path = value ? value : "";
  for (std::size_t begin = 0; begin < path.size();) {
    const std::size_t colon = std::min(path.find(':', begin), path.size());
    const fs::path file = fs::path(path.substr(begin, colon - begin)) / name;
    std::error_code code;
    if (file.is_absolute() && fs::is_regular_file(file, code) && ::access(file.c_str(), X_OK) == 0)
      return file.string();
    begin = colon + 1;
  }
  return {};
}

}  // namespace assay::drivers
