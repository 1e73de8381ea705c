// SPDX-License-Identifier: BSD-3-Clause
// The acoustic tensor of a tangent modulus, and its extremes over all directions.
#pragma once

#include "harness/stability/tangent_modulus.hpp"

namespace assay {

/// Smallest or largest eigenvalue of sym(N.A.N), (N.A.N)_ik = A_iJkL N_J N_L, over all unit vectors N.
struct AcousticExtreme {
  double value = 0;                  ///< [Pa]
  Vector3 normal = Vector3::Zero();  ///< N, in the reference configuration
};
AcousticExtreme smallest_acoustic_eigenvalue(const TangentModulus& A);
AcousticExtreme largest_acoustic_eigenvalue(const TangentModulus& A);

}  // namespace assay
