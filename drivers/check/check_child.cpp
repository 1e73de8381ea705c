// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_child.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>

#include "adapters/worker/crash_marks.hpp"
#include "adapters/worker/high_files.hpp"
#include "adapters/worker/own_folder.hpp"
#include "adapters/worker/process_watch.hpp"
#include "adapters/worker/shortage.hpp"
#include "drivers/system/exit_guard.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/own_files.hpp"
#include "drivers/system/supervisor.hpp"
#include "harness/material/own_process.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::drivers {

namespace {

void write_all(int file, const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t written = ::write(file, text.data() + at, text.size() - at);
    if (written < 0 && errno != EINTR) adapters::end_by_word("closed the files of the process");
    if (written > 0) at += static_cast<std::size_t>(written);
  }
}

/// The child's ends of the pipes.
struct Ends {
  int records, output;
};

/// The same file where a model does not find it.
int out_of_reach(int file) {
  const int copy = adapters::high_copy(file);
  if (copy < 0) return file;
  ::close(file);
  return copy;
}

/// Before any foreign code.
void settle(const std::string& folder, const Ends& ends) {
  if (!adapters::stand_in(folder)) leave_process(3);
  ::setenv("TMPDIR", folder.c_str(), 1);  // for what the vortex writes
  ::setpgid(0, 0);                        // what the model starts can be ended with it
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) std::signal(signal, SIG_DFL);
  ::dup2(ends.output, STDOUT_FILENO);
  ::dup2(ends.output, STDERR_FILENO);
  ::close(ends.output);
  own_this_process();
  adapters::enlarge_stack(std::size_t{1} << 26);  // as in a worker, where a foreign model runs
  remember_files();
}

CheckReporter reporter_to(int records) {
  const std::string end(1, '\0');
  return {[=](const CheckedMaterial& material) { write_all(records, "!" + check_json(material) + end); },
          [=](const std::string& id) { write_all(records, "@" + id + end); },
          [=](const check::TestResult& result) {
            CheckedMaterial one;
            one.report.tests.push_back(result);
            write_all(records, "=" + check_json(one) + end);
          },
          habits_of_process,
          true,
          keep_instances};
}

/// Records, each ended by a NUL: '!' and the material, '@' and the id of a test that begins, '=' and what it has found,
/// '?' and why it cannot be checked; the report at last. What the model does when it is destroyed comes behind that.
[[noreturn]] void serve(const CheckTask& task, const Ends& ends, const std::string& folder) {
  settle(folder, ends);
  CheckedMaterial checked;
  try {
    checked = task.run(reporter_to(ends.records));
  } catch (const std::bad_alloc&) {  // which the model has taken, or forbidden
    std::fputs(no_memory_words, stderr);
    try {
      std::fputs(lowered_limits_words().c_str(), stderr);
    } catch (const std::bad_alloc&) {  // nor for that
    }
    std::fputs("\n", stderr);
    leave_process(3);
  } catch (const std::exception& error) {
    const std::string lowered = lowered_limits_words();  // by the model, after which nothing can be read
    if (lowered.empty() && dynamic_cast<const InputError*>(&error)) {
      write_all(ends.records, std::string("?") + error.what() + std::string(1, '\0'));
      leave_process(0);
    }
    checked = {};
    checked.name = task.name;
    checked.error = error.what() + lowered;
  }
  write_all(ends.records, check_json(checked));
  std::fflush(nullptr);
  release_instances();
  leave_process(0);
}

}  // namespace

Child start_child(const std::vector<CheckTask>& tasks, std::size_t task, double limit_s) {
  require_temporary_folder();
  int records[2], output[2];
  if (::pipe2(records, O_CLOEXEC) != 0 || ::pipe2(output, O_CLOEXEC) != 0) throw_system_error("pipe");
  Child child;
  child.task = task;
  child.in = records[0];
  child.heard = output[0];
  child.end = Child::Clock::now() + std::chrono::milliseconds(std::llround(1e3 * limit_s));
  child.limits = tasks[task].limits;
  child.output = std::make_unique<adapters::KeptOutput>();
  void* page = ::mmap(nullptr, sizeof(adapters::Control), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (page == MAP_FAILED) throw_system_error("mmap");
  child.control = static_cast<adapters::Control*>(page);
  std::fflush(nullptr);  // or the child would write it a second time
  const auto work = [&](const std::string& folder) {
    call_mark = &child.control->busy_since;
    phase_mark = &child.control->phase;
    adapters::mark_crashes(*child.control);
    serve(tasks[task], {out_of_reach(records[1]), output[1]}, folder);
  };
  child.keeper = start_kept(work, {records[1], output[1]}, {records[0], output[0]}, adapters::temporary_folder());
  ::close(records[1]);
  ::close(output[1]);
  for (const int file : {child.in, child.heard}) ::fcntl(file, F_SETFL, O_NONBLOCK);
  child.begin_bytes = adapters::data_bytes(child.keeper.process);
  return child;
}

Child::Excess excess_of(const Child& child) {
  const std::int64_t since = child.control->busy_since.load();
  if (since != 0 && 1e-9 * static_cast<double>(now_ns() - since) > child.limits.seconds) {
    return Child::Excess::call;
  }
  if (Child::Clock::now() > child.end) return Child::Excess::time;
  const auto allowed = static_cast<std::uint64_t>(1e9 * child.limits.gigabytes);
  return adapters::data_bytes(child.keeper.process) > child.begin_bytes + allowed ? Child::Excess::memory
                                                                                  : Child::Excess::none;
}

bool read_records(Child& child) {
  for (char text[1 << 14];;) {
    const ssize_t length = ::read(child.in, text, sizeof text);
    if (length > 0) {
      child.said.append(text, static_cast<std::size_t>(length));
    } else if (length == 0) {
      return true;
    } else if (errno != EINTR) {
      return false;
    }
  }
}

void read_output(Child& child) {
  char text[1 << 14];
  for (ssize_t length = 0; (length = ::read(child.heard, text, sizeof text)) > 0;) {
    child.output->add(text, static_cast<std::size_t>(length));
  }
}

bool is_over(Child& child) {
  child.over = child.over || kept_is_over(child.keeper, child.status, child.lost);
  return child.over;
}

void end_process(const Child& child) {
  ::kill(-child.keeper.process, SIGKILL);
  if (!child.over) ::kill(child.keeper.process, SIGKILL);
}

void release(Child& child) {
  constexpr int patience_ms = 500;
  ::close(child.in);
  for (int waited = 0; !is_over(child) && waited < patience_ms; ++waited) ::usleep(1000);  // it is about to end
  end_process(child);
  dismiss(child.keeper);
  read_output(child);
  ::close(child.heard);
  child.phase = static_cast<CallPhase>(child.control->phase.load());
  child.claim = static_cast<adapters::Death>(child.control->claim.load());
  child.words.assign(child.control->death_words, strnlen(child.control->death_words, adapters::words_size));
  ::munmap(child.control, sizeof *child.control);
  std::error_code ignored;
  if (const std::string& folder = child.keeper.folder; !folder.empty()) std::filesystem::remove_all(folder, ignored);
}

}  // namespace assay::drivers
