// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_material.hpp"

#include <bit>
#include <cctype>
#include <filesystem>

#include "adapters/foreign/written_inputs.hpp"
#include "adapters/process/fate.hpp"
#include "adapters/process/process_watch.hpp"
#include "drivers/check/check_foreign.hpp"
#include "drivers/check/replay.hpp"
#include "drivers/material/material_description.hpp"
#include "drivers/scene/material_path.hpp"
#include "drivers/system/own_files.hpp"
#include "drivers/system/whole_file.hpp"
#include "harness/check/judge.hpp"
#include "harness/material/stack_below.hpp"
#include "harness/numeric/stopwatch.hpp"

namespace assay::drivers {

namespace {

namespace fs = std::filesystem;

/// "clay.rotation.during.yaml", by the name that was asked for, or the model's own where that is a path; what no file
/// name should hold becomes '_'.
std::string replay_name(const CheckedMaterial& checked, const std::string& test) {
  std::string stem = is_material_name(checked.name) ? checked.name : checked.model;
  for (char& c : stem) {
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-') c = '_';
  }
  return stem + "." + test + ".yaml";
}

/// Wherever this process stands.
void write_replay(const Replay& replay, Isolation isolation, const CheckSettings& settings, CheckedMaterial& checked) {
  const fs::path place = settings.place, file = place / replay_name(checked, replay.test);
  const fs::path told = fs::path(settings.folder) / file.filename();
  put_files_right();
  std::error_code error;
  fs::create_directories(place, error);
  if (error) fail(settings.folder, "cannot be made", error);
  try {
    write_file(file, replay_yaml(replay, isolation));
  } catch (const SystemError& failure) {
    rethrow_with(failure, file, told);
  }
  checked.replays[replay.test] = told.string();
}

void leave_replays(const ResolvedMaterial& material, bool rate_dependent, CheckedMaterial& checked,
                   const CheckSettings& settings) {
  try {
    for (const check::TestResult& test : checked.report.tests) {
      if (test.verdict != check::Verdict::fail) continue;
      Replay replay = replay_of(material, test.step, test.cause + ": " + test.sentence);
      replay.test = test.id;
      replay.effort = checked.report.effort;
      replay.rate_dependent = rate_dependent;
      write_replay(replay, Isolation::none, settings, checked);
    }
  } catch (const SystemError& error) {  // the verdict is not lost for that
    // where a model has limited this process, who watches it writes
    if (!(habits_of_process() & adapters::limits_changed)) checked.unwritten = error.what();
  }
  for (const std::string& id : tests_of_check()) {  // of earlier failures that are none any more
    std::error_code ignored;
    if (checked.replays.count(id) == 0) fs::remove(fs::path(settings.place) / replay_name(checked, id), ignored);
  }
}

/// Of a model that passes the battery: the run tells nothing else of one that does not.
check::TestResult vortex_of(const ResolvedMaterial& material, const check::Report& report,
                            const CheckReporter& reporter) {
  if (!report.passes()) return not_applicable(vortex_test, check::not_judged + (": " + report.diagnosis.front().cause));
  reporter.begins(vortex_test);
  const check::TestResult* const ellipticity = test_of(report, "ellipticity");
  const Stopwatch watch;
  check::TestResult test = end_to_end_vortex(material, ellipticity ? ellipticity->measure : std::nullopt);
  test.wall_s = watch.seconds();
  return test;
}

/// After all else that the model has done.
check::TestResult process_of(adapters::Habits habits, const check::Report& report) {
  if (diagnosed(report, {check::causes::disturbs_process}))  // of a step: by its arithmetic
    habits &= ~(adapters::rounding_left | adapters::traps_left);
  const adapters::Habits harmful = habits & ~adapters::any_written_input;  // inputs were put right
  const std::string words = "the model " + adapters::habit_words(habits);
  check::TestResult test =
      check::judged(std::popcount(harmful), 0, "the model leaves the process that runs it as it was",
                    check::causes::disturbs_process, words);
  test.id = process_test;
  if (harmful == adapters::no_habit && habits != harmful) remark(test, words);
  return test;
}

}  // namespace

std::vector<std::string> tests_of_check() {
  std::vector<std::string> ids = check::test_ids();
  ids.insert(ids.end(), {process_test, vortex_test, beyond_test, host_test});
  return ids;
}

ResolvedMaterial in_this_process(const ResolvedMaterial& apart) {
  const OverStack zeros(0);
  MaterialChoice choice = apart.choice;
  if (!apart.library.empty()) choice.adapter = apart.library + ":" + apart.material.name();
  if (!apart.description.empty()) choice.adapter = apart.description;
  choice.isolation = Isolation::none;
  place_model_files(apart.files);
  ResolvedMaterial here = resolve_material(choice);
  here.of_example = apart.of_example;
  return here;
}

CheckedMaterial check_material(const ResolvedMaterial& material, const std::string& name, const CheckSettings& settings,
                               const CheckReporter& reporter) {
  const OverStack zeros(0);  // a check begins from the same stack wherever it runs
  const Stopwatch watch;
  CheckedMaterial checked;
  checked.name = name;
  checked.library = material.library;
  checked.description = material.description;
  checked.model = material.material.name();
  for (std::uint32_t i = 0; i < material.material.table().parameter_count; ++i)
    checked.parameters.emplace_back(material.material.table().parameters[i].name, material.material.parameters()[i]);
  checked.of_example = material.of_example;
  checked.warnings = material.warnings;
  reporter.material(checked);
  const std::optional<ResolvedMaterial> other = judge(material, settings, reporter, checked);
  const ResolvedMaterial& judged = other ? *other : material;
  check::Report& report = checked.report;
  const bool runs = settings.only.empty() ? !settings.effort.quick : settings.only == vortex_test;
  if (runs) add_test(report, vortex_of(judged, report, reporter));
  if ((settings.only.empty() || settings.only == process_test) && reporter.habits)
    add_test(report, process_of(reporter.habits(), report));
  checked.wall_s = watch.seconds();
  if (reporter.over) reporter.over();
  if (!settings.folder.empty()) leave_replays(judged, other.has_value(), checked, settings);
  return checked;
}

void judge_printing(CheckedMaterial& checked) {
  constexpr std::uint64_t much = 1 << 16;  // bytes: complaints of the battery's senseless steps stay far below
  check::TestResult* const test = test_of(checked.report, process_test);
  if (!test || checked.printed_bytes == 0 || !is_native(checked)) return;
  const std::string words = "the model prints: " + std::to_string(checked.printed_bytes) + " bytes, the last line \"" +
                            adapters::last_line(checked.printed) + "\"";
  if (checked.printed_bytes <= much) return remark(*test, words);
  const char* const cause = check::causes::disturbs_process;
  std::erase_if(checked.report.diagnosis, [&](const check::Diagnosis& d) { return d.cause == cause; });
  const bool also = test->verdict == check::Verdict::fail;
  fail_test(checked.report, *test, cause, also ? test->sentence + "; " + words : words);
}

void leave_replay_of_the_end(CheckedMaterial& checked, const CheckSettings& settings) {
  if (settings.folder.empty() || checked.model.empty() || checked.passes() || !checked.replays.empty()) return;
  using namespace check::causes;
  const auto test = std::ranges::find_if(checked.report.tests, [](const check::TestResult& each) {
    return each.verdict == check::Verdict::fail &&
           std::ranges::count(std::initializer_list<const char*>{ends_process, overrun, of_alignment, disturbs_process},
                              each.cause) > 0;
  });
  if (test == checked.report.tests.end() || !checked.unwritten.empty()) return;
  Replay replay;
  replay.material = !checked.description.empty() ? checked.description
                    : checked.library.empty()    ? checked.model
                                                 : checked.library + ":" + checked.model;
  replay.parameters.insert(checked.parameters.begin(), checked.parameters.end());
  if (!checked.library.empty()) replay.library_sha256 = hash_of_library(checked.library);
  replay.test = test->id;
  replay.effort = settings.effort;
  replay.reason = test->cause + ": " + test->sentence;
  try {
    write_replay(replay, Isolation::worker, settings, checked);
  } catch (const SystemError& error) {
    checked.unwritten = error.what();
  }
}

}  // namespace assay::drivers
