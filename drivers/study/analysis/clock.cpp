// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/analysis/clock.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/text/numbers.hpp"

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

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

bool is_disturbed(const ClockReadings& clock) {
  return !clock.others.empty() && median(clock.others) > disturbing_share * cores_of(clock.machine);
}

MeasuredLoad load_of(const StudyFindings& findings) {
  MeasuredLoad load;
  double busy = 0, seconds = 0;
  for (const StudyCase& one : findings.cases) {
    const ClockReadings& clock = one.clock;
    if (!clock.alone || clock.others.empty()) continue;
    ++load.timed;
    if (is_disturbed(clock)) ++load.disturbed;
    double length = 0;
    for (std::size_t k = 0; k < clock.others.size(); ++k) length += k < clock.wall_s.size() ? clock.wall_s[k] : 1;
    busy += length * median(clock.others) / cores_of(clock.machine);
    seconds += length;
  }
  if (seconds > 0) load.share = std::min(1.0, busy / seconds);
  return load;
}

std::string load_sentence(const StudyFindings& findings) {
  const MeasuredLoad load = load_of(findings);
  if (!load.noticeable() || findings.cost_unit != "s") return {};
  return "times were measured while other programs used " + rounded_text(100 * load.share, 2) +
         " % of the processors, and more than " + rounded_text(100 * disturbing_share, 3) + " % beside " +
         std::to_string(load.disturbed) + " of " + std::to_string(load.timed) + " cases: compare them with care";
}

std::string disturbing_text() { return rounded_text(100 * disturbing_share, 3) + " % of the machine"; }

int cores_of(const std::string& machine) {
  const std::size_t comma = machine.rfind(", ");
  const std::size_t end = machine.find(' ', comma == machine.npos ? 0 : comma + 2);
  if (comma == machine.npos || end == machine.npos) return 1;
  const auto cores = parse_integer(machine.substr(comma + 2, end - comma - 2)).value_or(1);
  return static_cast<int>(std::clamp<std::int64_t>(cores, 1, 1 << 20));
}

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
