// SPDX-License-Identifier: BSD-3-Clause
// Passes of the body force.
#pragma once

#include "mpm/step/pass.hpp"

namespace assay::mpm {

/// b at the particles' reference positions or averaged over their reference domains, at the time at which the step
/// begins. is_acceleration: no stress is left in it.
template <int Dim>
Pass<Dim> body_force_pass(Evaluation evaluation, bool is_acceleration);

/// Of a frame that spins: turns b into it and adds the Coriolis and centrifugal terms.
template <int Dim>
Pass<Dim> moving_frame_pass(Evaluation evaluation);

}  // namespace assay::mpm
