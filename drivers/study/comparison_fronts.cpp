// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/comparison_fronts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "drivers/study/time_noise.hpp"

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
  std::sort(levels.begin(), levels.end(), std::greater<>());
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

}  // namespace

void compare_fronts(const StudyFindings& A, const StudyFindings& B, Comparison& found) {
  compare_digits(A, B, found);
  const auto is_on = [](const std::vector<std::size_t>& front, const std::optional<std::size_t>& at) {
    return at && std::find(front.begin(), front.end(), *at) != front.end();
  };
  for (const ComparedCase& one : found.cases) {
    const bool a = is_on(A.front, one.a), b = is_on(B.front, one.b);
    if (a && !b) found.left.push_back(one.label);
    if (b && !a) found.entered.push_back(one.label);
  }
}

}  // namespace assay::drivers
