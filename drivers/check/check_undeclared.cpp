// SPDX-License-Identifier: BSD-3-Clause
// What the description of a model leaves open: whether it depends on the rate, and whether it has directions of its
// own.
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

bool may_depend_on_rate(const ResolvedMaterial& material, const check::Report& report) {
  const check::TestResult* const clock = failed_test(report, clock_test);
  if (!material.foreign || material.foreign->flags_are_said || !clock) return false;
  const std::string flag = declarations_of(material).rate_dependence;  // named where the length of a step is to blame
  return clock->sentence.find(flag) != std::string::npos || !reads_time(material, report.strain, report.pressure);
}

ResolvedMaterial as_rate_dependent(const ResolvedMaterial& material) {
  adapters::ForeignModel model = material.foreign.value();
  model.flags |= ASSAY_RATE_DEPENDENT;
  return taken_for(material, std::move(model));
}

bool settles_rate(const check::Report& with_flag, const check::Report& without) {
  if (diagnosed(with_flag, {check::causes::clock})) return false;
  const bool overshoots = !with_flag.passes() && with_flag.diagnosis.front().cause == check::causes::dissipation;
  return overshoots || count_of(with_flag, check::Verdict::fail) < count_of(without, check::Verdict::fail);
}

Dependence say_rate(check::Report& report, double effect) {
  check::TestResult* const clock = test_of(report, clock_test);
  if (clock && clock->verdict != check::Verdict::fail)
    remark(*clock,
           "the stress depends on the length of a step, and the model passes the tests of a rate-dependent material. "
           "Declare flags: [rate_dependent], or flags: [] if the rate is not meant to matter");
  const std::string share = effect < 1 ? check::percent(effect) : check::rounded(effect) + " times itself";
  return {"the rate", share + "; flags: [rate_dependent] declares it"};
}

void hint_symmetry(const ResolvedMaterial& material, check::Report& report) {
  using adapters::Axes;
  const auto& model = material.foreign;
  if (!model || model->interface == adapters::ForeignInterface::mfront || report.passes()) return;
  const check::Diagnosis* const found = diagnosed(report, {check::causes::not_isotropic});
  const bool unsaid = !model->symmetry_is_said && found;
  if (!unsaid && model->symmetry == ASSAY_ISOTROPIC) return;
  const auto passes_with = [&](Axes axes) {
    adapters::ForeignModel model_so = *model;
    if (unsaid) model_so.symmetry = ASSAY_ANISOTROPIC;
    model_so.axes = axes;
    const ResolvedMaterial other = taken_for(material, std::move(model_so));
    check::Effort quick = report.effort;
    quick.quick = true;
    return check::run_battery(other.material, {.effort = quick, .declarations = declarations_of(other)}).passes();
  };
  const bool alone = unsaid && passes_with(model->axes);
  const bool turning = !alone && model->axes == Axes::fixed && passes_with(Axes::corotational);
  const std::string axes =
      "`axes: corotational`, with which it passes: its components are those in axes that turn with "
      "the body, as by *ORIENTATION";
  if (unsaid) {
    say_also(report, found->sentence,
             "; no symmetry is declared, so it was tested as isotropic: `symmetry: anisotropic`" +
                 (alone     ? ", with which it passes, declares directions of its own"
                  : turning ? " and " + axes
                            : ", for a material with directions of its own, does not make it pass"));
  } else if (turning) {
    say_also(report, report.diagnosis.front().sentence, "; what it lacks is " + axes);
  }
}

}  // namespace assay::drivers
