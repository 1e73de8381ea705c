// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/battery.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "harness/check/diagnosis.hpp"
#include "harness/check/work.hpp"
#include "harness/material/stack_below.hpp"
#include "harness/material/thrown.hpp"
#include "harness/numeric/stopwatch.hpp"

namespace assay::check {

namespace {

/// At all resolutions of the tests.
bool stands_unturned(const Specimen& specimen) {
  const auto stands = [&] {
    for (const int finer : {0, 1, 2}) from_rest(specimen, out_and_back(specimen), specimen.steps() << finer);
    return true;
  };
  return if_taken(stands, false);
}

/// What a model gives is looked at where it gives it. A measure that is no number is therefore of the test's own
/// making, and says nothing of the model.
TestResult without_own_nan(TestResult test) {
  if (test.verdict != Verdict::fail || !test.measure || !std::isnan(*test.measure)) return test;
  return left_out("stresses of this size are beyond the arithmetic of the test");
}

/// One test, between what is told of it.
template <class Test>
void take(const char* id, const Options& options, const Test& test, Report& report) {
  if (options.begins) options.begins(id);
  const Stopwatch watch;
  report.tests.push_back(test());
  report.tests.back().id = id;
  report.tests.back().wall_s = watch.seconds();
  if (options.ends) options.ends(report.tests.back());
}

/// The tests of a list, as far as `report` allows.
void take(const std::vector<Entry>& list, const Specimen& specimen, Evidence& evidence, Report& report) {
  const Options& options = specimen.options;
  for (const Entry& entry : list) {
    if ((!options.only.empty() && options.only != entry.id) || options.without == entry.id) continue;
    const auto test = [&] {
      try {
        return without_own_nan(entry.run(specimen, evidence));
      } catch (const MaterialFailure& failure) {
        const bool twin = entry.cause_of_failure && stands_unturned(specimen);
        return refused(entry.id, twin ? entry.cause_of_failure : nullptr, failure);
      }
    };
    take(entry.id, options, test, report);
  }
}

bool any_failed(const Report& report) {
  return std::any_of(report.tests.begin(), report.tests.end(),
                     [](const TestResult& test) { return test.verdict == Verdict::fail; });
}

bool has_state_that_turns(const assay_material& table) {
  const auto turns = [](const assay_state_variable& v) {
    return v.kind != ASSAY_SCALAR && v.role != ASSAY_ROLE_DIRECTION;
  };
  return std::any_of(table.state, table.state + table.state_count, turns);
}

}  // namespace

std::string cause_of_refusal(const std::string& words, bool not_finite) {
  if (words.starts_with(overrun_words)) return causes::overrun;
  if (words.starts_with(arithmetic_prefix)) return causes::disturbs_process;
  if (words.find(exception_words) != std::string::npos) return causes::ends_process;
  if (words.find(absent_words) != std::string::npos) return causes::missing_routine;
  return not_finite ? causes::not_finite : causes::refuses;
}

std::vector<std::string> test_ids() {
  std::vector<std::string> all{ids::arrays, ids::loading};
  for (const auto& list : {first_entries(), entries()}) {
    for (const Entry& entry : list) all.emplace_back(entry.id);
  }
  return all;
}

namespace {

/// Of what was found out before any test.
void add_findings_of_loading(const Specimen& specimen, Report& report) {
  if (auto found = not_reached(specimen)) report.tests.push_back(std::move(*found));
  if (any_failed(report)) return;
  if (specimen.modulus == 0) {
    report.tests.push_back(without_stress(*specimen.material));
  } else if (specimen.elastic_alone()) {
    report.tests.push_back(not_finite_beyond(*specimen.not_finite));
  }
}

/// Whether a test has failed without which nothing else can be judged.
bool is_decided(const Report& report) {
  const std::vector<Entry> first = first_entries();
  return std::any_of(report.tests.begin(), report.tests.end(), [&](const TestResult& test) {
    if (test.verdict != Verdict::fail) return false;
    return std::any_of(first.begin(), first.end(), [&](const Entry& e) { return e.decides && test.id == e.id; });
  });
}

void take_all(const Specimen& specimen, Evidence& evidence, Report& report) {
  report.strain = specimen.amplitude;
  report.pressure = specimen.pressure;
  report.not_tested = not_tested(specimen);
  take(first_entries(), specimen, evidence, report);
  add_findings_of_loading(specimen, report);
  if (specimen.modulus == 0 || is_decided(report)) return;
  evidence.turned = turned_step(specimen);
  evidence.drifting = if_taken([&] { return drifting_variable(specimen); }, {});
  evidence.overshoots = overshoot(specimen);
  evidence.asymmetric_at_rest = asymmetric_at_rest(specimen);
  evidence.pressed_at_rest = pressed_at_rest(specimen);
  evidence.grows_at_rest = grows_at_rest(specimen);
  evidence.growth_declaration = specimen.options.declarations.growth;
  evidence.right_without_spin = right_without_spin(specimen);
  take(entries(), specimen, evidence, report);
}

Report run_once(const Material& material, const Options& options) {
  Report report;
  report.effort = options.effort;
  Evidence evidence;
  evidence.has_state_that_turns = has_state_that_turns(material.table());
  evidence.has_spin = evidence.has_state_that_turns && material.has(ASSAY_USES_INCREMENT);
  take(
      ids::arrays, options, [&] { return guarded_arrays(material, options, evidence.first); }, report);
  try {
    if (!any_failed(report)) {
      if (options.begins) options.begins(ids::loading);
      take_all(examine(material, options), evidence, report);
    }
  } catch (const std::runtime_error& error) {
    report.tests.push_back(not_loaded(material, error));
  }
  report.diagnosis = diagnose(report.tests, evidence);
  if (!options.only.empty()) return report;
  for (const std::string& id : test_ids()) {
    const auto is_it = [&](const TestResult& test) { return test.id == id; };
    const bool taken = std::any_of(report.tests.begin(), report.tests.end(), is_it);
    if (taken || id == ids::arrays || id == ids::loading || id == options.without) continue;
    report.tests.push_back(left_out(not_judged + (": " + report.diagnosis.front().cause)));
    report.tests.back().id = id;
  }
  return report;
}

bool any_refused(const Report& report) {
  return std::any_of(report.tests.begin(), report.tests.end(), [](const TestResult& test) { return test.refused; });
}

/// A length [s] in which the strain of a refused step is taken; nothing where it is taken in none.
std::optional<double> length_taken(const Material& material, const Report& report) {
  constexpr int decades = 12;
  for (const TestResult& test : report.tests) {
    if (!test.refused || !test.step || takes(material, *test.step)) continue;
    FailedStep shorter = *test.step;
    for (int k = 0; k < decades; ++k) {
      shorter.dt *= 0.1;
      if (takes(material, shorter)) return shorter.dt;
    }
  }
  return std::nullopt;
}

/// Refusals of the length of a step are no refusals of its strain.
void name_lengths(double length, Report& report) {
  for (TestResult& test : report.tests) {
    if (!test.refused) continue;
    test.cause = causes::refuses_length;
    test.sentence += "; it takes the same strain in " + rounded(length) + " s";
  }
  for (Diagnosis& d : report.diagnosis) {
    if (d.cause != causes::refuses) continue;
    const auto same = [&](const TestResult& test) { return test.cause == causes::refuses_length; };
    d = {causes::refuses_length, std::find_if(report.tests.begin(), report.tests.end(), same)->sentence};
  }
}

/// Whether what was found may be that of steps which are long beside the times of the material.
bool is_blurred(const Report& report) {
  static const std::set<std::string> blurred{causes::no_stress, causes::drifts, causes::initial_stress,
                                             causes::rate_form};
  return !report.passes() && std::all_of(report.diagnosis.begin(), report.diagnosis.end(),
                                         [](const Diagnosis& each) { return blurred.contains(each.cause); });
}

/// Whether the first cause is the same: then what is found in the usual steps is told.
bool begins_alike(const Report& one, const Report& other) {
  return !one.passes() && one.diagnosis.front().cause == other.diagnosis.front().cause;
}

/// For another strain, or other times, than those for which a process has given histories.
Options without_elsewhere(Options options) {
  options.elsewhere.clear();
  options.others_elsewhere.clear();
  return options;
}

Material at_pace(const Material& material, double pace) {
  return Material(&material.table(), material.named_parameters(), pace * material.pace());
}

/// Again at smaller strains as long as a step is refused.
Report at_smaller_strains(const Material& material, const Options& options) {
  constexpr double smaller = 0.125, least = 1e-4;
  Report first = run_once(material, options);
  Options other = without_elsewhere(options);
  other.effort.strain = first.strain;
  other.has_refused = true;
  while (any_refused(first) && (other.effort.strain *= smaller) > least) {
    Report again = run_once(material, other);
    if (any_refused(again)) continue;
    again.not_tested.push_back("strains above " + rounded(again.strain));
    return again;
  }
  return first;
}

}  // namespace

Report run_battery(const Material& material, const Options& asked) {
  const OverStack zeros(0);
  const bool usual = asked.effort.step == 1;
  const std::optional<Material> paced = usual ? std::nullopt : std::optional(at_pace(material, asked.effort.step));
  const Material& own = usual ? material : *paced;
  const Options options = usual ? asked : without_elsewhere(asked);
  Report first = run_once(own, options);
  if (const auto pace = usual ? own_pace(material, first) : std::nullopt) {
    Options resolved = without_elsewhere(options);
    resolved.effort.step = *pace;
    Report again = run_once(at_pace(material, *pace), resolved);
    if (!any_refused(again) && (again.passes() ? is_blurred(first) : !begins_alike(first, again))) return again;
  }
  if (!any_refused(first)) return first;
  const std::optional<double> length = length_taken(own, first);
  if (!length) return at_smaller_strains(own, options);
  Options other = without_elsewhere(options);
  other.effort.step *= *length;
  Report again = run_once(at_pace(material, other.effort.step), other);
  if (any_refused(again)) return at_smaller_strains(own, options);  // it was not the length, or not that alone
  if (usual) return again;
  name_lengths(other.effort.step, first);
  return first;
}

}  // namespace assay::check
