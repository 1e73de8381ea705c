// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_process.hpp"

#include <poll.h>

#include <csignal>
#include <map>
#include <memory>

#include "adapters/process/shortage.hpp"
#include "drivers/check/check_material.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

using adapters::Death;

std::string how_it_ended(const CheckChild& child, const CheckTask& task, double limit_s) {
  const std::string when = phase_words(child.phase());
  const auto words = [&]() -> std::string {
    if (child.is_late())
      return "returned from each call, but the tests were not done within " + rounded_text(limit_s, 3) + " s";
    switch (child.end()) {
      case Death::none:
        return "closed the files of the process";
      case Death::time_limit:
        return "did not return from a call within " + rounded_text(task.limits.seconds, 3) + " s";
      case Death::memory:
        return "took more than " + rounded_text(task.limits.gigabytes, 3) + " GB of memory";
      case Death::lost:
        return "ended the process that watches it, too,";
      default:
        return adapters::words_of_end(child.fate());
    }
  }();
  return "the model " + words + when;
}

/// Of what writes where it must not.
bool spoilt_memory(const CheckChild& child) {
  const int signal = child.fate().death_number;
  return child.end() == Death::signal && (signal == SIGSEGV || signal == SIGBUS);
}

/// By its own will, of a step: STOP, exit().
bool gave_up(const CheckChild& child) {
  return child.phase() == CallPhase::updating && (child.end() == Death::exit || child.end() == Death::ended);
}

bool hangs(const CheckChild& child) {
  const Death end = child.end();
  return child.is_late() || end == Death::time_limit || end == Death::memory || end == Death::lost;
}

/// A report that was whole before the model's last instances were destroyed.
CheckedMaterial with_end(CheckedMaterial checked, const CheckChild& child, const CheckTask& task, double limit_s) {
  const check::TestResult end{.id = process_test,
                              .verdict = check::Verdict::fail,
                              .cause = check::causes::ends_process,
                              .sentence = how_it_ended(child, task, limit_s) + ", after the last test"};
  std::erase_if(checked.report.tests, [](const check::TestResult& test) { return test.id == process_test; });
  add_test(checked.report, end);
  checked.hangs = hangs(child);
  return checked;
}

/// The report, or that of a test in which the process ended.
CheckedMaterial result_of(const CheckChild& child, const CheckTask& task, double limit_s) {
  std::string test = "loading";
  CheckedMaterial checked;
  checked.name = task.name;
  std::size_t at = 0, end = 0;
  for (; (end = child.said().find('\0', at)) != std::string::npos; at = end + 1) {
    const std::string record = child.said().substr(at + 1, end - at - 1);
    if (child.said()[at] == '@') test = record;
    if (child.said()[at] == '?') checked.error = record, checked.unsuitable = true;
    const auto told = checked_of_json(record);
    if (child.said()[at] == '!' && told) checked = *told;
    if (child.said()[at] == '=' && told) checked.report.tests.push_back(told->report.tests.front());
  }
  if (checked.unsuitable) return checked;
  const auto whole = checked_of_json(child.said().substr(at));
  if (whole && child.phase() == CallPhase::destroying) return with_end(*whole, child, task, limit_s);
  if (whole && (child.end() == Death::lost || !hangs(child))) return *whole;
  if (child.is_late()) {
    checked.unsuitable = true;
    checked.error = task.name + ": " + how_it_ended(child, task, limit_s) + ", in the test " + test +
                    ": it is too slow to be judged. Files, commands or output in each call may take the time";
    return checked;
  }
  const std::string printed = child.fate().output.text(), last = adapters::last_line(printed);
  const std::string missing = adapters::missing_file_words(printed);
  std::string sentence =
      how_it_ended(child, task, limit_s) + " in the test " + test + (last.empty() ? "" : "; its last output: " + last) +
      (missing.empty() && gave_up(child) && !task.strain_is_asked && last.find("runtime error") == last.npos
           ? "; a smaller --strain may avoid this"
           : missing);
  if (last.starts_with(no_memory_words)) sentence = last + ", in the test " + test;
  const char* cause =
      test == "calls.arrays" && spoilt_memory(child) ? check::causes::overrun : check::causes::ends_process;
  checked.hangs = hangs(child);
  add_test(checked.report, {.id = test, .verdict = check::Verdict::fail, .cause = cause, .sentence = sentence});
  return checked;
}

/// By the model itself, or by somebody from outside, as the system where memory is short.
bool was_killed(const CheckChild& child) { return child.end() != Death::none && child.fate().was_killed(); }

/// Not the model's fault: it is told before it is judged.
void refuse_shortage(const CheckChild& child) {
  if (child.end() == Death::shortage) throw SystemError(adapters::words_of_end(child.fate()));
  const int signal = child.fate().death_number;
  const std::string limit = adapters::processor_limit();
  if (child.end() == Death::signal && !limit.empty() && (signal == SIGXCPU || signal == SIGKILL))
    throw SystemError("the process of a check was ended by signal " + std::to_string(signal) + ": " + limit);
}

/// How many tests have begun in a child, and the id of the last.
std::pair<std::size_t, std::string> begun_in(const CheckChild& child) {
  std::pair<std::size_t, std::string> begun{0, ""};
  for (std::size_t at = 0, end = 0; (end = child.said().find('\0', at)) != std::string::npos; at = end + 1) {
    if (child.said()[at] != '@') continue;
    ++begun.first;
    begun.second = child.said().substr(at + 1, end - at - 1);
  }
  return begun;
}

using Children = std::vector<std::unique_ptr<CheckChild>>;

/// Waits until one of those that run has ended, and takes it out.
std::unique_ptr<CheckChild> next_ended(Children& running, const CheckProcesses& how) {
  for (;;) {
    stop_if_interrupted();
    std::vector<pollfd> files;
    for (const auto& child : running) files.push_back({child->records(), POLLIN, 0});
    ::poll(files.data(), files.size(), 20);
    for (auto at = running.begin(); at != running.end(); ++at) {
      if ((*at)->look()) {
        std::unique_ptr<CheckChild> child = std::move(*at);
        running.erase(at);
        child->await_end();
        return child;
      }
      if (!how.at_work) continue;
      const auto [count, test] = begun_in(**at);
      how.at_work(count, test);
    }
  }
}

}  // namespace

std::vector<CheckedMaterial> check_in_processes(const std::vector<CheckTask>& tasks, const CheckProcesses& how) {
  std::vector<CheckedMaterial> results(tasks.size());
  Children running;                           // what is left of them is ended
  std::map<std::size_t, std::string> killed;  ///< of tasks whose process was killed: the test that it was at
  std::size_t next = 0, done = 0;
  while (done < tasks.size()) {
    while (next < tasks.size() && running.size() < static_cast<std::size_t>(how.at_once)) {
      running.push_back(std::make_unique<CheckChild>(tasks, next++, how.limit_s));
    }
    const std::unique_ptr<CheckChild> child = next_ended(running, how);
    refuse_shortage(*child);
    CheckedMaterial& checked = results[child->task()] = result_of(*child, tasks[child->task()], how.limit_s);
    const std::string test = was_killed(*child) ? checked.report.tests.back().id : "";
    if (const auto before = killed.find(child->task()); before != killed.end()) {
      if (before->second != test)  // a model kills itself again and again
        throw SystemError(
            "the process of a check was killed (signal 9) from outside, as the system does if memory is short");
    } else if (!test.empty()) {
      killed[child->task()] = test;
      running.push_back(std::make_unique<CheckChild>(tasks, child->task(), how.limit_s));
      continue;
    }
    checked.printed = child->fate().output.text();
    checked.printed_bytes = child->fate().output.printed.load();
    ++done;
    if (how.progress) how.progress(done);
  }
  return results;
}

}  // namespace assay::drivers
