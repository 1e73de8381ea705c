// SPDX-License-Identifier: BSD-3-Clause
// `assay check --replay`: a failure taken again.
#include "adapters/worker/remote_table.hpp"
#include "drivers/check/check.hpp"
#include "drivers/check/check_foreign.hpp"
#include "drivers/check/check_material.hpp"
#include "drivers/check/replay.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/wrapped_text.hpp"
#include "harness/material/stack_below.hpp"

namespace assay::drivers {

namespace {

/// The step alone: "step". `is_all`: nothing else of the failure is repeated.
check::TestResult step_again(const Material& material, const FailedStep& step, bool is_all) {
  const OverStack zeros(0);  // as where it failed
  check::TestResult result{.id = "step", .verdict = check::Verdict::fail, .step = step};
  UpdateReport report;
  const Answer answer = answer_of(material, step, &report);
  if (!is_good(answer)) {
    const bool died = report.dt_factor == 0;
    result.cause = check::cause_of_refusal(report.message, report.not_finite);
    if (died && result.cause == check::causes::refuses) result.cause = check::causes::ends_process;
    result.sentence = "the step fails again: " + report.message;
    return result;
  }
  result.verdict = check::Verdict::pass;
  result.sentence = "the step is taken; stress 11, 22, 33, 12, 13, 23 [Pa]:";
  for (const std::size_t c : {0, 4, 8, 1, 2, 5}) result.sentence += " " + rounded_text(answer[stress_of_answer + c], 6);
  if (is_all) result.sentence += ". The failure needs earlier calls, which this replay does not make";
  return result;
}

CheckedMaterial again(const Replay& replay, const ResolvedMaterial& resolved, bool has_changed,
                      const CheckReporter& reporter) {
  CheckedMaterial checked;
  if (!replay.test.empty()) {
    checked = check_material(resolved, replay.material,
                             {.effort = replay.effort, .only = replay.test, .rate_dependent = replay.rate_dependent},
                             reporter);
    std::erase_if(checked.report.tests,
                  [&](const auto& test) { return test.id != replay.test && test.verdict != check::Verdict::fail; });
  } else {
    checked.name = replay.material;
    checked.library = resolved.library;
  }
  if (!replay.step) return checked;
  reporter.begins("step");
  add_test(checked.report, step_again(resolved.material, *replay.step, !has_changed && replay.test.empty()));
  std::rotate(checked.report.tests.begin(), checked.report.tests.end() - 1, checked.report.tests.end());
  return checked;
}

}  // namespace

int check_replay(const CheckOptions& options) {
  const Replay replay =
      read_replay(options.replay, Isolation::worker, options.material);  // nobody's code runs in this process
  const ResolvedMaterial resolved = resolved_of(replay, Isolation::worker);
  const bool known = !replay.library_sha256.empty();
  const bool has_changed = known && replay_of(resolved, {}, "").library_sha256 != replay.library_sha256;
  if (has_changed && options.verbosity != Verbosity::quiet)
    warn((resolved.source.empty() ? resolved.library : resolved.source) + " has changed since the failure");
  watch_interrupts();
  const CheckTask task{
      replay.material,
      [&](const CheckReporter& reporter) { return again(replay, in_this_process(resolved), has_changed, reporter); },
      adapters::start_of(&resolved.material.table()).limits};
  CheckedMaterial checked = check_in_processes({task}, {}).front();
  judge_printing(checked);
  const std::string text =
      wrapped(replay.reason, "the failure was: ", "    ") + "\n" + check_text(checked, Verbosity::verbose);
  tell_check(options, text, check_json(checked), check_junit({checked}, options.junit_name));
  if (checked.unsuitable) throw InputError(checked.error);
  if (!checked.error.empty()) throw SystemError(checked.error);
  return checked.passes() ? 0 : 1;
}

}  // namespace assay::drivers
