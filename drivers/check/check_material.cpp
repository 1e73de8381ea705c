// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_material.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <chrono>
#include <filesystem>

#include "adapters/foreign/written_inputs.hpp"
#include "adapters/process/printed.hpp"
#include "adapters/process/process_watch.hpp"
#include "drivers/check/check_beyond.hpp"
#include "drivers/check/check_foreign.hpp"
#include "drivers/check/check_host.hpp"
#include "drivers/check/check_judgement.hpp"
#include "drivers/check/check_vortex.hpp"
#include "drivers/check/replay.hpp"
#include "drivers/material/model_files.hpp"
#include "drivers/scene/material_path.hpp"
#include "drivers/system/own_files.hpp"
#include "drivers/system/whole_file.hpp"
#include "harness/numeric/stopwatch.hpp"

namespace assay::drivers {

namespace {

namespace fs = std::filesystem;

/// The name that was asked for, or the model's own where that is a path; what no file name should hold becomes '_'.
std::string stem_of(const CheckedMaterial& checked) {
  std::string stem = is_material_name(checked.name) ? checked.name : checked.model;
  for (char& c : stem) {
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-') c = '_';
  }
  return stem;
}

/// "clay.rotation.during.yaml"
std::string replay_name(const CheckedMaterial& checked, const std::string& test) {
  return stem_of(checked) + "." + test + ".yaml";
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

/// Those of earlier failures that are none any more.
void remove_stale(const CheckedMaterial& checked, const CheckSettings& settings) {
  std::vector<std::string> ids = check::test_ids();
  for (const char* own : {process_test, vortex_test, beyond_test, host_test}) ids.emplace_back(own);
  for (const std::string& id : ids) {
    std::error_code ignored;
    if (checked.replays.count(id) == 0) fs::remove(fs::path(settings.place) / replay_name(checked, id), ignored);
  }
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
  remove_stale(checked, settings);
}

/// Of a model that passes the battery: the run tells nothing else of one that does not.
void add_vortex(const ResolvedMaterial& material, check::Report& report, const CheckReporter& reporter) {
  reporter.begins(vortex_test);
  const auto found = std::find_if(report.tests.begin(), report.tests.end(),
                                  [](const check::TestResult& test) { return test.id == "ellipticity"; });
  const Stopwatch watch;
  report.tests.push_back(end_to_end_vortex(material, found == report.tests.end() ? std::nullopt : found->measure));
  check::TestResult& test = report.tests.back();
  test.wall_s = watch.seconds();
  if (test.verdict == check::Verdict::fail) report.diagnosis.push_back({test.cause, test.sentence});
}

/// After all else that the model has done.
void add_process(adapters::Habits habits, check::Report& report) {
  const bool told = std::any_of(report.diagnosis.begin(), report.diagnosis.end(), [](const check::Diagnosis& each) {
    return each.cause == check::causes::disturbs_process;  // of a step: by its arithmetic
  });
  if (told) habits &= ~(adapters::rounding_left | adapters::traps_left);
  const adapters::Habits harmful = habits & ~adapters::any_written_input;  // inputs were put right
  check::TestResult test{.id = process_test, .measure = std::popcount(harmful), .threshold = 0};
  test.sentence = "the model leaves the process that runs it as it was";
  const std::string words = "the model " + adapters::habit_words(habits);
  if (harmful == adapters::no_habit && habits != harmful)
    test.sentence += std::string("; ") + check::remark_words + words;
  if (harmful != adapters::no_habit) {
    test.verdict = check::Verdict::fail;
    test.cause = check::causes::disturbs_process;
    test.sentence = words;
    report.diagnosis.push_back({test.cause, test.sentence});
  }
  report.tests.push_back(test);
}

}  // namespace

ResolvedMaterial in_this_process(const ResolvedMaterial& apart) {
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
  const auto start = std::chrono::steady_clock::now();
  CheckedMaterial checked;
  checked.name = name;
  checked.library = material.library;
  checked.description = material.description;
  checked.model = material.material.name();
  for (std::uint32_t i = 0; i < material.material.table().parameter_count; ++i) {
    checked.parameters.emplace_back(material.material.table().parameters[i].name, material.material.parameters()[i]);
  }
  checked.of_example = material.of_example;
  reporter.material(checked);
  const std::optional<ResolvedMaterial> other = judge(material, settings, reporter, checked);
  const ResolvedMaterial& judged = other ? *other : material;
  const std::string only = settings.only == process_test ? std::string() : settings.only;
  const bool asked = settings.only.empty() ? !settings.effort.quick : settings.only == vortex_test;
  if (asked && checked.report.passes()) {
    add_vortex(judged, checked.report, reporter);
  } else if (asked) {
    checked.report.tests.push_back({.id = vortex_test,
                                    .verdict = check::Verdict::not_applicable,
                                    .sentence = check::not_judged + (": " + checked.report.diagnosis.front().cause)});
  }
  if (only.empty() && reporter.habits) add_process(reporter.habits(), checked.report);
  checked.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (reporter.over) reporter.over();
  if (!settings.folder.empty()) leave_replays(judged, other.has_value(), checked, settings);
  return checked;
}

void judge_printing(CheckedMaterial& checked) {
  constexpr std::uint64_t much = 1 << 16;  // bytes: complaints of the battery's senseless steps stay far below
  const auto test = std::find_if(checked.report.tests.begin(), checked.report.tests.end(),
                                 [](const check::TestResult& each) { return each.id == process_test; });
  if (test == checked.report.tests.end() || checked.printed_bytes == 0 || !is_native(checked)) return;
  const std::string words = "the model prints: " + std::to_string(checked.printed_bytes) + " bytes, the last line \"" +
                            adapters::last_line(checked.printed) + "\"";
  if (checked.printed_bytes <= much) {
    test->sentence += std::string("; ") + check::remark_words + words;
    return;
  }
  test->sentence = test->verdict == check::Verdict::fail ? test->sentence + "; " + words : words;
  test->verdict = check::Verdict::fail;
  test->cause = check::causes::disturbs_process;
  std::erase_if(checked.report.diagnosis, [&](const check::Diagnosis& d) { return d.cause == test->cause; });
  checked.report.diagnosis.push_back({test->cause, test->sentence});
}

void leave_replay_of_the_end(CheckedMaterial& checked, const CheckSettings& settings) {
  if (settings.folder.empty() || checked.model.empty() || checked.passes() || !checked.replays.empty()) return;
  const auto test = std::find_if(checked.report.tests.begin(), checked.report.tests.end(), [](const auto& each) {
    return each.verdict == check::Verdict::fail &&
           (each.cause == check::causes::ends_process || each.cause == check::causes::overrun ||
            each.cause == check::causes::of_alignment || each.cause == check::causes::disturbs_process);
  });
  if (test == checked.report.tests.end() || !checked.unwritten.empty()) return;
  Replay replay;
  replay.material = !checked.description.empty() ? checked.description
                    : checked.library.empty()    ? checked.model
                                                 : checked.library + ":" + checked.model;
  for (const auto& [parameter, value] : checked.parameters) replay.parameters[parameter] = value;
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
