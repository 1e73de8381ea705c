// SPDX-License-Identifier: BSD-3-Clause
// Whether a model keeps a state by the number of the element.
#include <algorithm>
#include <array>

#include "drivers/check/check_foreign.hpp"
#include "drivers/material/source_entry.hpp"
#include "harness/check/march.hpp"

namespace assay::drivers {

namespace {

/// A body that is strained step by step, in an element.
class Body {
 public:
  static constexpr int steps = 16;

  Body(const Material& material, int element, double strain, double pressure)
      : material_(material), bridge_(*bridge_of(material)), host_(bridge_.host_values()), strain_(strain) {
    host_.element = element;
    bridge_.hold(host_);
    state_ = check::state_at_rest(material_, pressure);
  }

  void step() {
    const check::Space space(material_);
    const auto F = [&](int at) { return space.stretch(strain_, static_cast<double>(at) / steps); };
    bridge_.hold(host_);
    const double dt = 1.0 / steps;
    const Answer answer = answer_of(material_, {k_ * dt, dt, F(k_), F(k_ + 1), state_});
    state_ = state_in(answer);
    answers_.insert(answers_.end(), answer.begin(), answer.begin() + state_of_answer);
    ++k_;
  }

  /// Status and stress of all its steps.
  const std::vector<double>& answers() const { return answers_; }

 private:
  const Material& material_;
  adapters::AbaqusBridge& bridge_;
  adapters::HostValues host_;
  double strain_;
  int k_ = 0;
  std::vector<double> state_, answers_;
};

/// What two bodies answer, in an element each: one after the other, or in turn.
std::vector<double> answers(const Material& material, double strain, double pressure,
                            const std::array<int, 2>& elements, bool in_turn) {
  constexpr double other_way = -0.7;  // so that each body knows which largest strain was its own
  Body first(material, elements[0], strain, pressure);
  for (int k = 0; !in_turn && k < Body::steps; ++k) first.step();
  Body other(material, elements[1], other_way * strain, pressure);
  for (int k = 0; k < Body::steps; ++k) {
    if (in_turn) first.step();
    other.step();
  }
  std::vector<double> all = first.answers();
  all.insert(all.end(), other.answers().begin(), other.answers().end());
  return all;
}

/// Whether two bodies, each with an element of its own, are as either of them alone, and with one for both are not.
bool keeps_state_by_element(const ResolvedMaterial& material, double strain, double pressure) {
  if (!bridge_of(material.material) || !(strain > 0)) return false;
  constexpr double limit_s = 20;
  const auto rows = made_elsewhere(
      [&]() -> check::History {
        const Material body = material.material.clone();
        const auto of = [&](int one, int other, bool in_turn) {
          return answers(body, strain, pressure, {one, other}, in_turn);
        };
        return {of(2, 3, false), of(7, 8, false), of(4, 5, true), of(6, 6, true)};  // that no test has used
      },
      limit_s);
  if (!rows) return false;
  const auto& all = *rows;
  return same_answer(all[0], all[1]) && same_answer(all[0], all[2]) && !same_answer(all[0], all[3]);
}

}  // namespace

void judge_elements(const ResolvedMaterial& material, check::Report& report) {
  const auto test = std::ranges::find_if(report.tests, [](const check::TestResult& each) {
    return each.verdict == check::Verdict::fail && each.cause == check::causes::hidden_state;
  });
  if (test == report.tests.end() || !material.foreign) return;
  const double strain = report.strain > 0 ? report.strain : report.effort.strain;
  if (!keeps_state_by_element(material, strain, report.pressure)) return;
  test->cause = check::causes::kept_by_element;
  const bool umat = is_of(material, adapters::ForeignInterface::umat);
  std::string words =
      std::string("the model keeps a state by ") + (umat ? "NOEL" : "the number of the element") + " outside of " +
      (is_of(material, adapters::ForeignInterface::vumat) ? "stateNew" : state_word(material.foreign->interface)) +
      ": two bodies in turn behave as each body alone if they have different elements, and differently "
      "if they share one; ";
  if (umat) {
    words += material.foreign->each_its_element
                 ? "`elements: each` is enough only for runs that take each point once a step, "
                   "which no implicit program does, but "
                 : "elements: each in its description gives each point of a run its own, but ";
  }
  say_instead(report, *test, words + "a step that is repeated, as in the tests, has another result");
}

}  // namespace assay::drivers
