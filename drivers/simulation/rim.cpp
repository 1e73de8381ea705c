// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/rim.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drivers/text/numbers.hpp"
#include "harness/motion/kinds/vortex.hpp"

namespace assay::drivers {

namespace {

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
  std::vector<double> edges{vortex.inner};
  const RadiiOfXi radii_of_xi(vortex);
  for (const double front : {first.lower, first.upper}) {
    for (const double R : radii_of_xi(front)) edges.push_back(R);
  }
  edges.push_back(vortex.outer);
  std::sort(edges.begin(), edges.end());
  std::vector<Interval> zones;
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
    const double xi = vortex.profile(0.5 * (edges[k] + edges[k + 1])).xi;
    if (xi < first.lower || xi > first.upper) zones.push_back({edges[k], edges[k + 1]});
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
         " cells: the grid does not resolve less than 2 cells; take a smaller grid.spacing";
}

}  // namespace assay::drivers
