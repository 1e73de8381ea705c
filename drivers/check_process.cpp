// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>

#include "drivers/exit_guard.hpp"
#include "drivers/input_error.hpp"
#include "drivers/interrupt.hpp"
#include "drivers/output/number_format.hpp"

namespace assay::drivers {

namespace {

using Clock = std::chrono::steady_clock;

void write_all(int file, const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t written = ::write(file, text.data() + at, text.size() - at);
    if (written < 0 && errno != EINTR) leave_process(3);
    if (written > 0) at += static_cast<std::size_t>(written);
  }
}

/// Records, each ended by a NUL: '!' and the material, '@' and the id of a test that begins; the report at last.
[[noreturn]] void serve(const CheckTask& task, int out) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) ::dup2(nowhere, STDOUT_FILENO);
  try {
    const std::string end(1, '\0');
    const CheckedMaterial checked =
        task.run({[&](const CheckedMaterial& material) { write_all(out, "!" + check_json(material) + end); },
                  [&](const std::string& id) { write_all(out, "@" + id + end); }});
    write_all(out, check_json(checked));
    leave_process(0);
  } catch (const std::exception& error) {
    CheckedMaterial checked;
    checked.name = task.name;
    checked.error = error.what();
    write_all(out, check_json(checked));
    leave_process(0);
  }
}

struct Child {
  std::size_t task = 0;
  pid_t pid = -1;
  int in = -1;
  Clock::time_point end;
  std::string said;
  bool late = false;
};

Child start(const std::vector<CheckTask>& tasks, std::size_t task, double limit_s) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw SystemError(std::string("pipe: ") + std::strerror(errno));
  Child child{task, ::fork(), ends[0], Clock::now() + std::chrono::milliseconds(std::llround(1e3 * limit_s)), {}};
  if (child.pid < 0) throw SystemError(std::string("fork: ") + std::strerror(errno));
  if (child.pid == 0) {
    ::close(ends[0]);
    serve(tasks[task], ends[1]);
  }
  ::close(ends[1]);
  return child;
}

std::string how_it_ended(const Child& child, int status, double limit_s) {
  if (child.late) return "did not come back within " + rounded_text(limit_s, 3) + " s";
  if (WIFSIGNALED(status)) {
    return "died of signal " + std::to_string(WTERMSIG(status)) + " (" + strsignal(WTERMSIG(status)) + ")";
  }
  return "ended the process with status " + std::to_string(WEXITSTATUS(status));
}

CheckedMaterial result_of(const Child& child, int status, const CheckTask& task, double limit_s) {
  std::string test = "loading";
  CheckedMaterial checked;
  checked.name = task.name;
  std::size_t at = 0, end = 0;
  for (; (end = child.said.find('\0', at)) != std::string::npos; at = end + 1) {
    const std::string record = child.said.substr(at + 1, end - at - 1);
    if (child.said[at] == '@') test = record;
    if (child.said[at] == '!') checked = checked_of_json(record).value_or(checked);
  }
  if (const auto whole = checked_of_json(child.said.substr(at))) return *whole;
  const std::string sentence = "the model " + how_it_ended(child, status, limit_s) + " in the test " + test;
  const char* cause = test == "calls.arrays" && WIFSIGNALED(status) && !child.late ? check::causes::overrun
                                                                                   : check::causes::ends_process;
  checked.report.tests.push_back({.id = test, .verdict = check::Verdict::fail, .cause = cause, .sentence = sentence});
  checked.report.diagnosis.push_back({cause, sentence});
  return checked;
}

/// The children that run; what is left of them is killed.
class Children {
 public:
  Children() = default;
  Children(const Children&) = delete;
  Children& operator=(const Children&) = delete;
  ~Children() {
    for (Child& child : all) {
      ::kill(child.pid, SIGKILL);
      ::waitpid(child.pid, nullptr, 0);
      ::close(child.in);
    }
  }

  /// Waits until one has ended, and takes it out.
  std::pair<Child, int> next() {
    for (;;) {
      stop_if_interrupted();
      std::vector<pollfd> files;
      for (const Child& child : all) files.push_back({child.in, POLLIN, 0});
      ::poll(files.data(), files.size(), 50);
      for (std::size_t i = 0; i < all.size(); ++i) {
        if (!all[i].late && Clock::now() > all[i].end) {
          all[i].late = true;
          ::kill(all[i].pid, SIGKILL);
        }
        if ((files[i].revents & (POLLIN | POLLHUP | POLLERR)) != 0 && ended(all[i])) return taken(i);
      }
    }
  }

  std::vector<Child> all;

 private:
  /// Reads what there is; whether there is no more to come.
  static bool ended(Child& child) {
    char text[1 << 14];
    const ssize_t length = ::read(child.in, text, sizeof text);
    if (length > 0) child.said.append(text, static_cast<std::size_t>(length));
    return length == 0 || (length < 0 && errno != EINTR && errno != EAGAIN);
  }

  std::pair<Child, int> taken(std::size_t i) {
    Child child = std::move(all[i]);
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
    ::close(child.in);
    int status = 0;
    ::kill(child.pid, SIGKILL);  // nothing, or one whose pipe was closed by the model
    while (::waitpid(child.pid, &status, 0) < 0 && errno == EINTR) {
    }
    return {std::move(child), status};
  }
};

}  // namespace

std::vector<CheckedMaterial> check_in_processes(const std::vector<CheckTask>& tasks, const CheckProcesses& how) {
  std::vector<CheckedMaterial> results(tasks.size());
  Children running;
  std::size_t next = 0, done = 0;
  while (done < tasks.size()) {
    while (next < tasks.size() && running.all.size() < static_cast<std::size_t>(how.at_once)) {
      running.all.push_back(start(tasks, next, how.limit_s));
      ++next;
    }
    const auto [child, status] = running.next();
    results[child.task] = result_of(child, status, tasks[child.task], how.limit_s);
    ++done;
    if (how.progress) how.progress(done);
  }
  return results;
}

}  // namespace assay::drivers
