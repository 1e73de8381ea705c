// SPDX-License-Identifier: BSD-3-Clause
// The process in which one material is checked.
#include "drivers/check/check_process.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <new>
#include <system_error>

#include "adapters/process/fate.hpp"
#include "adapters/process/shortage.hpp"
#include "drivers/system/exit_guard.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/own_files.hpp"
#include "drivers/system/supervisor.hpp"
#include "harness/material/own_process.hpp"

namespace assay::drivers {

namespace {

void write_record(int records, const std::string& text) {
  if (!adapters::write_all(records, text)) adapters::end_by_word("closed the files of the process");
}

/// Before any foreign code.
void settle(adapters::Fate& fate) {
  call_mark = &fate.busy_since;
  phase_mark = &fate.phase;
  adapters::mark_crashes(fate);
  ::setenv("TMPDIR", fate.folder, 1);  // for what the vortex writes
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) std::signal(signal, SIG_DFL);
  own_this_process();
  adapters::enlarge_stack(std::size_t{1} << 26);  // as in a worker, where a foreign model runs
  remember_files();
}

CheckReporter reporter_to(int records) {
  const std::string end(1, '\0');
  return {[=](const CheckedMaterial& material) { write_record(records, "!" + check_json(material) + end); },
          [=](const std::string& id) { write_record(records, "@" + id + end); },
          [=](const check::TestResult& result) {
            CheckedMaterial one;
            one.report.tests.push_back(result);
            write_record(records, "=" + check_json(one) + end);
          },
          habits_of_process,
          true,
          keep_instances};
}

/// Records, each ended by a NUL: '!' and the material, '@' and the id of a test that begins, '=' and what it has found,
/// '?' and why it cannot be checked; the report at last. What the model does when it is destroyed comes behind that.
[[noreturn]] void serve(const CheckTask& task, int records) {
  CheckedMaterial checked;
  try {
    checked = task.run(reporter_to(records));
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
      write_record(records, std::string("?") + error.what() + std::string(1, '\0'));
      leave_process(0);
    }
    checked = {};
    checked.name = task.name;
    checked.error = error.what() + lowered;
  }
  write_record(records, check_json(checked));
  std::fflush(nullptr);
  release_instances();
  leave_process(0);
}

}  // namespace

CheckChild::CheckChild(const std::vector<CheckTask>& tasks, std::size_t task, double limit_s) try
    : task_(task), end_(Clock::now() + std::chrono::milliseconds(std::llround(1e3 * limit_s))) {
  require_temporary_folder();
  const auto work = [&](adapters::Fate& fate) {
    settle(fate);
    serve(tasks[task], records_.out());
  };
  process_.emplace(
      adapters::Kept{
          .work = work, .folders = "assay-check-", .defers_signals = true, .files_of_process = {records_.out()}},
      tasks[task].limits);
  records_.close_out();
  ::fcntl(records_.in(), F_SETFL, O_NONBLOCK);
} catch (const std::system_error& error) {
  throw SystemError(error.what());
}

bool CheckChild::read_records() {
  for (char text[1 << 14];;) {
    const ssize_t length = ::read(records_.in(), text, sizeof text);
    if (length > 0) {
      said_.append(text, static_cast<std::size_t>(length));
    } else if (length == 0) {
      return true;
    } else if (errno != EINTR) {
      return false;
    }
  }
}

bool CheckChild::look() {
  over_ = process_->is_over();  // before its last words are read
  if (!over_ && !late_ && Clock::now() > end_) {
    late_ = true;
    process_->end();
  }
  return read_records() || over_;
}

void CheckChild::await_end() {
  constexpr int patience_ms = 500;
  for (int waited = 0; !over_ && waited < patience_ms; ++waited, over_ = process_->is_over()) ::usleep(1000);
}

}  // namespace assay::drivers
