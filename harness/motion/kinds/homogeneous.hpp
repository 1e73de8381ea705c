// SPDX-License-Identifier: BSD-3-Clause
// Homogeneous deformation, section 3 of the paper: F = I (1 - t/T) + final t/T.
#pragma once

#include "harness/motion/motion_kind.hpp"

namespace assay {

struct Homogeneous {
  Tensor final = Tensor::Identity();  ///< F at t = T [1]
  double period = 1;                  ///< T [s]

  /// x = F X (37), v = Fdot X, a = 0.
  ExactState at(const Vector3& X, double t) const;

  /// The baseline with parameter xi. Uniaxial strain (38): D = E1 E1, xi = Lambda - 1 on the scene's own path; any
  /// other final F: D = final - I, xi = 1 on the scene's own path.
  Path baseline() const;

  /// The parameter of the scene's own path.
  double own_parameter() const;
};

void fields(auto& archive, Homogeneous& m) { archive(m.final, m.period); }

std::unique_ptr<MotionKind> kind_of(const Homogeneous& motion);

}  // namespace assay
