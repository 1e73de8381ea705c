// SPDX-License-Identifier: BSD-3-Clause
// Passes on the particles alone: stress, body force, accounts.
#pragma once

#include "mpm/pass.hpp"

namespace assay::mpm {

/// b at the particles' reference positions or averaged over their reference domains, at the time at which the step
/// begins.
template <int Dim>
Pass<Dim> body_force_pass(Evaluation evaluation);

/// Of a frame that spins: turns b into it and adds the Coriolis and centrifugal terms.
template <int Dim>
Pass<Dim> moving_frame_pass(Evaluation evaluation);

/// F <- (I + dt L) F, then the material's update in batches; finds det F <= 0 and failed points.
template <int Dim>
Pass<Dim> stress_pass(bool with_history);

/// Impulse of the body force, work of the stress; mass on the grid against mass of the particles. Forces work with the
/// velocity that they leave; where velocities belong to the middles of steps, with the mean over the kick.
template <int Dim>
Pass<Dim> accounts_pass(const Method& method, bool with_body_force);

}  // namespace assay::mpm
