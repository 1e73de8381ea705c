// SPDX-License-Identifier: BSD-3-Clause
// Passes on the particles alone: stress and accounts.
#pragma once

#include "mpm/step/pass.hpp"

namespace assay::mpm {

/// F <- (I + dt L) F, then the material's update in batches; finds det F <= 0 and failed points.
template <int Dim>
Pass<Dim> stress_pass(bool with_history);

/// Impulse of the body force, work of the stress; mass on the grid against mass of the particles. Forces work with the
/// velocity that they leave; where velocities belong to the middles of steps, with the mean over the kick.
template <int Dim>
Pass<Dim> accounts_pass(const Method& method, bool with_body_force);

}  // namespace assay::mpm
