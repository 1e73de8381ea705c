// SPDX-License-Identifier: BSD-3-Clause
// The optional abilities that sheets and time steps are made from, against the stress of `update`.
#pragma once

#include "harness/check/specimen.hpp"

namespace assay::check {

/// assay.rate/1: the rates of stress and state that steps approach as they become short.
TestResult rate_form(const Specimen& specimen);

/// assay.wave_speed/1, against the acoustic tensor of probed steps: one too low makes explicit runs unstable. Only of
/// what does not depend on the rate, whose steps are stiffer the shorter they are.
TestResult wave_speed(const Specimen& specimen);

/// assay.closed_form/1: tau and d tau / d eps along simple shear (16) and uniaxial strain (38).
TestResult closed_form(const Specimen& specimen);

}  // namespace assay::check
