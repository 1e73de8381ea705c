// SPDX-License-Identifier: BSD-3-Clause
// A model of plane stress (NTENS = 3) as one of F. It knows the deformation of the plane 12 alone; how thick the body
// becomes is the host's to say, as with the POISSON of Abaqus' shell and membrane sections:
//
//   F33 = J2^-k,  J2 = F11 F22 - F12 F21,  k = nu / (1 - nu),  ln F33 = -k (e11 + e22)
//
// A motion may have another F33, as that of a test which holds it. The first Piola-Kirchhoff stress is then the same:
// sigma = sigma_model J2^-k / F33 is the force per deformed area of the plane and per thickness of that motion, so
// that the work per reference volume does not depend on F33, and sigma33 = 0 is its derivative.
#pragma once

#include "adapters/foreign/foreign_model.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay::adapters {

/// k of ln F33 = -k (e11 + e22): 1 for an incompressible body, 0 for a constant thickness.
double thinning_of(const ForeignModel& model);

/// F with the thickness of the host.
Tensor with_thickness(const ForeignModel& model, const Tensor& F);

/// dF with that of the host along it, at an F that has it.
Tensor rate_with_thickness(const ForeignModel& model, const Tensor& F, const Tensor& E);

/// sigma / sigma_model at F; and d ln of it along dF = E.
double membrane_factor(const ForeignModel& model, const Tensor& F);
double membrane_factor_rate(const ForeignModel& model, const Tensor& F, const Tensor& E);

}  // namespace assay::adapters
