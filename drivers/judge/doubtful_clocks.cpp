// SPDX-License-Identifier: BSD-3-Clause
// Which clocks are wrong, and which methods run late by themselves.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "drivers/judge/changes.hpp"

namespace assay::drivers {

namespace {

constexpr double pure = 20;  ///< so many times smaller is the error that a wrong clock alone leaves

const Label* of_cause(const std::vector<Label>& labels, const std::string& cause) {
  const auto found = std::ranges::find(labels, cause, &Label::cause);
  return found == labels.end() ? nullptr : &*found;
}

/// Why the label of a grid without finer or coarser ones is no more than a doubt; empty where it is sure.
std::string doubt_of_one(const Label& label) {
  const bool sure = label.cause == clock_offset || (label.cause == clock_rate && label.after * pure < label.before);
  return sure ? "" : ". One grid cannot tell that from a method that is late by itself: give a finer grid";
}

/// Of two grids. ratio: of their spacings, below 1.
std::string doubt_of_two(const Label& coarse, const Label& fine, double ratio) {
  const double half_an_order = std::sqrt(ratio);
  if (!(std::abs(*fine.lateness) > half_an_order * std::abs(*coarse.lateness)))
    return ", and less on finer grids: a clock stays as it is, a method that is late by itself gets better";
  if (fine.cause == velocity_time) return "";
  const bool explains = fine.after < half_an_order * coarse.after || fine.after * pure < fine.before;
  if (!explains) return ". What that leaves does not fall on finer grids: it is no clock alone";
  if (fine.by_velocities == false) return ". The velocities are not those of such a clock: the body itself is late";
  return "";
}

}  // namespace

std::vector<DoubtfulClock> doubtful_clocks(const std::vector<std::vector<Label>>& labels,
                                           const std::vector<double>& spacing) {
  std::vector<std::size_t> order(labels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t k) { return spacing[k]; });
  std::vector<DoubtfulClock> doubtful;
  for (const char* cause : {clock_rate, clock_offset, velocity_time}) {
    const Label *fine = nullptr, *coarse = nullptr;
    std::size_t fine_at = 0, coarse_at = 0;
    for (const std::size_t k : order) {
      constexpr double same_grid = 0.9;  // too near to tell an order
      const Label* here = of_cause(labels[k], cause);
      if (!here) continue;
      if (fine && spacing[k] < same_grid * spacing[fine_at]) coarse = fine, coarse_at = fine_at;
      fine = here, fine_at = k;
    }
    if (!fine) continue;
    const bool finest = spacing[fine_at] < 1.1 * spacing[order.back()];
    const std::string doubt = !finest  ? ", and not so on finer grids: a clock stays as it is"
                              : coarse ? doubt_of_two(*coarse, *fine, spacing[fine_at] / spacing[coarse_at])
                                       : doubt_of_one(*fine);
    if (!doubt.empty()) doubtful.push_back({cause, "it seems that " + fine->sentence + doubt});
  }
  return doubtful;
}

}  // namespace assay::drivers
