// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/time_noise.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/study/clock.hpp"

namespace assay::drivers {

namespace {

/// Absent of one repeat.
Figure spread_of(const StudyCase& one) {
  if (!one.cost || !one.cost_spread) return std::nullopt;
  return *one.cost_spread * (one.clock.step_s.size() == 2 ? spread_of_two : 1);
}

/// The median of the spreads of the study's cases; 0 where none has one.
double typical_spread(const StudyFindings& findings) {
  std::vector<double> spreads;
  for (const StudyCase& one : findings.cases) {
    if (const Figure spread = spread_of(one)) spreads.push_back(*spread);
  }
  return spreads.empty() ? 0 : median(std::move(spreads));
}

}  // namespace

bool is_measured(const StudyFindings& findings) {
  return findings.cost_unit == "s" || findings.cost_key.ends_with("_s") || findings.cost_key.ends_with("_bytes");
}

CostNoise::CostNoise(const StudyFindings& A, const StudyFindings& B)
    : measured_(is_measured(A)), typical_a_(typical_spread(A)), typical_b_(typical_spread(B)) {}

CostBound CostNoise::between(const StudyCase& a, const StudyCase& b) const {
  if (!measured_) return {counted_floor, true};
  const Figure spread_a = spread_of(a), spread_b = spread_of(b);
  if (!spread_a || !spread_b) return {single_floor, false};
  const double combined = std::hypot(std::max(*spread_a, typical_a_), std::max(*spread_b, typical_b_));
  return {std::max(spread_factor * combined, repeated_floor), true};
}

int told_apart(double before, double after, double bound) {
  const double least = std::min(std::abs(before), std::abs(after));
  if (!(std::abs(after - before) > bound * least)) return 0;
  return after > before ? 1 : -1;
}

}  // namespace assay::drivers
