// SPDX-License-Identifier: BSD-3-Clause
// The errors of another code's particles against the exact motion, by the norms of a run.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/judge/pairing.hpp"
#include "drivers/mistakes/binned_errors.hpp"
#include "drivers/picture/value_pictures.hpp"
#include "drivers/result/result_sections.hpp"

namespace assay::drivers {

struct FrameErrors {
  std::string name;
  ErrorSample sample;
  FramePairs pairs;
  std::size_t measured = 0;                                       ///< pairs that the exact motion moves
  double exact_displacement = 0;                                  ///< its L2 norm [m]
  double exact_velocity = 0, exact_strain = 0, exact_stress = 0;  ///< of v [m/s], F - I [1] and sigma [Pa]
  double velocity = 0;                                            ///< L2 norm of what is written [m/s]; 0 where none is
  double worst = 0;                                               ///< largest error of a position [m]
  std::optional<double> worst_id;  ///< of that particle; its number from 0 where there are no ids
  Vector3 worst_X = Vector3::Zero();
};

/// Of each frame. Where a field is not written, its error is NaN.
/// bins: where they are not null, they take the errors of the positions.
std::vector<FrameErrors> errors_of(const JudgedRun& run, const Seeds& seeds, Pairing pairing, ExactParticles& exact,
                                   BinnedErrors* bins = nullptr);

/// The plane particles of a frame, coloured by the errors of their positions; those of a frame that is empty are none.
ParticleFrame picture_of(const JudgedFrame& frame, const Seeds& seeds, Pairing pairing, ExactParticles& exact);

/// A PNG file of at least one particle.
std::string png_of(const ParticleFrame& frame);

/// Roots of mean squares over all frames [m].
struct PositionError {
  double error = std::numeric_limits<double>::infinity(), displacement = 0;  ///< of the exact motion
  double worst = error;                                                      ///< of one particle
  /// What labels compare, for a smaller unit makes both smaller.
  double relative() const { return displacement > 0 ? error / displacement : std::numeric_limits<double>::infinity(); }
};

/// Of all pairs; infinite where there are none.
PositionError position_error(const JudgedRun& run, const Seeds& seeds, Pairing pairing, ExactParticles& exact);

}  // namespace assay::drivers
