// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "adapters/foreign/progress_mark.hpp"
#include "adapters/worker/worker_limits.hpp"
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

/// Records, each ended by a NUL: '!' and the material, '@' and the id of a test that begins, '=' and what it has found;
/// the report at last.
[[noreturn]] void serve(const CheckTask& task, int out, const std::string& folder) {
  const int before = ::open(".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (!folder.empty() && ::chdir(folder.c_str()) != 0) leave_process(3);
  ::setpgid(0, 0);  // what the model starts can be ended with it
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) ::dup2(nowhere, STDOUT_FILENO);
  try {
    const std::string end(1, '\0');
    const CheckedMaterial checked =
        task.run({[&](const CheckedMaterial& material) { write_all(out, "!" + check_json(material) + end); },
                  [&](const std::string& id) { write_all(out, "@" + id + end); },
                  [&](const check::TestResult& result) {
                    CheckedMaterial one;
                    one.report.tests.push_back(result);
                    write_all(out, "=" + check_json(one) + end);
                  },
                  [before] { [[maybe_unused]] const int ignored = ::fchdir(before); }});
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
  bool late = false, over = false;
  int status = 0;
  bool stuck = false;                         ///< a single call of a foreign model took too long
  std::atomic<std::int64_t>* call = nullptr;  ///< shared: when the call began that runs, 0: none
  std::string folder = {};                    ///< where it stands: what a model writes there is not the user's
};

/// Of a call of a foreign model [s].
constexpr double call_limit = adapters::WorkerLimits{}.seconds;

std::atomic<std::int64_t>* new_mark() {
  void* page =
      ::mmap(nullptr, sizeof(std::atomic<std::int64_t>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  return page == MAP_FAILED ? nullptr : new (page) std::atomic<std::int64_t>(0);
}

void free_mark(std::atomic<std::int64_t>* mark) {
  if (mark) ::munmap(mark, sizeof *mark);
}

bool takes_too_long(const Child& child) {
  const std::int64_t since = child.call ? child.call->load() : 0;
  return since != 0 && 1e-9 * static_cast<double>(adapters::now_ns() - since) > call_limit;
}

std::string new_folder() {
  std::string name = (std::filesystem::temp_directory_path() / "assay-check-XXXXXX").string();
  return ::mkdtemp(name.data()) ? name : std::string();
}

void remove_folder(const std::string& folder) {
  std::error_code ignored;
  if (!folder.empty()) std::filesystem::remove_all(folder, ignored);
}

/// With all that it has started, and whatever it was in.
void end_process(const Child& child) {
  ::kill(-child.pid, SIGKILL);
  ::kill(child.pid, SIGKILL);
}

Child start(const std::vector<CheckTask>& tasks, std::size_t task, double limit_s) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw SystemError(std::string("pipe: ") + std::strerror(errno));
  const std::string folder = new_folder();
  std::atomic<std::int64_t>* const mark = new_mark();
  Child child{task, ::fork(), ends[0], Clock::now() + std::chrono::milliseconds(std::llround(1e3 * limit_s)), {}};
  child.folder = folder;
  child.call = mark;
  if (child.pid < 0) throw SystemError(std::string("fork: ") + std::strerror(errno));
  if (child.pid == 0) {
    ::close(ends[0]);
    adapters::call_mark = mark;
    serve(tasks[task], ends[1], folder);
  }
  ::close(ends[1]);
  ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  return child;
}

std::string how_it_ended(const Child& child, double limit_s) {
  if (child.stuck) return "did not come back from one call within " + rounded_text(call_limit, 3) + " s";
  if (child.late) return "did not come back within " + rounded_text(limit_s, 3) + " s";
  if (!child.over) return "closed the files of the process";
  if (WIFSIGNALED(child.status)) {
    return "died of signal " + std::to_string(WTERMSIG(child.status)) + " (" + strsignal(WTERMSIG(child.status)) + ")";
  }
  return "ended the process with status " + std::to_string(WEXITSTATUS(child.status));
}

/// Of what writes where it must not.
bool spoilt_memory(const Child& child) {
  if (!child.over || child.late || !WIFSIGNALED(child.status)) return false;
  const int signal = WTERMSIG(child.status);
  return signal == SIGSEGV || signal == SIGBUS;
}

CheckedMaterial result_of(const Child& child, const CheckTask& task, double limit_s) {
  std::string test = "loading";
  CheckedMaterial checked;
  checked.name = task.name;
  std::size_t at = 0, end = 0;
  for (; (end = child.said.find('\0', at)) != std::string::npos; at = end + 1) {
    const std::string record = child.said.substr(at + 1, end - at - 1);
    if (child.said[at] == '@') test = record;
    const auto told = checked_of_json(record);
    if (child.said[at] == '!' && told) checked = *told;
    if (child.said[at] == '=' && told) checked.report.tests.push_back(told->report.tests.front());
  }
  if (const auto whole = checked_of_json(child.said.substr(at))) return *whole;
  const std::string sentence = "the model " + how_it_ended(child, limit_s) + " in the test " + test;
  const char* cause =
      test == "calls.arrays" && spoilt_memory(child) ? check::causes::overrun : check::causes::ends_process;
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
      end_process(child);
      if (!child.over) ::waitpid(child.pid, nullptr, 0);
      ::close(child.in);
      remove_folder(child.folder);
      free_mark(child.call);
    }
  }

  /// Waits until one has ended, and takes it out.
  Child next() {
    for (;;) {
      stop_if_interrupted();
      std::vector<pollfd> files;
      for (const Child& child : all) files.push_back({child.in, POLLIN, 0});
      ::poll(files.data(), files.size(), 20);
      for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].stuck = all[i].stuck || takes_too_long(all[i]);
        if (!all[i].late && (all[i].stuck || Clock::now() > all[i].end)) {
          all[i].late = true;
          end_process(all[i]);
        }
        if (ended(all[i])) return taken(i);
      }
    }
  }

  std::vector<Child> all;

 private:
  /// Reads what there is. Ended: the process has, whoever else may hold its pipe; or the pipe is closed, and nothing
  /// can come any more.
  static bool ended(Child& child) {
    child.over = child.over || ::waitpid(child.pid, &child.status, WNOHANG) == child.pid;
    for (;;) {
      char text[1 << 14];
      const ssize_t length = ::read(child.in, text, sizeof text);
      if (length > 0) {
        child.said.append(text, static_cast<std::size_t>(length));
      } else if (length == 0) {
        return true;
      } else if (errno != EINTR) {
        return child.over;
      }
    }
  }

  Child taken(std::size_t i) {
    Child child = std::move(all[i]);
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
    ::close(child.in);
    wait_a_little(child);
    end_process(child);
    if (!child.over) ::waitpid(child.pid, nullptr, 0);
    remove_folder(child.folder);
    free_mark(child.call);
    return child;
  }

  /// A process whose pipe is closed has ended, or is about to.
  static void wait_a_little(Child& child) {
    constexpr auto patience = std::chrono::milliseconds(500);
    for (const auto end = Clock::now() + patience; !child.over && Clock::now() < end; ::usleep(1000)) {
      child.over = ::waitpid(child.pid, &child.status, WNOHANG) == child.pid;
    }
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
    const Child child = running.next();
    results[child.task] = result_of(child, tasks[child.task], how.limit_s);
    ++done;
    if (how.progress) how.progress(done);
  }
  return results;
}

}  // namespace assay::drivers
