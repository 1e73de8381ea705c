// SPDX-License-Identifier: BSD-3-Clause
// What the description of a model leaves open: whether it depends on the rate, whether it has directions of its own,
// and which numbers of its state are tensors.
#include <algorithm>

#include "adapters/foreign/foreign_state.hpp"
#include "drivers/check/check_foreign.hpp"
#include "drivers/material/material_description.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/check/judge.hpp"

namespace assay::drivers {

namespace {

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

using adapters::components_of;
using adapters::ForeignModel;
using adapters::ForeignVariable;
using namespace check::causes;

/// What a tensor in the state can be behind, as the tests of rotation tell it.
constexpr auto of_turns = {rotation_missing,   wrong_spin,  explicit_spin, state_not_rotated, not_indifferent,
                           components_swapped, other_order, shear_factor,  not_isotropic};

bool is_of_turns(const check::Diagnosis& each) { return std::ranges::count(of_turns, each.cause) > 0; }

bool begins_elsewhere(const ForeignVariable& v) {
  return std::ranges::any_of(v.initial, [](double value) { return value != 0; });
}

/// "vector", or "{kind: vector, initial: [1, 0, 0]}"
std::string variable_words(const ForeignVariable& v) {
  std::string kind = word_of(v.kind);
  if (!begins_elsewhere(v)) return kind;
  const std::vector<std::string> numbers = mapped(v.initial, number_text);
  return "{kind: " + kind + ", initial: " + (numbers.size() == 1 ? numbers[0] : "[" + joined(numbers) + "]") + "}";
}

/// "`state: {t1: symmetric_tensor, s7: scalar}`"; variables that follow each other and have no name but their place are
/// counted.
std::string declared(const ForeignModel& model) {
  std::vector<std::string> entries;
  int tensors = 0, place = 1, nameless = 0;
  for (const ForeignVariable& v : model.state) {
    const bool is_nameless = !v.kind_is_said && !begins_elsewhere(v) && v.name == "s" + std::to_string(place);
    const bool is_guessed = v.name.find('(') != std::string::npos;
    const std::string name = is_guessed ? "t" + std::to_string(++tensors) : v.name;
    nameless = is_nameless ? nameless + 1 : 0;
    if (nameless > 1) {
      const std::string& first = entries.back();
      entries.back() = first.substr(0, first.find(':')) + ": {count: " + std::to_string(nameless) + "}";
    } else {
      entries.push_back(name + ": " + variable_words(v));
    }
    place += components_of(v.kind);
  }
  return "`state: {" + joined(entries) + "}`";
}

/// Of the model with its tensors declared: what it says of one of them.
std::optional<check::Diagnosis> named(const ForeignModel& model, const ResolvedMaterial& material,
                                      const check::Report& before) {
  check::Effort effort = before.effort;
  effort.quick = true;
  const auto report = battery_as(model, material, effort);
  if (!report) return std::nullopt;
  for (const check::Diagnosis& each : report->diagnosis) {
    if (is_of_turns(each) && each.sentence.find("STATEV(") != std::string::npos) return each;
  }
  return std::nullopt;
}

/// Another cause and sentence for what was found first, of all tests that had that cause.
void replace(check::Report& report, const check::Diagnosis& old, const check::Diagnosis& other) {
  for (check::TestResult& test : report.tests) {
    if (test.verdict != check::Verdict::fail || test.cause != old.cause) continue;
    test.cause = other.cause;
    if (test.sentence == old.sentence) test.sentence = other.sentence;
  }
  std::vector<check::Diagnosis> all;
  for (const check::Diagnosis& each : report.diagnosis) {
    if (&each == &old) all.push_back(other);
    if (each.cause != other.cause && !is_of_turns(each)) all.push_back(each);
  }
  report.diagnosis = all;
}

}  // namespace

bool may_depend_on_rate(const ResolvedMaterial& material, const check::Report& report) {
  const check::TestResult* const clock = failed_test(report, check::ids::clock);
  if (!material.foreign || material.foreign->flags_are_said || !clock) return false;
  const std::string flag = declarations_of(material).rate_dependence;  // named where the length of a step is to blame
  return clock->sentence.find(flag) != std::string::npos || !reads_time(material, report.strain, report.pressure);
}

ResolvedMaterial as_rate_dependent(const ResolvedMaterial& material) {
  adapters::ForeignModel model = material.foreign.value();
  model.flags |= ASSAY_RATE_DEPENDENT;
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

bool settles_rate(const check::Report& with_flag, const check::Report& without) {
  if (diagnosed(with_flag, {check::causes::clock})) return false;
  const bool overshoots = !with_flag.passes() && with_flag.diagnosis.front().cause == check::causes::dissipation;
  return overshoots || count_of(with_flag, check::Verdict::fail) < count_of(without, check::Verdict::fail);
}

Dependence say_rate(check::Report& report, double effect) {
  check::TestResult* const clock = test_of(report, check::ids::clock);
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
    check::Effort quick = report.effort;
    quick.quick = true;
    const auto again = battery_as(model_so, material, quick);
    return again && again->passes();
  };
  const bool alone = unsaid && passes_with(model->axes);
  const bool turning = !alone && model->axes == Axes::fixed && passes_with(Axes::corotational);
  const std::string axes =
      "`axes: corotational`, with which it passes: its components are those in axes that turn with "
      "the body, as by *ORIENTATION";
  if (unsaid) {
    say_also(report, found->sentence,
             std::string(advice_on_symmetry) + ", so it was tested as isotropic: `symmetry: anisotropic`" +
                 (alone     ? ", with which it passes, declares directions of its own"
                  : turning ? " and " + axes
                            : ", for a material with directions of its own, does not make it pass"));
  } else if (turning) {
    say_also(report, report.diagnosis.front().sentence, "; what it lacks is " + axes);
  }
}

void hint_axes(const ResolvedMaterial& material, check::Report& report) {
  using adapters::Axes;
  const check::Diagnosis* const found = diagnosed(report, of_turns);
  if (!found || !is_of(material, adapters::ForeignInterface::usermat)) return;
  ForeignModel other = *material.foreign;
  if (other.symmetry != ASSAY_ISOTROPIC) return;  // hint_symmetry tells it
  other.axes = other.axes == Axes::fixed ? Axes::corotational : Axes::fixed;
  check::Effort quick = report.effort;
  quick.quick = true;
  const auto again = battery_as(other, material, quick);
  if (again && !diagnosed(*again, of_turns))
    say_also(report, found->sentence, "; with `axes: " + word_of(other.axes) + "` in its description it is right");
}

void judge_state_blocks(const ResolvedMaterial& material, check::Report& report) {
  constexpr int least = 3;  // components of a vector
  const check::Diagnosis* const found = diagnosed(report, of_turns);
  if (!found || !is_of(material, adapters::ForeignInterface::umat)) return;
  const ForeignModel& model = *material.foreign;
  const auto unknown = std::ranges::count(model.state, false, &ForeignVariable::kind_is_said);
  if (model.axes != adapters::Axes::fixed || unknown < least) return;
  const StateGuess guess = guessed_blocks(material, model, report.strain, report.pressure);
  if (!guess.turns) return;
  if (guess.blocks.empty()) {
    say_also(report, found->sentence,
             std::string(advice_on_state) +
                 ", one of the numbers of `state` belongs to a tensor: declare it, as in "
                 "`state: {back_stress: symmetric_tensor}`");
    return;
  }
  const ForeignModel other = with_blocks(model, guess.blocks);
  const auto diagnosis = named(other, material, report);
  if (diagnosis) replace(report, *found, *diagnosis);
  say_also(report, diagnosed(report, of_turns)->sentence,
           (diagnosis ? "; to have it tested as a tensor, declare "
                      : "; its state holds tensors: to have them tested, declare ") +
               declared(other));
}

}  // namespace assay::drivers
