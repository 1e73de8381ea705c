// SPDX-License-Identifier: BSD-3-Clause
// What a motion knows of a material point at a time.
#pragma once

#include "harness/numeric/tensor.hpp"

namespace assay {

struct ExactState {
  Vector3 x = Vector3::Zero();     ///< position [m]
  Vector3 v = Vector3::Zero();     ///< velocity [m/s]
  Vector3 a = Vector3::Zero();     ///< acceleration [m/s^2]
  Tensor F = Tensor::Identity();   ///< deformation gradient d x / d X [1]
  Tensor F_rate = Tensor::Zero();  ///< its rate d v / d X [1/s]
};

/// What the material's response adds to it.
struct ExactStress {
  Tensor first_piola_kirchhoff = Tensor::Zero();  ///< T of the paper [Pa]
  Tensor cauchy = Tensor::Zero();                 ///< [Pa]
  Vector3 body_force = Vector3::Zero();           ///< b per mass (1), a + static_force [m/s^2]
  Vector3 static_force = Vector3::Zero();         ///< -DIV(T)/rho0: b without inertia [m/s^2]
};

}  // namespace assay
