// SPDX-License-Identifier: BSD-3-Clause
// `assay check`: the battery of model tests, for people, for scripts and for CI.
#include "drivers/check/check.hpp"

#include <algorithm>
#include <thread>

#include "adapters/process/shortage.hpp"
#include "adapters/worker/remote_table.hpp"
#include "drivers/check/check_foreign.hpp"
#include "drivers/check/check_material.hpp"
#include "drivers/material/registry.hpp"
#include "drivers/output/junit.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/own_files.hpp"
#include "drivers/system/progress.hpp"
#include "drivers/system/terminal.hpp"
#include "harness/numeric/stopwatch.hpp"

namespace assay::drivers {

namespace {

CheckSettings settings_of(const CheckOptions& options) {
  CheckSettings settings{
      {.quick = options.quick, .pressure = options.pressure}, {}, options.out, absolute_path(options.out)};
  if (options.strain) settings.effort.strain = *options.strain, settings.effort.strain_is_asked = true;
  if (options.step) settings.effort.step = *options.step;
  return settings;
}

CheckProcesses processes_for(const CheckOptions& options) {
  constexpr double quick_limit = 120, full_limit = 900;  // [s]
  return {.at_once = static_cast<int>(std::max(1u, std::thread::hardware_concurrency())),
          .limit_s = options.quick ? quick_limit : full_limit};
}

/// The same material checked with other settings.
using Again = std::function<CheckedMaterial(const CheckSettings&)>;

/// In workers the end of a foreign model's process is a refusal, and so it is of an F that is no number: the rest is
/// judged without that test.
void take_end_for_refusal(CheckedMaterial& checked, CheckSettings settings, const Again& again) {
  using check::ids::senseless;
  const std::vector<check::Diagnosis>& found = checked.report.diagnosis;
  const bool ended = !checked.description.empty() && found.size() == 1 &&
                     found.front().cause == check::causes::ends_process && checked.report.tests.back().id == senseless;
  if (!ended) return;
  const std::string sentence = found.front().sentence;
  settings.without = senseless;
  checked = again(settings);
  checked.report.tests.push_back(
      not_applicable(senseless, sentence + ", of an F that is no number: a refusal, in a worker"));
}

/// A model that dies in the first test by reading or writing an address, and does not where its arrays begin at
/// multiples of 64 bytes, asks for an alignment that nobody promises.
void tell_alignment(CheckedMaterial& checked, CheckSettings settings, const Again& again) {
  constexpr auto first = check::ids::arrays;
  check::Report& report = checked.report;
  const bool asked = report.diagnosis.size() == 1 && report.diagnosis.front().cause == check::causes::overrun &&
                     report.tests.back().id == first && !report.tests.back().measure;
  if (!asked) return;
  settings.only = first;
  settings.well_aligned = true;
  settings.folder.clear();
  const check::Report aligned = again(settings).report;
  const check::TestResult* const stands = test_of(aligned, first);
  if (!stands || stands->verdict != check::Verdict::pass) return;
  check::TestResult& test = report.tests.back();
  test.cause = check::causes::of_alignment;
  test.sentence +=
      "; where its arrays begin at multiples of 64 bytes it does not: multiples of 8 are all that is promised";
  report.diagnosis.front() = {test.cause, test.sentence};
}

/// What is to be done with the k-th of them.
using TaskOf = std::function<CheckTask(std::size_t k, const CheckSettings&)>;

/// So many materials, and then what the process of a check cannot find out about itself.
std::vector<CheckedMaterial> check_each(const CheckOptions& options, std::size_t count, const TaskOf& task_of) {
  watch_interrupts();
  const CheckSettings settings = settings_of(options);
  const CheckProcesses quiet = processes_for(options);
  std::vector<CheckTask> tasks;
  for (std::size_t k = 0; k < count; ++k) tasks.push_back(task_of(k, settings));
  Progress progress("check", options.verbosity == Verbosity::quiet);
  const auto tell = [&progress](std::size_t done, std::size_t all, const std::string& what) {
    progress.update(std::min(1.0, static_cast<double>(done) / static_cast<double>(all)), what);
  };
  CheckProcesses how = quiet;
  if (options.all) {
    how.progress = [&](std::size_t done) {
      tell(done, count, std::to_string(done) + " of " + std::to_string(count) + " materials");
    };
  } else {
    how.at_work = [&](std::size_t begun, const std::string& test) {
      tell(begun, check::test_ids().size() + 2, test);  // and the process, and the vortex
    };
  }
  std::vector<CheckedMaterial> all = check_in_processes(tasks, how);
  progress.finish();
  for (std::size_t k = 0; k < count; ++k) {
    const Again again = [&](const CheckSettings& other) {
      return check_in_processes({task_of(k, other)}, quiet).front();
    };
    take_end_for_refusal(all[k], settings, again);
    tell_alignment(all[k], settings, again);
    judge_components(all[k], settings.effort, quiet);
    judge_printing(all[k]);
    leave_replay_of_the_end(all[k], settings);
  }
  return all;
}

/// Throws InputError where a file of them would replace one that was read.
void refuse_inputs_as_outputs(const CheckOptions& options) {
  refuse_input_as_output(options.json, "--json");
  refuse_input_as_output(options.junit, "--junit");
  refuse_input_as_output(options.markdown, "--markdown");
}

CheckedMaterial check_one(const CheckOptions& options) {
  note_input(options.material);
  refuse_inputs_as_outputs(options);  // before a source is compiled and its description written
  const ResolvedMaterial resolved = material_to_check(options);
  refuse_inputs_as_outputs(options);
  const auto task_of = [&](std::size_t, const CheckSettings& how) {
    return CheckTask{options.material,
                     [&options, &resolved, how](const CheckReporter& reporter) {
                       return check_material(in_this_process(resolved), options.material, how, reporter);
                     },
                     adapters::start_of(&resolved.material.table()).limits, how.effort.strain_is_asked};
  };
  CheckedMaterial checked = check_each(options, 1, task_of).front();
  checked.warnings = resolved.warnings;  // also where its process has ended
  return checked;
}

std::vector<CheckedMaterial> check_all(const CheckOptions& options) {
  const std::map<std::string, double> given = parameters_in(options.parameters);
  const std::vector<RegisteredName> names = registered_names();
  return check_each(options, names.size(), [&](std::size_t k, const CheckSettings& how) {
    const RegisteredName& registered = names[k];
    return CheckTask{registered.name, [&given, registered, how](const CheckReporter& reporter) {
                       const std::string& file = registered.file.empty() ? registered.name : registered.file;
                       return check_material(registered_material(file, given), registered.name, how, reporter);
                     }};
  });
}

/// No verdict is given where the system may be to blame.
void require_room(const std::vector<CheckedMaterial>& all) {
  const std::string tight = adapters::tight_limits();
  const auto failed = std::ranges::find_if(all, [](const CheckedMaterial& each) { return !each.passes(); });
  if (tight.empty() || failed == all.end() || failed->unsuitable) return;
  throw SystemError(failed->name + ": the check fails, and " + tight + ": that may be why");
}

/// The exit status.
int reported(const CheckOptions& options, const std::vector<CheckedMaterial>& all, const std::string& json,
             const std::string& text) {
  require_room(all);
  tell_check(options, text, json, check_junit(all, options.junit_name));
  int status = 0;
  for (const CheckedMaterial& checked : all) {
    if (!checked.unwritten.empty()) throw SystemError(checked.unwritten);
    const int own = checked.passes() ? 0 : checked.error.empty() ? 1 : 2;
    if (status != 1 && own != 0) status = own;
  }
  return status;
}

void refuse_what_contradicts(const CheckOptions& options) {
  const auto refuse = [](const char* option, const std::string& file, const char* others) {
    throw InputError({}, option, std::string("is the same file as ") + others + ": '" + one_line(file, 60) + "'");
  };
  if (!options.json.empty() && options.json == options.junit) refuse("--junit", options.json, "--json");
  if (!options.markdown.empty() && (options.markdown == options.json || options.markdown == options.junit))
    refuse("--markdown", options.markdown, "--json or --junit");
}

/// A name that no material has is a slip.
void refuse_unknown_parameters(const CheckOptions& options, const std::vector<CheckedMaterial>& all) {
  for (const auto& [name, value] : parameters_in(options.parameters)) {
    const auto has = [&parameter = name](const CheckedMaterial& checked) {
      return !checked.error.empty() ||
             std::ranges::any_of(checked.parameters, [&](const auto& own) { return own.first == parameter; });
    };
    if (std::ranges::none_of(all, has))
      throw InputError({}, "--parameters", "no material has a parameter '" + one_line(name, 60) + "'");
  }
}

}  // namespace

void tell_check(const CheckOptions& options, const std::string& text, const std::string& json, const std::string& junit,
                const std::string& markdown) {
  refuse_inputs_as_outputs(options);
  tell(text, {{options.json, json, true}, {options.junit, junit}, {options.markdown, markdown}});
}

int check(const CheckOptions& options) {
  constexpr std::size_t most_files_at_once = 32;  // measured: with 24 all that is looked for is found
  require_open_files(most_files_at_once);
  forget_inputs();
  refuse_what_contradicts(options);
  require_junit_folder(options.junit, options.out);
  if (options.material.empty() || options.methods) refuse_source_options(options.source, "");
  if (options.methods) return check_methods(options);
  if (!options.replay.empty()) return check_replay(options);
  if (options.all) {
    const Stopwatch watch;
    const std::vector<CheckedMaterial> all = check_all(options);
    const double wall_s = watch.seconds();
    refuse_unknown_parameters(options, all);
    return reported(options, all, check_json(all), check_text(all, wall_s));
  }
  CheckedMaterial checked;
  try {
    checked = check_one(options);
  } catch (const ModelEnded& ended) {  // before any test
    checked.name = options.material;
    add_test(checked.report, {.id = "loading",
                              .verdict = check::Verdict::fail,
                              .cause = check::causes::ends_process,
                              .sentence = ended.sentence});
  }
  if (checked.unsuitable) throw InputError(checked.error);
  if (!checked.error.empty()) {
    require_room({checked});
    throw SystemError(checked.error);
  }
  return reported(options, {checked}, check_json(checked),
                  check_text(checked, options.verbosity, prints_to_terminal() ? Rows::telling : Rows::all));
}

}  // namespace assay::drivers
