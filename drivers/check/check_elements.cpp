// SPDX-License-Identifier: BSD-3-Clause
// Whether a model keeps a state by the number of the element.
#include <algorithm>

#include "drivers/check/check_elsewhere.hpp"
#include "drivers/check/check_foreign.hpp"
#include "drivers/check/check_steps.hpp"
#include "harness/check/march.hpp"

namespace assay::drivers {

namespace {

using adapters::HostAccess;

/// A body that is strained step by step, in an element.
class Body {
 public:
  Body(const Material& material, const HostAccess& access, int element, double strain, double pressure)
      : material_(material), access_(access), host_(access.values(material.self())), strain_(strain) {
    host_.element = element;
    access_.hold(material_.self(), host_);
    state_ = check::state_at_rest(material_, pressure);
  }

  /// Takes the next step; false where that was the last.
  bool step() {
    constexpr int count = 16;
    const check::Space space(material_);
    const auto F = [&](int at) { return space.stretch(strain_, static_cast<double>(at) / count); };
    access_.hold(material_.self(), host_);
    const double dt = 1.0 / count;
    const Answer answer = answer_of(material_, {k_ * dt, dt, F(k_), F(k_ + 1), state_});
    state_ = state_in(answer);
    answers_.insert(answers_.end(), answer.begin(), answer.begin() + state_of_answer);
    return ++k_ < count;
  }

  /// Status and stress of all its steps.
  const std::vector<double>& answers() const { return answers_; }

 private:
  const Material& material_;
  const HostAccess& access_;
  adapters::HostValues host_;
  double strain_;
  int k_ = 0;
  std::vector<double> state_, answers_;
};

/// What two bodies answer, the first before the other, or both in turn.
class Bodies {
 public:
  Bodies(const ResolvedMaterial& material, const HostAccess& access, double strain, double pressure)
      : material_(material.material.clone()), access_(access), strain_(strain), pressure_(pressure) {}

  std::vector<double> alone(int element, int of_the_other) {
    Body first = body(element, 1);
    while (first.step()) {
    }
    Body other = body(of_the_other, other_way);
    while (other.step()) {
    }
    return joined(first, other);
  }

  std::vector<double> in_turn(int element, int of_the_other) {
    Body first = body(element, 1), other = body(of_the_other, other_way);
    while (first.step()) other.step();
    other.step();
    return joined(first, other);
  }

 private:
  static constexpr double other_way = -0.7;  // so that each body knows which largest strain was its own

  Body body(int element, double share) const { return {material_, access_, element, share * strain_, pressure_}; }

  static std::vector<double> joined(const Body& first, const Body& other) {
    std::vector<double> all = first.answers();
    all.insert(all.end(), other.answers().begin(), other.answers().end());
    return all;
  }

  Material material_;
  const HostAccess& access_;
  double strain_, pressure_;
};

/// Whether two bodies, each with an element of its own, are as either of them alone, and with one for both are not.
bool keeps_state_by_element(const ResolvedMaterial& material, double strain, double pressure) {
  const HostAccess* const access = host_of(material.material);
  if (!access || !(strain > 0)) return false;
  constexpr double limit_s = 20;
  const auto rows = made_elsewhere(
      [&]() -> check::History {
        Bodies bodies(material, *access, strain, pressure);  // in elements that no test has used
        return {bodies.alone(2, 3), bodies.alone(7, 8), bodies.in_turn(4, 5), bodies.in_turn(6, 6)};
      },
      limit_s);
  if (!rows || rows->size() != 4) return false;
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
  std::string words = std::string("the model keeps a state by ") + (umat ? "NOEL" : "the number of the element") +
                      " outside of " + (umat ? "STATEV" : "stateNew") +
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
