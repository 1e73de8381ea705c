// SPDX-License-Identifier: BSD-3-Clause
// What is said of tensors in a state that nobody has declared.
#include <algorithm>

#include "adapters/foreign/foreign_state.hpp"
#include "drivers/check/check_foreign.hpp"
#include "drivers/material/material_description.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

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
  const std::string kind = names_of(v.kind)[static_cast<std::size_t>(v.kind)];
  if (!begins_elsewhere(v)) return kind;
  std::vector<std::string> numbers;
  for (const double value : v.initial) numbers.push_back(number_text(value));
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
  try {
    const Material other = made_for_tests(model, material.choice.parameters);
    check::Effort effort = before.effort;
    effort.quick = true;
    const check::Report report =
        check::run_battery(other, {.effort = effort, .declarations = declarations_of(material)});
    for (const check::Diagnosis& each : report.diagnosis) {
      if (is_of_turns(each) && each.sentence.find("STATEV(") != std::string::npos) return each;
    }
  } catch (const std::runtime_error&) {
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
             "; or, if the source is right, one of the numbers of `state` belongs to a tensor: declare it, as in "
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
