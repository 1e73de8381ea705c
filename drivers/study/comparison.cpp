// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "drivers/study/clock.hpp"
#include "drivers/study/comparison_fronts.hpp"
#include "drivers/study/study_words.hpp"
#include "drivers/study/time_noise.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/number_format.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

/// Axis and value, ordered by axis; of the error budget the label too.
using CaseIdentity = std::vector<std::pair<std::string, std::string>>;

CaseIdentity identity_of(const StudyCase& one) {
  CaseIdentity identity;
  for (const AxisValue& at : one.values) {
    const auto number = parse_number(at.value);
    identity.emplace_back(at.axis, number ? number_text(*number) : at.value);
  }
  std::sort(identity.begin(), identity.end());
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

/// Pairs of cases. Where several cases of a study have the same values, the first goes with the first.
class Matcher {
 public:
  explicit Matcher(const StudyFindings& B) {
    for (std::size_t i = B.cases.size(); i-- > 0;) {
      if (is_there(B.cases[i])) left_[identity_of(B.cases[i])].push_back(i);
    }
  }
  std::optional<std::size_t> take(const StudyCase& a) {
    const auto found = left_.find(identity_of(a));
    if (found == left_.end() || found->second.empty()) return std::nullopt;
    const std::size_t i = found->second.back();
    found->second.pop_back();
    return i;
  }
  std::set<std::size_t> rest() const {
    std::set<std::size_t> all;
    for (const auto& [identity, cases] : left_) all.insert(cases.begin(), cases.end());
    return all;
  }

 private:
  std::map<CaseIdentity, std::vector<std::size_t>> left_;  ///< cases of B not yet taken, the first last
};

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

void match_cases(const StudyFindings& A, const StudyFindings& B, Comparison& found) {
  Matcher matcher(B);
  for (std::size_t i = 0; i < A.cases.size(); ++i) {
    const StudyCase& a = A.cases[i];
    if (!is_there(a)) continue;
    ComparedCase one;
    one.label = a.label, one.a = i, one.b = matcher.take(a), one.outcome_a = a.outcome;
    one.standing = one.b ? standing_of(a, B.cases[*one.b]) : Standing::only_in_a;
    if (one.b) one.outcome_b = B.cases[*one.b].outcome;
    found.cases.push_back(std::move(one));
  }
  for (const std::size_t i : matcher.rest()) {
    ComparedCase one;
    one.label = B.cases[i].label, one.b = i, one.standing = Standing::only_in_b, one.outcome_b = B.cases[i].outcome;
    found.cases.push_back(std::move(one));
  }
}

void warn_of_untimed(Comparison& found) {
  const auto untimed = std::count_if(found.cases.begin(), found.cases.end(), [](const ComparedCase& one) {
    return one.standing == Standing::compared && one.cost.before.has_value() != one.cost.after.has_value();
  });
  if (untimed > 0)
    found.warnings.push_back("the cost of " + std::to_string(untimed) + (untimed == 1 ? " case is" : " cases is") +
                             " known in only one of the studies");
}

/// A motion without an error to compare is neither better nor worse.
void warn_of_rest(const std::string& name, const StudyFindings& findings, Comparison& found) {
  const std::string words = rest_words(findings);
  if (!words.empty()) found.warnings.push_back(name + words);
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

template <class Condition>
void warn_of(const std::vector<Pair>& pairs, const std::string& what, Comparison& found, const Condition& holds) {
  const auto times = std::count_if(pairs.begin(), pairs.end(), holds);
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

void warn_of_load(const std::string& name, const StudyFindings& findings, Comparison& found) {
  const std::string load = load_sentence(findings);
  if (!load.empty()) found.warnings.push_back(name + ": " + load);
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

}  // namespace

bool ComparedCase::is_worse() const {
  return standing == Standing::new_failure || standing == Standing::only_in_a || error.trend > 0 || cost.trend > 0;
}

bool ComparedCase::is_better() const { return standing == Standing::fixed || error.trend < 0 || cost.trend < 0; }

int Comparison::count(Standing standing) const {
  return static_cast<int>(
      std::count_if(cases.begin(), cases.end(), [&](const ComparedCase& one) { return one.standing == standing; }));
}

int Comparison::costs(int trend) const {
  return static_cast<int>(
      std::count_if(cases.begin(), cases.end(), [&](const ComparedCase& one) { return one.cost.trend == trend; }));
}

int Comparison::errors(int trend) const {
  return static_cast<int>(
      std::count_if(cases.begin(), cases.end(), [&](const ComparedCase& one) { return one.error.trend == trend; }));
}

int Comparison::broken(bool mended) const {
  return static_cast<int>(std::count_if(expectations.begin(), expectations.end(),
                                        [&](const ComparedExpectation& one) { return one.mended == mended; }));
}

bool Comparison::is_worse() const {
  return broken() > 0 || std::any_of(cases.begin(), cases.end(), [](const auto& one) { return one.is_worse(); });
}

Comparison compared(const StudyFindings& A, const StudyFindings& B) {
  if (A.error_key != B.error_key)
    throw InputError("the studies measure different errors: " + A.error_key + " and " + B.error_key);
  if (A.cost_key != B.cost_key)
    throw InputError("the studies measure different costs: " + A.cost_key + " and " + B.cost_key);
  Comparison found;
  match_cases(A, B, found);
  if (!found.cases.empty() &&
      std::none_of(found.cases.begin(), found.cases.end(), [](const ComparedCase& one) { return one.a && one.b; })) {
    throw InputError("no case is in both studies: their axes, or the values on these, differ");
  }
  if (is_measured(A)) warn_of_clocks(timed_pairs(found, A, B), found);
  warn_of_load("A", A, found);
  warn_of_load("B", B, found);
  warn_of_rest("A", A, found);
  warn_of_rest("B", B, found);
  compare_figures(A, B, found);
  warn_of_untimed(found);
  compare_fronts(A, B, found);
  compare_expectations(A, B, found);
  return found;
}

}  // namespace assay::drivers
