// SPDX-License-Identifier: BSD-3-Clause
// Whether one baseline tells the response of a whole body that moves about an axis. Its material points are sheared
// along axes that differ from point to point, so that the material must answer the same however the experiment is
// turned.
#pragma once

#include <optional>
#include <string>

#include "harness/material/material.hpp"
#include "harness/motion/path.hpp"

namespace assay::check {

/// Of a stress relative to the largest of the baseline: increments of a model that is isotropic agree to rounding,
/// those of single precision to 2e-5. An anisotropy that is smaller than this is beside the errors of particle methods.
inline constexpr double isotropic_within = 1e-4;

/// How far the answer depends on the orientation of the reference axes.
struct TurnedReference {
  double difference = 0;            ///< the largest of a component, over the largest stress of the baseline; INFINITY
                                    ///< where the material takes the baseline, and refuses it in another orientation
  Vector3 axis = Vector3::UnitX();  ///< about which the experiment was turned where that was found
  double angle = 0;                 ///< by which [rad]
  std::string component = {};       ///< in the axes of the baseline: "s12"
  bool falls = false;               ///< with shorter increments: the tolerance of an integrator, and no anisotropy

  bool is_isotropic() const { return falls || difference <= isotropic_within; }
};

/// Takes the material from rest to `end` [s] along the baseline of the largest |xi|, and along the same one turned as a
/// whole, F' = R F R^T, with the material's direction, as a host fills it in, in as many increments. In three
/// orientations, those of a material of the plane 12 about its normal. Nothing where the material takes no increments
/// of that length: its histories then tell why. Throws as initial_state does, and MaterialFailure where it is final.
std::optional<TurnedReference> turned_reference(const Material& material, const Path& path, double end);

/// Why the baseline does not tell the response of a body that moves about an axis, in one sentence: the material is not
/// isotropic beside its direction (of several, a host turns the first alone with the body), or its direction is along
/// no axis of the baseline. Nothing where it does.
std::optional<std::string> reason_against_axis(const Material& material, const Path& path, double end);

}  // namespace assay::check
