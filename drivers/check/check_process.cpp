// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_process.hpp"

#include <poll.h>
#include <sys/wait.h>

#include <csignal>
#include <cstring>
#include <map>

#include "adapters/worker/missing_file.hpp"
#include "adapters/worker/shortage.hpp"
#include "drivers/check/check_child.hpp"
#include "drivers/check/check_material.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/text/number_format.hpp"

namespace assay::drivers {

namespace {

std::string how_it_ended_alone(const Child& child, double limit_s) {
  switch (child.excess) {
    case Child::Excess::call:
      return "did not return from a call within " + rounded_text(child.limits.seconds, 3) + " s";
    case Child::Excess::time:
      return "returned from each call, but the tests were not done within " + rounded_text(limit_s, 3) + " s";
    case Child::Excess::memory:
      return "took more than " + rounded_text(child.limits.gigabytes, 3) + " GB of memory";
    case Child::Excess::none:
      break;
  }
  if (child.lost) return "ended the process that watches it, too,";
  if (!child.over) return "closed the files of the process";
  if (child.claim == adapters::Death::ended) return child.words;
  if (WIFSIGNALED(child.status)) {
    return "was ended by signal " + std::to_string(WTERMSIG(child.status)) +
           (child.claim == adapters::Death::stack       ? ": the stack overflowed"
            : child.claim == adapters::Death::null      ? ": it used a null pointer"
            : child.claim == adapters::Death::unaligned ? ": it used an address that is not aligned"
                                                        : std::string(" (") + strsignal(WTERMSIG(child.status)) + ")");
  }
  return "ended the process with status " + std::to_string(WEXITSTATUS(child.status));
}

std::string how_it_ended(const Child& child, double limit_s) {
  return "the model " + how_it_ended_alone(child, limit_s) + phase_words(child.phase);
}

/// Of what writes where it must not.
bool spoilt_memory(const Child& child) {
  if (!child.over || child.lost || child.excess != Child::Excess::none || !WIFSIGNALED(child.status)) return false;
  if (child.claim != adapters::Death::none) return false;
  const int signal = WTERMSIG(child.status);
  return signal == SIGSEGV || signal == SIGBUS;
}

/// By its own will, of a step: STOP, exit().
bool gave_up(const Child& child) {
  return child.phase == CallPhase::updating && child.over && !child.lost && child.excess == Child::Excess::none &&
         WIFEXITED(child.status);
}

/// A report that was whole before the model's last instances were destroyed.
CheckedMaterial with_end(CheckedMaterial checked, const Child& child, double limit_s) {
  const check::TestResult end{.id = process_test,
                              .verdict = check::Verdict::fail,
                              .cause = check::causes::ends_process,
                              .sentence = how_it_ended(child, limit_s) + ", after the last test"};
  std::erase_if(checked.report.tests, [](const check::TestResult& test) { return test.id == process_test; });
  checked.report.tests.push_back(end);
  checked.report.diagnosis.push_back({end.cause, end.sentence});
  checked.hangs = child.excess != Child::Excess::none || child.lost;
  return checked;
}

/// The report, or that of a test in which the process ended.
CheckedMaterial result_of(const Child& child, const CheckTask& task, double limit_s) {
  std::string test = "loading";
  CheckedMaterial checked;
  checked.name = task.name;
  std::size_t at = 0, end = 0;
  for (; (end = child.said.find('\0', at)) != std::string::npos; at = end + 1) {
    const std::string record = child.said.substr(at + 1, end - at - 1);
    if (child.said[at] == '@') test = record;
    if (child.said[at] == '?') checked.error = record, checked.unsuitable = true;
    const auto told = checked_of_json(record);
    if (child.said[at] == '!' && told) checked = *told;
    if (child.said[at] == '=' && told) checked.report.tests.push_back(told->report.tests.front());
  }
  if (checked.unsuitable) return checked;
  const auto whole = checked_of_json(child.said.substr(at));
  if (whole && child.phase == CallPhase::destroying) return with_end(*whole, child, limit_s);
  if (whole && child.excess == Child::Excess::none) return *whole;
  if (child.excess == Child::Excess::time) {
    checked.unsuitable = true;
    checked.error = task.name + ": " + how_it_ended(child, limit_s) + ", in the test " + test +
                    ": it is too slow to be judged. Files, commands or output in each call may take the time";
    return checked;
  }
  const std::string last = adapters::last_line(child.output->text());
  const std::string missing = adapters::missing_file_words(child.output->text());
  std::string sentence =
      how_it_ended(child, limit_s) + " in the test " + test + (last.empty() ? "" : "; its last output: " + last) +
      (missing.empty() && gave_up(child) && !task.strain_is_asked && last.find("runtime error") == last.npos
           ? "; a smaller --strain may avoid this"
           : missing);
  if (last.starts_with(no_memory_words)) sentence = last + ", in the test " + test;
  const char* cause =
      test == "calls.arrays" && spoilt_memory(child) ? check::causes::overrun : check::causes::ends_process;
  checked.hangs = child.excess != Child::Excess::none || child.lost;
  checked.report.tests.push_back({.id = test, .verdict = check::Verdict::fail, .cause = cause, .sentence = sentence});
  checked.report.diagnosis.push_back({cause, sentence});
  return checked;
}

/// By the model itself, or by somebody from outside, as the system where memory is short.
bool was_killed(const Child& child) {
  if (!child.over || child.excess != Child::Excess::none) return false;
  return child.lost || (WIFSIGNALED(child.status) && WTERMSIG(child.status) == SIGKILL);
}

/// Not the model's fault: it is told before it is judged.
void refuse_lack_of_processor_time(const Child& child) {
  if (!child.over || child.excess != Child::Excess::none || !WIFSIGNALED(child.status)) return;
  const int signal = WTERMSIG(child.status);
  const std::string limit = adapters::processor_limit();
  if (!limit.empty() && (signal == SIGXCPU || signal == SIGKILL))
    throw SystemError("the process of a check was ended by signal " + std::to_string(signal) + ": " + limit);
}

/// How many tests have begun in a child, and the id of the last.
std::pair<std::size_t, std::string> begun_in(const Child& child) {
  std::pair<std::size_t, std::string> begun{0, ""};
  for (std::size_t at = 0, end = 0; (end = child.said.find('\0', at)) != std::string::npos; at = end + 1) {
    if (child.said[at] != '@') continue;
    ++begun.first;
    begun.second = child.said.substr(at + 1, end - at - 1);
  }
  return begun;
}

/// The children that run; what is left of them is killed.
class Children {
 public:
  explicit Children(const CheckProcesses& how) : how_(&how) {}
  Children(const Children&) = delete;
  Children& operator=(const Children&) = delete;
  ~Children() {
    for (const Child& child : all) end_process(child);
    for (Child& child : all) release(child);
  }

  /// Waits until one has ended, and takes it out.
  Child next() {
    for (;;) {
      stop_if_interrupted();
      std::vector<pollfd> files;
      for (const Child& child : all) {
        files.push_back({child.in, POLLIN, 0});
        files.push_back({child.heard, POLLIN, 0});
      }
      ::poll(files.data(), files.size(), 20);
      for (std::size_t i = 0; i < all.size(); ++i) {
        read_output(all[i]);
        if (all[i].excess == Child::Excess::none && (all[i].excess = excess_of(all[i])) != Child::Excess::none) {
          end_process(all[i]);
        }
        if (ended(all[i])) return taken(i);
        if (!how_->at_work) continue;
        const auto [count, test] = begun_in(all[i]);
        how_->at_work(count, test);
      }
    }
  }

  std::vector<Child> all;

 private:
  /// The process has, whoever else may hold its pipe; or the pipe is closed, and nothing can come any more.
  static bool ended(Child& child) {
    const bool over = is_over(child);  // before its last words are read
    return read_records(child) || over;
  }

  Child taken(std::size_t i) {
    Child child = std::move(all[i]);
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
    release(child);
    return child;
  }

  const CheckProcesses* how_;
};

}  // namespace

std::vector<CheckedMaterial> check_in_processes(const std::vector<CheckTask>& tasks, const CheckProcesses& how) {
  std::vector<CheckedMaterial> results(tasks.size());
  Children running(how);
  std::map<std::size_t, std::string> killed;  ///< of tasks whose process was killed: the test that it was at
  std::size_t next = 0, done = 0;
  while (done < tasks.size()) {
    while (next < tasks.size() && running.all.size() < static_cast<std::size_t>(how.at_once)) {
      running.all.push_back(start_child(tasks, next, how.limit_s));
      ++next;
    }
    const Child child = running.next();
    refuse_lack_of_processor_time(child);
    CheckedMaterial& checked = results[child.task] = result_of(child, tasks[child.task], how.limit_s);
    const std::string test = was_killed(child) ? checked.report.tests.back().id : "";
    if (const auto before = killed.find(child.task); before != killed.end()) {
      if (before->second != test)  // a model kills itself again and again
        throw SystemError(
            "the process of a check was killed (signal 9) from outside, as the system does if memory is short");
    } else if (!test.empty()) {
      killed[child.task] = test;
      running.all.push_back(start_child(tasks, child.task, how.limit_s));
      continue;
    }
    checked.printed = child.output->text();
    checked.printed_bytes = child.output->printed.load();
    ++done;
    if (how.progress) how.progress(done);
  }
  return results;
}

}  // namespace assay::drivers
