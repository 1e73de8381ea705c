// SPDX-License-Identifier: BSD-3-Clause
// A step from F0 to F1 as interfaces of strain increments see it.
#pragma once

#include "adapters/foreign/foreign_model.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay::adapters {

struct StepStrain {
  Tensor strain;    ///< increment, symmetric [1]
  Tensor rotation;  ///< increment, proper orthogonal [1]
};

/// Strain and rotation of the step f = F1 F0^-1, in the axes of its end.
///   objective: f = V R, strain ln V, rotation R
///   abaqus:    l = (F1 - F0) ((F0 + F1) / 2)^-1, strain sym l, rotation (I - w/2)^-1 (I + w/2), w = skew l
StepStrain step_strain(const Tensor& F0, const Tensor& F1, Kinematics kinematics);

/// Of a frame that turns with the body: F = R U at both ends, strain of the step from U0 to U1 in that frame.
/// objective: mean of the left and the right logarithmic strain of U1 U0^-1, of second order; abaqus: sym (U1 - U0)
/// ((U0 + U1) / 2)^-1.
struct CorotationalStep {
  Tensor R0, R1, U0, U1;
  Tensor strain;  ///< increment [1]
  Tensor spin;    ///< increment of R: skew part of (R1 - R0) ((R0 + R1) / 2)^-1 [1]
};
CorotationalStep corotational_step(const Tensor& F0, const Tensor& F1, Kinematics kinematics);

/// ln U of F = R U, and R.
StepStrain logarithmic_strain_of(const Tensor& F);

/// Their rates along dF/dt = E.
StepStrain rate_of_logarithmic_strain(const Tensor& F, const Tensor& E);

/// Rates along dF1/dt = E of the strain of a step in the axes of its beginning, and of its rotation.
StepStrain rate_of_step(const Tensor& F0, const Tensor& F1, const Tensor& E, Kinematics kinematics);

/// The same of a corotational step: of its strain, which is in axes that turn, and of R1.
StepStrain rate_of_corotational_step(const Tensor& F0, const Tensor& F1, const Tensor& E, Kinematics kinematics);

}  // namespace assay::adapters
