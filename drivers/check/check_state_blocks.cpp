// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_state_blocks.hpp"

#include <algorithm>

#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/foreign_table.hpp"
#include "drivers/check/check_foreign.hpp"
#include "drivers/material/material_description.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

using adapters::ForeignModel;
using adapters::ForeignVariable;
using Kind = ForeignVariable::Kind;

/// What a tensor in the state can be behind, as the tests of rotation tell it.
bool is_of_turns(const std::string& cause) {
  using namespace check::causes;
  const char* const all[] = {rotation_missing,   wrong_spin,  explicit_spin, state_not_rotated, not_indifferent,
                             components_swapped, other_order, shear_factor,  not_isotropic};
  return std::any_of(std::begin(all), std::end(all), [&](const char* each) { return cause == each; });
}

std::size_t unknown_of(const ForeignModel& model) {
  return static_cast<std::size_t>(
      std::count_if(model.state.begin(), model.state.end(), [](const ForeignVariable& v) { return !v.kind_is_said; }));
}

/// Of STATEV, where a variable begins, from 0.
std::size_t component_of(const ForeignModel& model, std::size_t variable) {
  std::size_t at = 0;
  for (std::size_t k = 0; k < variable; ++k) {
    at += static_cast<std::size_t>(adapters::components_of(model.state[k].kind));
  }
  return at;
}

bool begins_elsewhere(const ForeignVariable& v) {
  return std::any_of(v.initial.begin(), v.initial.end(), [](double value) { return value != 0; });
}

/// "vector", or "{kind: vector, initial: [1, 0, 0]}"
std::string variable_words(const ForeignVariable& v) {
  const std::string kind = names_of(v.kind)[static_cast<std::size_t>(v.kind)];
  if (!begins_elsewhere(v)) return kind;
  std::string numbers;
  for (const double value : v.initial) numbers += (numbers.empty() ? "" : ", ") + number_text(value);
  return "{kind: " + kind + ", initial: " + (v.initial.size() == 1 ? numbers : "[" + numbers + "]") + "}";
}

/// So many variables from that one on that have no name but their place.
std::size_t nameless_from(const ForeignModel& model, std::size_t first) {
  const auto is_nameless = [&](std::size_t at) {
    const ForeignVariable& v = model.state[at];
    return !v.kind_is_said && !begins_elsewhere(v) && v.name == "s" + std::to_string(component_of(model, at) + 1);
  };
  std::size_t count = 0;
  while (first + count < model.state.size() && is_nameless(first + count)) ++count;
  return count;
}

/// "`state: {t1: symmetric_tensor, s7: scalar}`"
std::string declared(const ForeignModel& model) {
  std::string text;
  int tensors = 0;
  for (std::size_t k = 0; k < model.state.size();) {
    const ForeignVariable& v = model.state[k];
    const std::size_t count = nameless_from(model, k);
    const bool is_guessed = v.name.find('(') != std::string::npos;
    text += (text.empty() ? "" : ", ") + (is_guessed ? "t" + std::to_string(++tensors) : v.name) + ": " +
            (count > 1 ? "{count: " + std::to_string(count) + "}" : variable_words(v));
    k += std::max<std::size_t>(count, 1);
  }
  return "`state: {" + text + "}`";
}

check::Diagnosis* first_of_turns(check::Report& report) {
  const auto found = std::find_if(report.diagnosis.begin(), report.diagnosis.end(),
                                  [](const check::Diagnosis& each) { return is_of_turns(each.cause); });
  return found == report.diagnosis.end() ? nullptr : &*found;
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
      if (is_of_turns(each.cause) && each.sentence.find("STATEV(") != std::string::npos) return each;
    }
  } catch (const std::runtime_error&) {
  }
  return std::nullopt;
}

/// Another cause and sentence for what was found first, of all tests that had that cause.
void replace(check::Report& report, check::Diagnosis& old, const check::Diagnosis& other) {
  for (check::TestResult& test : report.tests) {
    if (test.verdict != check::Verdict::fail || test.cause != old.cause) continue;
    test.cause = other.cause;
    if (test.sentence == old.sentence) test.sentence = other.sentence;
  }
  std::vector<check::Diagnosis> all;
  for (const check::Diagnosis& each : report.diagnosis) {
    if (&each == &old) all.push_back(other);
    if (each.cause != other.cause && !is_of_turns(each.cause)) all.push_back(each);
  }
  report.diagnosis = all;
}

}  // namespace

void judge_state_blocks(const ResolvedMaterial& material, check::Report& report) {
  check::Diagnosis* const found = first_of_turns(report);
  if (!found) return;
  const std::optional<ForeignModel>& model = material.foreign;
  constexpr std::size_t least = 3;  // components of a vector
  const bool fixed_axes =
      model && model->interface == adapters::ForeignInterface::umat && model->axes == adapters::Axes::fixed;
  if (!fixed_axes || unknown_of(*model) < least) return;
  const StateGuess guess = guessed_blocks(material, *model, report.strain, report.pressure);
  if (!guess.turns) return;
  if (guess.blocks.empty()) {
    const std::string words = found->sentence;
    say_also(report, words,
             "; or, if the source is right, one of the numbers of `state` belongs to a tensor: declare it, as in "
             "`state: {back_stress: symmetric_tensor}`");
    return;
  }
  const ForeignModel other = with_blocks(*model, guess.blocks);
  const auto diagnosis = named(other, material, report);
  if (diagnosis) replace(report, *found, *diagnosis);
  say_also(report, first_of_turns(report)->sentence,
           diagnosis ? "; to have it tested as a tensor, declare " + declared(other)
                     : "; its state holds tensors: to have them tested, declare " + declared(other));
}

}  // namespace assay::drivers
