// SPDX-License-Identifier: BSD-3-Clause
// Of assay.h: cells, and the means of b over them.
#include <algorithm>
#include <array>
#include <cmath>

#include "drivers/library/exact_problem.hpp"
#include "drivers/library/fields.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/exact/hexahedra.hpp"

struct assay_cells {
  assay::drivers::HandleMark mark = assay::drivers::HandleMark::cells;
  std::shared_ptr<const assay::drivers::ExactProblem> problem;
  assay::HexahedronAverage average;
  std::size_t count;
};

namespace assay::drivers {

namespace {

using Corners = std::array<Vector3, 8>;

/// In the plane 1 m thick, and nothing changes across it.
Corners corners_of(const double* corners, int dimension) {
  Corners found;
  for (std::size_t k = 0; k < 8; ++k) {
    if (dimension == 3) {
      found[k] = {corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]};
    } else {
      const double* at = corners + 2 * (k % 4);
      found[k] = {at[0], at[1], k < 4 ? -0.5 : 0.5};
    }
  }
  return found;
}

[[noreturn]] void refuse_cell(std::size_t cell, const std::string& what) {
  throw RefusedCall("corners", what, ASSAY_BAD_INPUT, static_cast<std::int64_t>(cell));
}

/// Two Gauss points along an edge of a cell that is small against the motion, which leave some 1e-4 of the largest b.
HexahedronRule rule_for(const ExactProblem& problem) {
  constexpr double small = 1.0 / 16;  // half edge, of the motion's length
  HexahedronRule rule;
  rule.quasi_static = problem.is_quasi_static();
  rule.reach = small * problem.solution().motion()->length();
  rule.directions = problem.dimension();
  return rule;
}

/// Throws RefusedCall where b cannot be a difference of what acts on two faces, or the cell is large against the
/// motion.
void require_cells(const std::vector<Corners>& cells, const ExactProblem& problem, const HexahedronRule& rule) {
  constexpr double least = 1e-6;  // of the motion's length, and of the place
  constexpr int most = 24;        // Gauss points
  const double length = problem.solution().motion()->length();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const HalfEdges half(cells[i], problem.dimension());
    double far = 0;
    for (const Vector3& corner : cells[i]) {
      far = std::max({far, std::abs(corner.x()), std::abs(corner.y())});
      if (problem.dimension() == 3) far = std::max(far, std::abs(corner.z()));
    }
    const double bound = least * std::max(std::isinf(length) ? 0 : length, far);
    if (!(half.shortest >= bound && half.shortest > 0))
      refuse_cell(i, "half edges must be at least " + rounded_text(bound, 2) + " m here, found " +
                         rounded_text(half.shortest, 3));
    if (half.longest > (most - rule.gauss + 1) * rule.reach)
      refuse_cell(i, "the cell is too large for a mean: divide it into cells whose edges are not many times " +
                         rounded_text(length, 3) + " m, over which the motion changes");
  }
}

}  // namespace

extern "C" {

ASSAY_API int assay_cells_open(const assay_problem* problem, size_t n, const double* corners, assay_cells** cells,
                               assay_error* error) {
  if (cells) *cells = nullptr;
  return call_of_library(error, [&] {
    refuse_call_if(!cells, "cells", "must not be null");
    const auto& shared = known_handle(problem, HandleMark::problem, "problem").shared;
    refuse_call_if(n > 0 && !corners, "corners", "must not be null");
    refuse_call_if(n > (size_t{1} << 31), "n", "there are too many cells");
    const int dimension = shared->dimension();
    const auto numbers = static_cast<std::size_t>(dimension == 3 ? 24 : 8);
    std::vector<Corners> all(n);
    for (std::size_t i = 0; i < n; ++i) {
      all[i] = corners_of(corners + i * numbers, dimension);
      for (const Vector3& corner : all[i]) {
        if (!corner.allFinite()) refuse_cell(i, "must be numbers");
        if (!shared->holds(corner)) refuse_cell(i, "a corner lies where the motion is not defined");
      }
    }
    const HexahedronRule rule = rule_for(*shared);
    require_cells(all, *shared, rule);
    HexahedronAverage average(Hexahedra(all), shared->density(), rule);
    for (std::size_t i = 0; i < n; ++i) {
      if (!(average.volume(i) > 0)) refuse_cell(i, "its corners make no volume above 0: they are in another order");
    }
    *cells = new assay_cells{HandleMark::cells, shared, std::move(average), n};
    return ASSAY_DONE;
  });
}

ASSAY_API void assay_cells_close(assay_cells* cells) { close_handle(cells, HandleMark::cells); }

ASSAY_API int assay_cells_eval(const assay_cells* cells, double t, const assay_field* b, double* volume,
                               assay_error* error) {
  return call_of_library(error, [&] {
    const assay_cells& known = known_handle(cells, HandleMark::cells, "cells");
    if (b) check_strides(*b, known.count, "b");
    const auto slice = known.problem->slice(t);
    if (b && b->data) {
      const std::vector<DomainForce> forces = known.average.at(*slice);
      for (std::size_t i = 0; i < known.count; ++i) put_vector(*b, i, forces[i].b, known.problem->dimension());
    }
    for (std::size_t i = 0; volume && i < known.count; ++i) volume[i] = known.average.volume(i);
    return ASSAY_DONE;
  });
}

}  // extern "C"

}  // namespace assay::drivers
