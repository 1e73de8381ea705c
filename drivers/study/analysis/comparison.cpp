// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/analysis/comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "drivers/study/analysis/clock.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

/// The cheapest case of the study at that level; null where there is none.
const std::size_t* best_at(const StudyFindings& findings, double level) {
  for (const StudyDigit& digit : findings.digits) {
    if (std::abs(digit.error - level) <= 1e-9 * level) return digit.best ? &*digit.best : nullptr;
  }
  return nullptr;
}

/// The levels of both at which one has a case, the largest first.
std::vector<double> levels_of(const StudyFindings& A, const StudyFindings& B) {
  std::vector<double> levels;
  for (const StudyFindings* each : {&A, &B}) {
    for (const StudyDigit& digit : each->digits) {
      if (digit.error > 0 && digit.best && (each == &A || !best_at(A, digit.error))) levels.push_back(digit.error);
    }
  }
  std::ranges::sort(levels, std::greater<>());
  return levels;
}

/// Whether, in B, the cheapest case of A is beaten by that of B.
bool is_beaten(const StudyCase& before, const StudyCase& now, double level, const StudyFindings& B) {
  if (!before.error || !(*before.error <= level) || !before.cost || !now.cost) return true;
  return told_apart(*now.cost, *before.cost, CostNoise(B, B).between(now, before).bound) > 0;
}

void compare_digits(const StudyFindings& A, const StudyFindings& B, Comparison& found) {
  std::map<std::size_t, std::size_t> in_b;
  for (const ComparedCase& one : found.cases) {
    if (one.a && one.b) in_b[*one.a] = *one.b;
  }
  for (const double level : levels_of(A, B)) {
    const std::size_t *a = best_at(A, level), *b = best_at(B, level);
    ComparedDigit digit{level, a ? A.cases[*a].label : "", b ? B.cases[*b].label : "", true, true};
    const auto same = a ? in_b.find(*a) : in_b.end();
    if (b && same != in_b.end()) {
      digit.changed = same->second != *b;
      digit.told_apart = digit.changed && is_beaten(B.cases[same->second], B.cases[*b], level, B);
    }
    found.digits.push_back(std::move(digit));
  }
}

/// Axis and value, ordered by axis; of the error budget the label too.
using CaseIdentity = std::vector<std::pair<std::string, std::string>>;

CaseIdentity identity_of(const StudyCase& one) {
  CaseIdentity identity;
  for (const AxisValue& at : one.values) {
    const auto number = parse_number(at.value);
    identity.emplace_back(at.axis, number ? number_text(*number) : at.value);
  }
  std::ranges::sort(identity);
  if (one.budget) identity.emplace_back("", one.label);
  return identity;
}

bool is_there(const StudyCase& one) { return one.outcome != "n/a" && one.outcome != "missing"; }

Standing standing_of(const StudyCase& a, const StudyCase& b) {
  if (a.completed()) return b.completed() ? Standing::compared : Standing::new_failure;
  return b.completed() ? Standing::fixed : Standing::still_fails;
}

ComparedFigure compared_errors(const StudyCase& a, const StudyCase& b) {
  ComparedFigure error{a.error, b.error, rounding_relative, 0};
  if (a.error && !b.error) error.trend = 1;   // is not finite any more
  if (!a.error && b.error) error.trend = -1;  // and the reverse
  if (!a.error || !b.error) return error;
  const double least = std::min(*a.error, *b.error);
  if (least > 0) error.bound = std::max(rounding_relative, rounding_absolute / least);
  if (std::abs(*b.error - *a.error) > rounding_absolute) error.trend = told_apart(*a.error, *b.error, error.bound);
  return error;
}

/// The two cases of one that is in both.
struct Pair {
  const StudyCase &a, &b;
};

std::vector<Pair> timed_pairs(const Comparison& found, const StudyFindings& A, const StudyFindings& B) {
  std::vector<Pair> pairs;
  for (const ComparedCase& one : found.cases) {
    if (one.standing == Standing::compared && A.cases[*one.a].cost && B.cases[*one.b].cost)
      pairs.push_back({A.cases[*one.a], B.cases[*one.b]});
  }
  return pairs;
}

/// Times of different machines differ by more than noise.
bool differ_in_machine(const Pair& pair) { return pair.a.clock.machine != pair.b.clock.machine; }

/// The same program and scene: what differs is the clock.
bool are_the_same(const Pair& pair) { return !pair.a.key.empty() && pair.a.key == pair.b.key; }

bool any_is_disturbed(const Pair& pair) { return is_disturbed(pair.a.clock) || is_disturbed(pair.b.clock); }

bool can_be_judged(const Pair& pair) { return !differ_in_machine(pair) && !any_is_disturbed(pair); }

/// Where several cases of a study have the same values, the first goes with the first.
void match_cases(const StudyFindings& A, const StudyFindings& B, Comparison& found) {
  std::multimap<CaseIdentity, std::size_t> left;  // cases of B that are not matched
  for (std::size_t i = 0; i < B.cases.size(); ++i) {
    if (is_there(B.cases[i])) left.emplace(identity_of(B.cases[i]), i);
  }
  for (std::size_t i = 0; i < A.cases.size(); ++i) {
    const StudyCase& a = A.cases[i];
    if (!is_there(a)) continue;
    ComparedCase& one = found.cases.emplace_back();
    one.label = a.label, one.a = i, one.standing = Standing::only_in_a, one.outcome_a = a.outcome;
    if (const auto [at, end] = left.equal_range(identity_of(a)); at != end) {
      one.b = at->second;
      one.standing = standing_of(a, B.cases[*one.b]);
      one.outcome_b = B.cases[*one.b].outcome;
      left.erase(at);
    }
  }
  std::set<std::size_t> rest;
  for (const auto& [identity, i] : left) rest.insert(i);
  for (const std::size_t i : rest) {
    const StudyCase& b = B.cases[i];
    ComparedCase& one = found.cases.emplace_back();
    one.label = b.label, one.b = i, one.standing = Standing::only_in_b, one.outcome_b = b.outcome;
  }
}

void warn_of_untimed(Comparison& found) {
  const auto untimed = std::ranges::count_if(found.cases, [](const ComparedCase& one) {
    return one.standing == Standing::compared && one.cost.a.has_value() != one.cost.b.has_value();
  });
  if (untimed > 0)
    found.warnings.push_back("the cost of " + std::to_string(untimed) + (untimed == 1 ? " case is" : " cases is") +
                             " known in only one of the studies");
}

void compare_figures(const StudyFindings& A, const StudyFindings& B, Comparison& found) {
  const CostNoise noise(A, B);
  std::ptrdiff_t same = 0;
  for (ComparedCase& one : found.cases) {
    if (one.standing != Standing::compared) continue;
    const StudyCase &a = A.cases[*one.a], &b = B.cases[*one.b];
    one.error = compared_errors(a, b);
    if (is_at_rest(A, a) || is_at_rest(B, b)) one.error.trend = 0;
    const CostBound bound = noise.between(a, b);
    one.cost = {a.cost, b.cost, bound.bound, 0};
    one.noise_measured = bound.measured;
    one.cost_judged = !is_measured(A) || can_be_judged({a, b});
    if (a.cost && b.cost && one.cost_judged) one.cost.trend = told_apart(*a.cost, *b.cost, bound.bound);
    if (one.cost.trend == 0 || !are_the_same({a, b})) continue;
    one.cost.trend = 0, one.cost_judged = false;
    ++same;
  }
  if (same > 0) {
    found.warnings.push_back(cases_text(same) +
                             " slower or faster with the same key, so with the same program and scene: this is noise "
                             "of the clock and is not judged");
  }
}

void warn_of(const std::vector<Pair>& pairs, const std::string& what, Comparison& found, const auto& holds) {
  const auto times = std::ranges::count_if(pairs, holds);
  if (times > 0) found.warnings.push_back(cases_text(times) + " " + what);
}

void warn_of_clocks(const std::vector<Pair>& pairs, Comparison& found) {
  warn_of(pairs, "timed on different machines: times are shown and not judged", found, differ_in_machine);
  warn_of(pairs, "not timed alone", found, [](const Pair& p) { return !p.a.clock.alone || !p.b.clock.alone; });
  warn_of(pairs, "disturbed, others kept more than " + disturbing_text() + " busy: times are shown and not judged",
          found, any_is_disturbed);
  warn_of(pairs,
          "timed once: no measure of noise, a difference counts beyond " + rounded_text(100 * single_floor, 2) + " %",
          found, [](const Pair& p) { return !p.a.cost_spread || !p.b.cost_spread; });
}

void compare_expectations(const StudyFindings& A, const StudyFindings& B, Comparison& found) {
  using Identity = std::array<std::string, 3>;
  const auto identity = [](const StudyExpectationOutcome& line) {
    return Identity{line.where, line.outcome.key, line.outcome.expected};
  };
  std::map<Identity, bool> held;
  for (const StudyExpectationOutcome& line : A.expect) held[identity(line)] = line.outcome.holds;
  for (const StudyExpectationOutcome& line : B.expect) {
    const auto before = held.find(identity(line));
    if (before == held.end() || before->second == line.outcome.holds) continue;
    found.expectations.push_back(
        {line.where, line.outcome.key, line.outcome.expected, line.outcome.found, line.outcome.holds});
  }
}

void compare_fronts(const StudyFindings& A, const StudyFindings& B, Comparison& found) {
  compare_digits(A, B, found);
  const auto is_on = [](const std::vector<std::size_t>& front, const std::optional<std::size_t>& at) {
    return at && std::ranges::find(front, *at) != front.end();
  };
  for (const ComparedCase& one : found.cases) {
    const bool a = is_on(A.front, one.a), b = is_on(B.front, one.b);
    if (a && !b) found.left.push_back(one.label);
    if (b && !a) found.entered.push_back(one.label);
  }
}

}  // namespace

bool ComparedCase::is_worse() const {
  return standing == Standing::new_failure || standing == Standing::only_in_a || error.trend > 0 || cost.trend > 0;
}

bool ComparedCase::is_better() const { return standing == Standing::fixed || error.trend < 0 || cost.trend < 0; }

int Comparison::count(Standing standing) const {
  return static_cast<int>(std::ranges::count(cases, standing, &ComparedCase::standing));
}

int Comparison::costs(int trend) const {
  return static_cast<int>(std::ranges::count(cases, trend, [](const auto& one) { return one.cost.trend; }));
}

int Comparison::errors(int trend) const {
  return static_cast<int>(std::ranges::count(cases, trend, [](const auto& one) { return one.error.trend; }));
}

int Comparison::broken(bool mended) const {
  return static_cast<int>(std::ranges::count(expectations, mended, &ComparedExpectation::holds));
}

bool Comparison::is_worse() const {
  return broken() > 0 || std::ranges::any_of(cases, [](const auto& one) { return one.is_worse(); });
}

Comparison compared(const StudyFindings& A, const StudyFindings& B) {
  if (A.error_key != B.error_key)
    throw InputError("the studies measure different errors: " + A.error_key + " and " + B.error_key);
  if (A.cost_key != B.cost_key)
    throw InputError("the studies measure different costs: " + A.cost_key + " and " + B.cost_key);
  Comparison found;
  match_cases(A, B, found);
  if (!found.cases.empty() &&
      std::ranges::none_of(found.cases, [](const ComparedCase& one) { return one.a && one.b; })) {
    throw InputError("no case is in both studies: their axes, or the values on these, differ");
  }
  if (is_measured(A)) warn_of_clocks(timed_pairs(found, A, B), found);
  const std::array named{std::pair("A", &A), std::pair("B", &B)};
  for (const auto& [name, findings] : named) {
    const std::string load = load_sentence(*findings);
    if (!load.empty()) found.warnings.push_back(std::string(name) + ": " + load);
  }
  for (const auto& [name, findings] : named) {  // a motion without an error is neither better nor worse
    const std::string rest = rest_words(*findings);
    if (!rest.empty()) found.warnings.push_back(name + rest);
  }
  compare_figures(A, B, found);
  warn_of_untimed(found);
  compare_fronts(A, B, found);
  compare_expectations(A, B, found);
  return found;
}

}  // namespace assay::drivers
