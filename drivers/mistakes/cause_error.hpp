// SPDX-License-Identifier: BSD-3-Clause
// What a mistake of a code has to explain: the errors of its runs in the limit of fine grids.
#pragma once

#include <vector>

#include "drivers/mistakes/binned_errors.hpp"

namespace assay::drivers {

/// Fewer times are no history.
inline constexpr std::size_t least_frames = 3;

/// Errors of one run on a grid of spacing h [m], or of a ladder of them.
struct MeasuredErrors {
  double h = 0;
  BinnedErrors errors;
};

/// What is to be explained: the errors in the limit of fine grids, as far as the runs tell it.
struct CauseError {
  std::vector<double> t;                      ///< [s]
  std::vector<std::vector<Vector3>> e;        ///< [frame][bin]: mean [m]
  std::vector<double> square;                 ///< [frame]: mean square, of what is not a bin's mean too [m^2]
  std::vector<Vector3> X;                     ///< of each bin [m]
  std::vector<double> weight;                 ///< of each bin
  double error = 0;                           ///< root of the mean square over the frames [m]
  std::vector<std::vector<Vector3>> coarser;  ///< [frame][bin]: mean on the next coarser grid; of no others empty [m]
  double refined = 1;                         ///< its spacing over that of the finest
  double discretisation = 0;                  ///< what grids add to it, on the finest one [m]
  double motion = 0;                          ///< root of the mean square of the exact displacement [m]
  double falls = 0;      ///< error on the coarser grid over that on the finer one; 0: one grid alone
  double all_falls = 0;  ///< the same of the whole error, with what is not a bin's mean
  bool from_ladder = false;
};

/// Of the finest run with the next coarser ones. runs: the coarsest first.
CauseError cause_error_of(const std::vector<MeasuredErrors>& runs);

/// Whether the error does not fall as those of right codes do. False for one grid.
bool is_steady(const CauseError& error);

/// Whether the error is more than what grids make of a right code: else it is the method's own.
bool is_beyond_the_grid(const CauseError& error);

/// Whether the errors of all particles are about as large on a coarser grid, and not small.
bool stays(const CauseError& error);

}  // namespace assay::drivers
