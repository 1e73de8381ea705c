// SPDX-License-Identifier: BSD-3-Clause
// Stiffness at rest by small probes, and what of it relaxes: the part that is there in short steps alone.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "harness/check/march.hpp"

namespace assay::check {

/// d sigma / d eps at rest [Pa], rows and columns 11, 22, 33, 12, 13, 23; shear columns for the tensor component.
using Stiffness = Eigen::Matrix<double, 6, 6>;

struct Probed {
  Stiffness stiffness;
  bool linear;   ///< the response to small strains is
  double noise;  ///< the largest change of a component in a probe of half the size [Pa]
};

/// Under a pressure [Pa] by single steps of that length [s]. Throws MaterialFailure.
Probed probed(const Material& material, double pressure, double length);

/// A stiffness that steps of length `brief` [s] meet and steps of length `longer` do not: of an overstress, or of
/// viscosity.
struct RelaxingPart {
  Stiffness stiffness;
  double brief, longer;
  double noise;  ///< as of the whole [Pa]
};

/// The linear ones between 1e-9 and 1e6 s, and what is left then (`longer` infinite); none where the material fails.
/// modulus: of the material [Pa], beside which a part is significant.
std::vector<RelaxingPart> relaxing_parts(const Material& material, double pressure, double modulus);

/// sigma of a small strain sym(H) [Pa].
Tensor stress_of(const Stiffness& stiffness, const Tensor& H);

}  // namespace assay::check
