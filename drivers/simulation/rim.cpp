// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/rim.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drivers/output/number_format.hpp"

namespace assay::drivers {

namespace {

constexpr int scanned = 4096;  // radii; narrower zones are not seen

/// Where a zone ends between R0, which is in it as `inside` says, and R1, which is not.
template <typename Beyond>
double edge_between(double R0, double R1, bool inside, const Beyond& beyond) {
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (R0 + R1);
    (beyond(middle) == inside ? R0 : R1) = middle;
  }
  return 0.5 * (R0 + R1);
}

/// The time of the largest |g| in 0 .. end: at a reversal or at an end.
double time_of_peak(const Amplitude& amplitude, double end) {
  double peak = end;
  for (const double t : amplitude.reversals(end)) {
    if (std::abs(amplitude.at(t).value) > std::abs(amplitude.at(peak).value)) peak = t;
  }
  return peak;
}

}  // namespace

std::vector<Interval> zones_beyond(const Vortex& vortex, std::span<const double> fronts) {
  Interval first{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const double front : fronts) {
    if (front < 0) first.lower = std::max(first.lower, front);
    if (front > 0) first.upper = std::min(first.upper, front);
  }
  const auto beyond = [&](double R) {
    const double xi = vortex.profile(R).xi;
    return xi < first.lower || xi > first.upper;
  };
  std::vector<Interval> zones;
  double R0 = vortex.inner;  // xi = 0: in the first regime, as at the outer edge
  for (int i = 1; i <= scanned; ++i) {
    const double R1 = vortex.inner + (vortex.outer - vortex.inner) * i / scanned;
    if (beyond(R0) != beyond(R1)) {
      const double edge = edge_between(R0, R1, beyond(R0), beyond);
      if (beyond(R1)) {
        zones.push_back({edge, edge});
      } else {
        zones.back().upper = edge;
      }
    }
    R0 = R1;
  }
  return zones;
}

std::optional<RimFigures> rim_of(const Response& response, const Vortex& vortex, double h, double end) {
  const Sheet* sheet = response.sheet();
  if (!sheet || !sheet->has_kinks()) return std::nullopt;
  const std::vector<double> fronts = sheet->slice(time_of_peak(vortex.amplitude, end)).kinks();
  RimFigures rim{std::numeric_limits<double>::infinity(), 0};
  for (const Interval& zone : zones_beyond(vortex, fronts)) rim.width = std::min(rim.width, zone.upper - zone.lower);
  if (!std::isfinite(rim.width)) return std::nullopt;
  rim.cells = rim.width / h;
  return rim;
}

std::string narrow_rim_sentence(const RimFigures& rim) {
  if (rim.cells >= fewest_rim_cells) return {};
  return "the plastic rim is " + rounded_text(rim.width, 3) + " m wide, " + rounded_text(rim.cells, 2) +
         " cells: below 2 the grid does not see it; take a smaller grid.spacing";
}

}  // namespace assay::drivers
