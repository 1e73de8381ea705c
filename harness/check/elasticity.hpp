// SPDX-License-Identifier: BSD-3-Clause
// What the stiffness at rest tells of a material that says it is isotropic.
#pragma once

#include <string>
#include <vector>

#include "harness/check/specimen.hpp"

namespace assay::check {

/// A stiffness at rest: the whole one, or that of a part that relaxes.
struct StiffnessOf {
  Stiffness C;
  std::string of;     ///< " at rest", or of which steps
  double noise;       ///< what the size of the probes changes in it [Pa]
  bool is_of_a_part;  ///< that relaxes, and not of all that resists
  bool is_left;       ///< in the longest steps
};

/// Those of a material whose response to small strains from rest is linear, the whole one last.
std::vector<StiffnessOf> linear_stiffnesses(const Specimen& specimen);

/// Shears couple to their own stress alone: 13 to 13, 23 to 23. Fails with the cause of an order
/// where they lie in another one.
TestResult shear_components(const Specimen& specimen);

/// The shear modulus follows from the axial stiffness: sigma_12 = (C11 - C12) eps_12. Fails with `shear_factor` where
/// it is twice or half that.
TestResult shear_modulus(const Specimen& specimen);

}  // namespace assay::check
