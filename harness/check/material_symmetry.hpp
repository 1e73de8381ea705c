// SPDX-License-Identifier: BSD-3-Clause
// The tests of a material that declares a class of symmetry (assay.symmetry/1): about some axes, which are found, it
// answers as the class says.
#pragma once

#include "harness/check/specimen.hpp"
#include "harness/check/symmetry_class.hpp"

namespace assay::check {

/// A finding about the stiffness at rest.
struct ClassFinding {
  TestResult result;
  std::vector<ClassFit> axes = {};  ///< of the class declared, that suit the stiffness best
  bool fits_no_class = false;       ///< at all
};

/// The stiffness at rest is of the class declared. Fails with `shear_factor` or `components_swapped` where that alone
/// keeps it from being so.
ClassFinding class_at_rest(const Specimen& specimen);

/// The stiffness at rest of what declares a class is symmetric: C = C^T. Without that a cycle of small strains brings
/// work out of nothing.
TestResult major_symmetry(const Specimen& specimen);

/// Body and frame turned by the rotations of the class: F' = Q F Q^T, sigma' = Q sigma Q^T along the loading. at_rest:
/// axes that suit the stiffness at rest; empty where they are not known.
TestResult class_in_loading(const Specimen& specimen, std::vector<ClassFit> at_rest);

/// Whether the ring of a vortex may be of the material: its response is the same all around the axis E3, in its own
/// axes where these turn with the radius. It declares so, or declares transverse isotropy and is that at rest about E3.
bool serves_ring(const Material& material);

}  // namespace assay::check
