// SPDX-License-Identifier: BSD-3-Clause
// The battery, and around it what a foreign interface leaves open.
#include "drivers/check/check_foreign.hpp"
#include "drivers/check/check_material.hpp"
#include "harness/numeric/stopwatch.hpp"

namespace assay::drivers {

namespace {

/// What a test beside the battery finds, told as the battery tells its own.
std::optional<ForeignFinding> told(const char* id, const CheckReporter& reporter, const auto& test) {
  if (reporter.begins) reporter.begins(id);
  const Stopwatch watch;
  std::optional<ForeignFinding> found = test();
  if (!found) return found;
  found->test.wall_s = watch.seconds();
  if (reporter.ends) reporter.ends(found->test);
  return found;
}

/// Whether the rest can be judged: what lies beyond the arrays spoils every other test.
bool judge_beyond(const ResolvedMaterial& material, const CheckSettings& settings, const CheckReporter& reporter,
                  check::Report& report) {
  const bool asked = (settings.only.empty() || settings.only == beyond_test) && settings.without != beyond_test;
  if (!asked) return true;
  const auto found = told(beyond_test, reporter, [&] { return goes_beyond(material, settings.effort); });
  if (!found) return true;
  report.effort = settings.effort;
  report.tests.push_back(found->test);
  report.diagnosis = found->causes;
  if (found->causes.empty()) return settings.only != beyond_test;
  for (const std::string& id : check::test_ids()) {
    if (id != "loading" && settings.only.empty())
      report.tests.push_back(not_applicable(id, check::not_judged + (": " + found->test.cause)));
  }
  return false;
}

/// The same with another CMNAME. A host has one name for each set of PROPS, and a model may keep what belongs to it.
std::optional<Material> under_another_name(const ResolvedMaterial& material) {
  if (!is_of(material, adapters::ForeignInterface::umat) && !is_of(material, adapters::ForeignInterface::vumat))
    return std::nullopt;
  adapters::ForeignModel other = *material.foreign;
  other.material_name += "-2";
  return made_for_tests(other, material.choice.parameters);
}

/// The battery again where an instance of other parameters is in the way of this one, and would not be in a host.
check::Report with_named_others(const ResolvedMaterial& material, const check::Options& options, check::Report first) {
  const std::optional<Material> other =
      failed_test(first, check::ids::repeated) ? under_another_name(material) : std::nullopt;
  if (!other) return first;
  check::Options named = options;
  named.table_of_others = &other->table();
  check::Report again = check::run_battery(material.material, named);
  if (failed_test(again, check::ids::repeated)) return first;
  if (check::TestResult* const test = test_of(again, check::ids::repeated))
    remark(*test, "what it keeps outside the state goes by CMNAME, and a host gives each set of PROPS another");
  return again;
}

/// Behind what `before` holds.
check::Report battery_of(const ResolvedMaterial& material, const CheckSettings& settings, const CheckReporter& reporter,
                         const check::Report& before) {
  const std::string only = settings.only == process_test ? std::string() : settings.only;
  const bool repeats = only.empty() || only == check::ids::repeated;
  const check::History elsewhere =
      repeats && reporter.first_calls ? history_elsewhere(material.material, settings.effort) : check::History();
  const check::History others = repeats ? history_of_others(material, settings.effort) : check::History();
  const check::Options options{.effort = settings.effort,
                               .only = only,
                               .without = settings.without,
                               .well_aligned = settings.well_aligned,
                               .declarations = declarations_of(material),
                               .elsewhere = elsewhere,
                               .others_elsewhere = others,
                               .begins = reporter.begins,
                               .ends = reporter.ends};
  check::Report report = with_named_others(material, options, check::run_battery(material.material, options));
  report.tests.insert(report.tests.begin(), before.tests.begin(), before.tests.end());
  return report;
}

/// What the model takes from its host, of one that can be loaded.
void judge_host(const ResolvedMaterial& material, const CheckSettings& settings, const CheckReporter& reporter,
                CheckedMaterial& checked) {
  const check::Report& report = checked.report;
  const bool asked = settings.only.empty() || settings.only == host_test;
  const bool keeps_state = diagnosed(report, {check::causes::hidden_state, check::causes::kept_by_element});
  if (!asked || keeps_state || report.strain == 0) return;
  const auto found =
      told(host_test, reporter, [&] { return depends_on_host(material, report.strain, report.pressure); });
  if (!found) return;
  add_test(checked.report, found->test);
  checked.depends_on.insert(checked.depends_on.end(), found->depends_on.begin(), found->depends_on.end());
}

/// The battery again, of the model as one that depends on the rate, where its description says nothing of it and the
/// length of a step matters.
std::optional<ResolvedMaterial> settle_rate(const ResolvedMaterial& material, const CheckSettings& settings,
                                            const CheckReporter& reporter, const check::Report& before,
                                            CheckedMaterial& checked) {
  if (!settings.rate_dependent && !may_depend_on_rate(material, checked.report)) return std::nullopt;
  ResolvedMaterial other = as_rate_dependent(material);
  check::Report report = battery_of(other, settings, reporter, before);
  if (!settings.rate_dependent && !settles_rate(report, checked.report)) return std::nullopt;
  const check::TestResult* const clock = failed_test(checked.report, check::ids::clock);
  const double effect = clock ? clock->measure.value_or(0) : 0;
  checked.report = std::move(report);
  checked.depends_on.push_back(say_rate(checked.report, effect));
  return other;
}

/// What is asked of a foreign model behind the battery, one after the other.
constexpr auto rules = {judge_foreign_tangent, judge_energies, tell_initial_values, judge_state_blocks,
                        hint_symmetry,         hint_axes,      judge_elements};

}  // namespace

std::optional<ResolvedMaterial> judge(const ResolvedMaterial& material, const CheckSettings& settings,
                                      const CheckReporter& reporter, CheckedMaterial& checked) {
  keep_elements(material.material);
  if (!judge_beyond(material, settings, reporter, checked.report)) return std::nullopt;
  const check::Report before = checked.report;
  checked.report = battery_of(material, settings, reporter, before);
  std::optional<ResolvedMaterial> other = settle_rate(material, settings, reporter, before, checked);
  const ResolvedMaterial& judged = other ? *other : material;
  for (std::string& what : foreign_not_tested(judged)) checked.report.not_tested.push_back(std::move(what));
  for (const auto& rule : rules) rule(judged, checked.report);
  judge_host(judged, settings, reporter, checked);
  return other;
}

}  // namespace assay::drivers
