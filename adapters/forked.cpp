// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/forked.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace assay::adapters {

namespace {

constexpr int patience_ms = 20000;  ///< far beyond any honest update of one point

/// What the child says when it got to its end: no crash and no exit() of the model can forge it.
constexpr char done_mark = '+';

[[noreturn]] void run_child(int out, const std::function<std::string()>& body) {
  std::string text;
  try {
    text = body();
  } catch (const std::exception& error) {
    text = error.what();
  } catch (...) {
    text = "throws across the C interface";
  }
  text += done_mark;
  const bool written = ::write(out, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  ::_exit(written ? 0 : 1);
}

/// Reads to the end or until patience ends; true at the end.
bool read_all(int in, std::string& text) {
  for (;;) {
    pollfd waiting{in, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, patience_ms);
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return false;
    char buffer[1024];
    const ssize_t got = ::read(in, buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return true;
    text.append(buffer, static_cast<std::size_t>(got));
  }
}

}  // namespace

Forked in_a_child(const std::function<std::string()>& body) {
  int ends[2];
  if (::pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  std::fflush(nullptr);  // or the child would write it a second time
  const pid_t child = ::fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    ::close(ends[0]);
    run_child(ends[1], body);
  }
  ::close(ends[1]);
  Forked found;
  const bool in_time = read_all(ends[0], found.text);
  ::close(ends[0]);
  if (!in_time) ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!in_time) {
    found.end = Forked::End::hangs;
  } else if (WIFSIGNALED(status)) {
    found.end = Forked::End::signal;
    found.signal = WTERMSIG(status);
  } else if (found.text.empty() || found.text.back() != done_mark) {
    found.end = Forked::End::quit;
  } else {
    found.text.pop_back();
  }
  return found;
}

}  // namespace assay::adapters
