// SPDX-License-Identifier: BSD-3-Clause
// What a material's own increments err by along a controlled history, and what they cost.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "harness/control/controlled_history.hpp"

namespace assay {

struct IncrementError {
  int increments = 0;       ///< between two knots
  double stress = 0;        ///< largest difference at a knot to the solution of the equations, over the largest stress
  double deformation = 0;   ///< of the controlled deformation, over its largest change
  std::int64_t calls = 0;   ///< points updated
  double call_seconds = 0;  ///< of one call, with what the solver does between them [s]
  ControlOutcome outcome = ControlOutcome::completed;
};

/// For each number of increments. Throws as follow_control; std::runtime_error where the solution itself does not reach
/// the end.
std::vector<IncrementError> increment_errors(const Material& material, const Control& control,
                                             std::span<const int> increments,
                                             const std::function<void(double share)>& progress = {});

/// Errors of one increment of strain, over the plane of two principal strains: face 3 is free of stress.
struct IsoErrorChoice {
  double e11 = 0, e22 = 0;  ///< logarithmic strains at which the increment begins [1]
  double unit = 1e-3;       ///< of the axes, as the strain of first yield [1]
  double reach = 6;         ///< both increments go from 0 to this many units
  int points = 25;          ///< in each direction
};
struct IsoErrorMap {
  std::vector<double> units;   ///< of both increments, ascending
  std::vector<double> errors;  ///< relative, of the stress; [i * points + j], i of e11; no number where a step failed
  double largest = 0, mean = 0;
  double order = 0;  ///< of the mean, from one increment to two and to four over the same strain
};
IsoErrorMap iso_errors(const Material& material, const IsoErrorChoice& choice,
                       const std::function<void(double share)>& progress = {});

}  // namespace assay
