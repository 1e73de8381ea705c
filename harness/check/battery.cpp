// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/battery.hpp"

#include <algorithm>
#include <functional>

#include "harness/check/arrays.hpp"
#include "harness/check/calls.hpp"
#include "harness/check/constant_rotation.hpp"
#include "harness/check/continuity.hpp"
#include "harness/check/derivatives.hpp"
#include "harness/check/diagnosis.hpp"
#include "harness/check/dissipation.hpp"
#include "harness/check/elasticity.hpp"
#include "harness/check/extensions.hpp"
#include "harness/check/initial_stress.hpp"
#include "harness/check/loading.hpp"
#include "harness/check/material_symmetry.hpp"
#include "harness/check/memory.hpp"
#include "harness/check/refusals.hpp"
#include "harness/check/repeated_stretch.hpp"
#include "harness/check/rest.hpp"
#include "harness/check/rotation.hpp"
#include "harness/check/stability.hpp"
#include "harness/check/steps.hpp"
#include "harness/check/threads.hpp"

namespace assay::check {

namespace {

/// One test of the list.
struct Entry {
  const char* id;
  const char* cause_of_failure;  ///< where the material refuses a step; null: that it does
  std::function<TestResult(const Specimen&, Evidence&)> run;
};

template <class Test>
std::function<TestResult(const Specimen&, Evidence&)> plain(Test test) {
  return [test](const Specimen& specimen, Evidence&) { return test(specimen); };
}

/// A test of rotation whose finding the diagnosis looks at.
template <class Test>
std::function<TestResult(const Specimen&, Evidence&)> kept(RotationFinding Evidence::*place, Test test) {
  return [=](const Specimen& specimen, Evidence& evidence) {
    evidence.*place = test(specimen);
    return (evidence.*place).result;
  };
}

TestResult stiffness_class(const Specimen& specimen, Evidence& evidence) {
  evidence.symmetry = class_at_rest(specimen);
  return evidence.symmetry.result;
}

TestResult loading_class(const Specimen& specimen, Evidence& evidence) {
  return class_in_loading(specimen, evidence.symmetry.axes);
}

/// Without these nothing else can be judged.
std::vector<Entry> first_entries() {
  return {{"calls.repeated", nullptr,
           [](const Specimen& specimen, Evidence& evidence) { return repeated_calls(specimen, evidence.first); }},
          {"clock", nullptr, plain(clock_independence)},
          {"continuity", nullptr, plain(continuity)}};
}

std::vector<Entry> entries() {
  const auto turning = [](When when) { return plain([when](const Specimen& s) { return rotation(s, when); }); };
  return {
      {"rest", nullptr, plain(stress_at_rest)},
      {"symmetry", causes::not_indifferent, plain(symmetry)},
      {"zero_increment", nullptr, plain(zero_increment)},
      {"elasticity.components", nullptr, plain(shear_components)},
      {"elasticity.shear", nullptr, plain(shear_modulus)},
      {"elasticity.class", nullptr, stiffness_class},
      {"elasticity.major", nullptr, plain(major_symmetry)},
      {"rotation.constant", causes::not_indifferent, plain(constant_rotation)},
      {"basis", causes::not_indifferent, plain(change_of_basis)},
      {"isotropy", causes::not_isotropic, plain(isotropy)},
      {"symmetry_class", causes::not_of_class, loading_class},
      {"rotation.at_rest", causes::not_indifferent, kept(&Evidence::at_rest, rotation_at_rest)},
      {"rotation.before", causes::not_indifferent, turning(When::before)},
      {"rotation.during", causes::not_indifferent, turning(When::during)},
      {"rotation.after", causes::not_indifferent, turning(When::after)},
      {"rotation.apex", causes::repeated_stretch, plain(rotation_at_apex)},
      {"rotation.fixed_stretch", causes::not_indifferent, kept(&Evidence::fixed, rotation_at_fixed_stretch)},
      {"rotation.revolutions", causes::not_indifferent, plain(revolutions)},
      {"rotation.state", causes::not_indifferent, kept(&Evidence::state, rotation_of_state)},
      {"stretches.nearly_equal", causes::repeated_stretch, plain(nearly_equal_stretches)},
      {"stretches.turning", causes::repeated_stretch, plain(rotation_at_equal_stretches)},
      {"initial_stress", nullptr, plain(initial_stress)},
      {"step_halving", nullptr, plain(step_halving)},
      {"jumps", nullptr, plain(jumps)},
      {"memory", nullptr, plain(memory)},
      {"tangent", nullptr, plain(tangent)},
      {"energy", nullptr, plain(energy)},
      {"rate", nullptr, plain(rate_form)},
      {"wave_speed", nullptr, plain(wave_speed)},
      {"closed_form", nullptr, plain(closed_form)},
      {"dissipation", nullptr, plain(dissipation)},
      {"ellipticity", nullptr, plain(ellipticity)},
      {"calls.increment", nullptr, plain(undeclared_increment)},
      {"calls.refused", nullptr, plain(refusals)},
      {"calls.threads", nullptr, plain(threads)},
      {"calls.senseless", nullptr, plain(senseless_deformation)},
  };
}

/// At all resolutions of the tests.
bool stands_unturned(const Specimen& specimen) {
  try {
    for (const int finer : {0, 1, 2}) {
      march(*specimen.material, out_and_back(specimen),
            {.steps = specimen.steps() << finer, .state = specimen.rest_state()});
    }
    return true;
  } catch (const MaterialFailure&) {
    return false;
  }
}

std::string drifting_of(const Specimen& specimen) {
  try {
    return drifting_variable(specimen);
  } catch (const MaterialFailure&) {
    return {};
  }
}

/// The tests of a list, as far as `report` allows.
void take(const std::vector<Entry>& list, const Specimen& specimen, Evidence& evidence, Report& report) {
  const Options& options = specimen.options;
  for (const Entry& entry : list) {
    if ((!options.only.empty() && options.only != entry.id) || options.without == entry.id) continue;
    if (options.begins) options.begins(entry.id);
    try {
      report.tests.push_back(entry.run(specimen, evidence));
    } catch (const MaterialFailure& failure) {
      const bool twin = entry.cause_of_failure && stands_unturned(specimen);
      report.tests.push_back(refused(entry.id, twin ? entry.cause_of_failure : nullptr, failure));
    }
    if (options.ends) options.ends(report.tests.back());
  }
}

bool any_failed(const Report& report) {
  return std::any_of(report.tests.begin(), report.tests.end(),
                     [](const TestResult& test) { return test.verdict == Verdict::fail; });
}

/// The rest of the battery where the first tests have failed.
void leave(const std::vector<Entry>& list, const std::string& cause, Report& report) {
  for (const Entry& entry : list) {
    report.tests.push_back(
        {.id = entry.id, .verdict = Verdict::not_applicable, .sentence = not_judged + (": " + cause)});
  }
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
  return not_finite ? causes::not_finite : causes::refuses;
}

std::vector<std::string> test_ids() {
  std::vector<std::string> ids{"calls.arrays", "loading"};
  for (const auto& list : {first_entries(), entries()}) {
    for (const Entry& entry : list) ids.emplace_back(entry.id);
  }
  return ids;
}

namespace {

Report run_once(const Material& material, const Options& options) {
  Report report;
  Evidence evidence;
  evidence.has_state_that_turns = has_state_that_turns(material.table());
  evidence.has_spin = evidence.has_state_that_turns && material.has(ASSAY_USES_INCREMENT);
  if (options.begins) options.begins("calls.arrays");
  report.tests.push_back(guarded_arrays(material, options, evidence.first));
  if (options.ends) options.ends(report.tests.back());
  try {
    if (!any_failed(report)) {
      if (options.begins) options.begins("loading");
      const Specimen specimen = examine(material, options);
      report.strain = specimen.amplitude;
      report.pressure = specimen.pressure;
      take(first_entries(), specimen, evidence, report);
      if (specimen.modulus == 0 && !any_failed(report)) report.tests.push_back(without_stress());
      if (specimen.elastic_alone() && !any_failed(report))
        report.tests.push_back(not_finite_beyond(*specimen.not_finite));
      if (!any_failed(report)) {
        evidence.turned = turned_step(specimen);
        evidence.drifting = drifting_of(specimen);
        evidence.pressed_at_rest = pressed_at_rest(specimen);
        evidence.right_without_spin = right_without_spin(specimen);
        take(entries(), specimen, evidence, report);
      }
    }
  } catch (const std::runtime_error& error) {
    report.tests.push_back(not_loaded(material, error));
  }
  report.diagnosis = diagnose(report.tests, evidence);
  if (!options.only.empty()) return report;
  std::vector<Entry> all = first_entries();
  for (Entry& entry : entries()) all.push_back(std::move(entry));
  std::erase_if(all, [&](const Entry& entry) {
    return options.without == entry.id ||
           std::any_of(report.tests.begin(), report.tests.end(), [&](const auto& test) { return test.id == entry.id; });
  });
  if (!all.empty()) leave(all, report.diagnosis.front().cause, report);
  return report;
}

bool any_refused(const Report& report) {
  return std::any_of(report.tests.begin(), report.tests.end(), [](const TestResult& test) { return test.refused; });
}

}  // namespace

Report run_battery(const Material& material, const Options& options) {
  constexpr double smaller = 0.125, least = 1e-4;
  Report first = run_once(material, options);
  first.effort = options.effort;
  Options other = options;
  other.effort.strain = first.strain;
  other.has_refused = true;
  other.elsewhere.clear();  // of the strain that was asked for
  other.others_elsewhere.clear();
  while (any_refused(first) && (other.effort.strain *= smaller) > least) {
    Report again = run_once(material, other);
    again.effort = other.effort;
    if (!any_refused(again)) return again;
  }
  return first;
}

}  // namespace assay::check
