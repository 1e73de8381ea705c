// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/forked.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <exception>
#include <initializer_list>
#include <memory>
#include <string_view>
#include <system_error>

#include "adapters/worker/descendants.hpp"
#include "adapters/worker/high_files.hpp"
#include "adapters/worker/own_folder.hpp"
#include "harness/material/own_process.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::adapters {

namespace {

/// What the copy says when the function has come back, and when it got to its end: no crash and no exit() of foreign
/// code can forge it.
constexpr char returned_mark = '-', done_mark = '+';

constexpr int look_ms = 10;

[[noreturn]] void leave(int status) {
  for (;;) ::syscall(SYS_exit_group, status);  // _exit() is the program's own
}

bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Reads what there is; false at the end.
bool read_some(int in, std::string& text) {
  for (;;) {
    char buffer[4096];
    const ssize_t got = ::read(in, buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return got < 0 && errno == EAGAIN;
    text.append(buffer, static_cast<std::size_t>(got));
  }
}

struct Pipe {
  Pipe() {
    if (!high_pipe(ends)) throw std::system_error(errno, std::generic_category(), "pipe");
  }
  ~Pipe() { close_in(), close_out(); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  int in() const { return ends[0]; }
  int out() const { return ends[1]; }
  void close_in() { close(0); }
  void close_out() { close(1); }

 private:
  void close(int k) {
    if (ends[k] >= 0) ::close(ends[k]);
    ends[k] = -1;
  }
  int ends[2] = {-1, -1};
};

[[noreturn]] void run_copy(int out, const std::function<std::string()>& body, const std::function<void()>& after) {
  own_this_process();
  leave_no_marks();
  std::string text;
  try {
    text = body();
  } catch (const std::exception& error) {
    text = error.what();
  } catch (...) {
    text = "throws across the C interface";
  }
  end_a_copy();
  text += returned_mark;
  if (!write_all(out, text)) leave(1);
  if (after) after();
  end_a_copy();
  leave(write_all(out, {&done_mark, 1}) ? 0 : 1);
}

/// What the watching process tells: it stands before the text, in memory that no foreign code sees.
struct Told {
  Forked::End end;
  int signal;
  bool returned, leaves;
  std::size_t length;
};

/// Takes the marks from the end of what the copy has said.
Told told_of(std::string& text, bool in_time, int status) {
  const bool done = text.size() >= 2 && text.back() == done_mark && text[text.size() - 2] == returned_mark;
  if (done) text.pop_back();
  const bool returned = !text.empty() && text.back() == returned_mark;
  if (returned) text.pop_back();
  Told told{Forked::End::done, 0, returned, false, text.size()};
  if (!in_time) {
    told.end = Forked::End::hangs;
  } else if (WIFSIGNALED(status) || WIFSTOPPED(status)) {
    told.end = Forked::End::signal;
    told.signal = WIFSTOPPED(status) ? WSTOPSIG(status) : WTERMSIG(status);
  } else if (!done) {
    told.end = Forked::End::quit;
  }
  return told;
}

void bury(pid_t process) {
  ::kill(process, SIGKILL);
  while (::waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
  }
}

/// The process has ended, or was stopped, whoever else may hold its pipe.
bool await_death(pid_t process, int in, int patience_ms, std::string& text, int& status) {
  ::fcntl(in, F_SETFL, O_NONBLOCK);
  const std::int64_t end = now_ns() + std::int64_t{patience_ms} * 1'000'000;
  bool open = true;
  for (;;) {
    pollfd waiting{in, POLLIN, 0};
    ::poll(&waiting, open ? 1 : 0, look_ms);
    const bool over = ::waitpid(process, &status, WNOHANG | WUNTRACED) == process;  // before its last words are read
    open = open && read_some(in, text);
    if (over && WIFSTOPPED(status) && WSTOPSIG(status) != SIGSTOP) continue;  // by the user, at the terminal
    if (over && WIFSTOPPED(status)) bury(process);
    if (over) return true;
    if (now_ns() > end) return false;
  }
}

[[noreturn]] void watch(Pipe& to_host, const std::function<std::string()>& body, const std::function<void()>& after,
                        int patience_ms, const OwnFolder& folder) {
  if (!folder.enter()) leave(errno);
  adopt_orphans();
  const pid_t watcher = ::getpid();
  const auto made = [] {
    try {
      return std::make_unique<Pipe>();
    } catch (const std::system_error& error) {
      leave(error.code().value());
    }
  }();
  Pipe& from_copy = *made;
  const pid_t copy = ::fork();
  if (copy < 0) leave(errno);
  if (copy == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != watcher) leave(1);
    to_host.close_out();
    from_copy.close_in();
    run_copy(from_copy.out(), body, after);
  }
  from_copy.close_out();
  std::string text;
  int status = 0;
  const bool in_time = await_death(copy, from_copy.in(), patience_ms, text, status);
  if (!in_time) bury(copy);
  Told told = told_of(text, in_time, status);
  told.leaves = end_descendants();
  write_all(to_host.out(), {reinterpret_cast<const char*>(&told), sizeof told});
  write_all(to_host.out(), text);
  leave(0);
}

/// Until the watcher has told all, has ended, or does not answer.
std::string heard_from(pid_t watcher, int in, int patience_ms, int& status) {
  std::string heard;
  constexpr int grace_ms = 5000;  // of descendants that resist
  if (!await_death(watcher, in, patience_ms + grace_ms, heard, status)) bury(watcher);
  return heard;
}

}  // namespace

Forked in_a_child(const std::function<std::string()>& body, const std::function<void()>& after, int patience_ms) {
  const AwaitedChildren awaited;
  const OwnFolder folder;
  Pipe pipe;
  std::fflush(nullptr);  // or the copy would write it a second time
  const pid_t watcher = ::fork();
  if (watcher < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (watcher == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    pipe.close_in();
    watch(pipe, body, after, patience_ms, folder);
  }
  pipe.close_out();
  int status = 0;
  std::string heard = heard_from(watcher, pipe.in(), patience_ms, status);
  Forked found;
  Told told{};
  if (heard.size() < sizeof told) {
    if (WIFEXITED(status) && WEXITSTATUS(status) != 0)  // it had no process for the copy
      throw std::system_error(WEXITSTATUS(status), std::generic_category(), "fork");
    found.end = Forked::End::lost;
    return found;
  }
  heard.copy(reinterpret_cast<char*>(&told), sizeof told);
  found.end = told.end, found.signal = told.signal, found.returned = told.returned, found.leaves = told.leaves;
  found.text = heard.substr(sizeof told, told.length);
  return found;
}

}  // namespace assay::adapters
