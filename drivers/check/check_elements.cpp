// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_elements.hpp"

#include <algorithm>

#include "adapters/foreign/host_values.hpp"
#include "drivers/check/check_elsewhere.hpp"
#include "drivers/check/check_foreign.hpp"
#include "drivers/check/check_steps.hpp"
#include "drivers/material/material_description.hpp"
#include "harness/check/march.hpp"

namespace assay::drivers {

namespace {

using adapters::HostAccess;
using adapters::HostValues;

/// A body that is strained step by step, in an element.
class Body {
 public:
  Body(const Material& material, const HostAccess& access, int element, double strain, double pressure)
      : material_(material), access_(access), host_(access.values(material.self())), strain_(strain) {
    host_.element = element;
    access_.hold(material_.self(), host_);
    state_ = check::state_at_rest(material_, pressure);
  }

  /// Its stress at the end.
  std::vector<double> step(int k, int count) {
    const check::Space space(material_);
    const auto F = [&](int at) { return space.stretch(strain_, static_cast<double>(at) / count); };
    access_.hold(material_.self(), host_);
    const double dt = 1.0 / count;
    const Answer answer = answer_of(material_, {k * dt, dt, F(k), F(k + 1), state_, k == 0});
    state_.assign(answer.begin() + state_of_answer, answer.end());
    return {answer.begin(), answer.begin() + state_of_answer};
  }

 private:
  const Material& material_;
  const HostAccess& access_;
  HostValues host_;
  double strain_;
  std::vector<double> state_;
};

/// One body after the other, and in turn. Elements that no test has used.
class Bodies {
 public:
  Bodies(const ResolvedMaterial& material, const HostAccess& access, double strain, double pressure)
      : material_(material.material.clone()), access_(access), strain_(strain), pressure_(pressure) {}

  /// Both, the first of them before the other.
  std::vector<double> alone(int element, int of_the_other) {
    std::vector<double> all;
    for (const auto& [at, amplitude] : {std::pair(element, strain_), std::pair(of_the_other, other_way * strain_)}) {
      Body body(material_, access_, at, amplitude, pressure_);
      for (int k = 0; k < count_; ++k) append(body.step(k, count_), all);
    }
    return all;
  }

  std::vector<double> in_turn(int element, int of_the_other) {
    std::vector<double> all, of_other;
    Body body(material_, access_, element, strain_, pressure_),
        other(material_, access_, of_the_other, other_way * strain_, pressure_);
    for (int k = 0; k < count_; ++k) {
      append(body.step(k, count_), all);
      append(other.step(k, count_), of_other);
    }
    append(of_other, all);
    return all;
  }

 private:
  static constexpr double other_way = -0.7;  // so that each body knows which largest strain was its own

  static void append(const std::vector<double>& more, std::vector<double>& all) {
    all.insert(all.end(), more.begin(), more.end());
  }

  static constexpr int count_ = 16;
  Material material_;
  const HostAccess& access_;
  double strain_, pressure_;
};

}  // namespace

bool keeps_state_by_element(const ResolvedMaterial& material, double strain, double pressure) {
  const auto* access = material.material.extension<HostAccess>(adapters::host_access);
  if (!access || !(strain > 0)) return false;
  constexpr double limit_s = 20;
  const auto rows = made_elsewhere(
      [&]() -> check::History {
        Bodies bodies(material, *access, strain, pressure);
        return {bodies.alone(2, 3), bodies.alone(7, 8), bodies.in_turn(4, 5), bodies.in_turn(6, 6)};
      },
      limit_s);
  if (!rows || rows->size() != 4) return false;
  const auto& all = *rows;
  return same_answer(all[0], all[1]) && same_answer(all[0], all[2]) && !same_answer(all[0], all[3]);
}

void judge_elements(const ResolvedMaterial& material, check::Report& report) {
  const auto test = std::find_if(report.tests.begin(), report.tests.end(), [](const check::TestResult& each) {
    return each.verdict == check::Verdict::fail && each.cause == check::causes::hidden_state;
  });
  if (test == report.tests.end()) return;
  const auto& model = material.foreign;
  const double strain = report.strain > 0 ? report.strain : report.effort.strain;
  if (!model || !keeps_state_by_element(material, strain, report.pressure)) return;
  test->cause = check::causes::kept_by_element;
  const bool umat = model->interface == adapters::ForeignInterface::umat;
  std::string words = std::string("the model keeps a state by ") + (umat ? "NOEL" : "the number of the element") +
                      " outside of " + (umat ? "STATEV" : "stateNew") +
                      ": two bodies in turn behave as each body alone if they have different elements, and differently "
                      "if they share one; ";
  if (umat) {
    words += model->each_its_element ? "`elements: each` is enough only for runs that take each point once a step, "
                                       "which no implicit program does, but "
                                     : "elements: each in its description gives each point of a run its own, but ";
  }
  say_instead(report, *test, words + "a step that is repeated, as in the tests, has another result");
}

}  // namespace assay::drivers
