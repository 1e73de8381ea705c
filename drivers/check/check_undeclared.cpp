// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_undeclared.hpp"

#include <algorithm>
#include <utility>

#include "adapters/foreign/foreign_table.hpp"
#include "drivers/check/check_foreign.hpp"
#include "drivers/check/check_steps.hpp"
#include "harness/check/judge.hpp"

namespace assay::drivers {

namespace {

constexpr const char* clock_test = "clock";

ResolvedMaterial taken_for(const ResolvedMaterial& material, adapters::ForeignModel model) {
  Material made = made_for_tests(model, material.choice.parameters);
  return {.material = std::move(made),
          .choice = material.choice,
          .library = material.library,
          .description = material.description,
          .of_example = material.of_example,
          .warnings = material.warnings,
          .files = material.files,
          .foreign = std::move(model)};
}

bool passes_as(const ResolvedMaterial& other, const check::Effort& effort) {
  check::Effort quick = effort;
  quick.quick = true;
  return check::run_battery(other.material, {.effort = quick, .declarations = declarations_of(other)}).passes();
}

/// Whether steps of a loaded body are others that begin at another time of its life.
bool reads_time(const ResolvedMaterial& material, double strain, double pressure) {
  constexpr int count = 12;
  constexpr double times[] = {0, 1e-7, 1e3};  // [s]
  const std::size_t at = place_in_state(material.material.table(), "TIME");
  if (at == material.material.state_size()) return true;  // nobody knows
  for (const RepeatedStep& step : repeated_steps(material.material, strain, pressure, count)) {
    if (step.first) continue;
    const Answer usual = answer_of(material.material, step);
    for (const double time : times) {
      RepeatedStep other = step;
      other.state0[at] = time;
      const Answer found = answer_of(material.material, other);
      if (!std::equal(usual.begin(), usual.begin() + state_of_answer, found.begin())) return true;
    }
  }
  return false;
}

}  // namespace

bool may_depend_on_rate(const ResolvedMaterial& material, check::Report& report) {
  const auto& model = material.foreign;
  const check::TestResult* const clock = failed_test(report, clock_test);
  const std::string flag = declarations_of(material).rate_dependence;  // named where the length of a step is to blame
  if (!model || model->flags_are_said || !clock) return false;
  return clock->sentence.find(flag) != std::string::npos || !reads_time(material, report.strain, report.pressure);
}

ResolvedMaterial as_rate_dependent(const ResolvedMaterial& material) {
  adapters::ForeignModel model = material.foreign.value();
  model.flags |= ASSAY_RATE_DEPENDENT;
  return taken_for(material, std::move(model));
}

bool settles_rate(const check::Report& with_flag, const check::Report& without) {
  const auto is_of_clock = [](const check::Diagnosis& each) { return each.cause == check::causes::clock; };
  const std::vector<check::Diagnosis>& found = with_flag.diagnosis;
  if (std::any_of(found.begin(), found.end(), is_of_clock)) return false;
  const bool overshoots = !found.empty() && found.front().cause == check::causes::dissipation;
  return overshoots || count_of(with_flag, check::Verdict::fail) < count_of(without, check::Verdict::fail);
}

Dependence say_rate(check::Report& report, double effect) {
  for (check::TestResult& test : report.tests) {
    if (test.id != clock_test || test.verdict == check::Verdict::fail) continue;
    test.sentence += std::string("; ") + check::remark_words +
                     "the stress depends on the length of a step, and the model passes the tests of a rate-dependent "
                     "material. Declare flags: [rate_dependent], or flags: [] if the rate is not meant to matter";
  }
  const std::string share = effect < 1 ? check::percent(effect) : check::rounded(effect) + " times itself";
  return {"the rate", share + "; flags: [rate_dependent] declares it"};
}

void hint_symmetry(const ResolvedMaterial& material, check::Report& report) {
  const auto& model = material.foreign;
  if (!model || model->interface == adapters::ForeignInterface::mfront || report.diagnosis.empty()) return;
  const auto found = std::find_if(report.diagnosis.begin(), report.diagnosis.end(),
                                  [](const auto& each) { return each.cause == check::causes::not_isotropic; });
  const bool unsaid = !model->symmetry_is_said && found != report.diagnosis.end();
  if (!unsaid && model->symmetry == ASSAY_ISOTROPIC) return;
  const auto passes_with = [&](adapters::Axes axes) {
    adapters::ForeignModel other = *model;
    if (unsaid) other.symmetry = ASSAY_ANISOTROPIC;
    other.axes = axes;
    return passes_as(taken_for(material, std::move(other)), report.effort);
  };
  const bool alone = unsaid && passes_with(model->axes);
  const bool turning = !alone && model->axes == adapters::Axes::fixed && passes_with(adapters::Axes::corotational);
  const std::string axes =
      "`axes: corotational`, with which it passes: its components are those in axes that turn with "
      "the body, as by *ORIENTATION";
  if (!unsaid) {
    if (turning) say_also(report, std::string(report.diagnosis.front().sentence), "; what it lacks is " + axes);
    return;
  }
  const std::string sentence = found->sentence;
  say_also(report, sentence,
           "; no symmetry is declared, so it was tested as isotropic: `symmetry: anisotropic`" +
               (alone     ? std::string(", with which it passes, declares directions of its own")
                : turning ? " and " + axes
                          : ", for a material with directions of its own, does not make it pass"));
}

}  // namespace assay::drivers
