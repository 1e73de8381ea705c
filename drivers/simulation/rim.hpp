// SPDX-License-Identifier: BSD-3-Clause
// The plastic rim of a vortex: how many grid cells the narrowest zone has in which a material with kinks has left its
// first regime.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "drivers/result/result.hpp"
#include "harness/exact/response.hpp"
#include "harness/motion/kinds/vortex.hpp"

namespace assay::drivers {

constexpr double fewest_rim_cells = 2;

/// Rings of the vortex in which xi(R) lies beyond the fronts next to xi = 0: [r, R] [m], ascending. Fronts further out
/// do not cut them: a sheet has one wherever histories of other times part. fronts: values of xi other than 0.
std::vector<Interval> zones_beyond(const Vortex& vortex, std::span<const double> fronts);

/// The narrowest zone at the time of the largest |g| in 0 .. end, for a grid of spacing h [m]. Absent without a sheet,
/// without kinks, and where no zone has left the first regime.
std::optional<RimFigures> rim_of(const Response& response, const Vortex& vortex, double h, double end);

/// "the plastic rim is .. m wide, .. cells: .."; empty where it has fewest_rim_cells or more.
std::string narrow_rim_sentence(const RimFigures& rim);

}  // namespace assay::drivers
