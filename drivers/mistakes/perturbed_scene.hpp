// SPDX-License-Identifier: BSD-3-Clause
// The perturbed problem of a scene.
#pragma once

#include "drivers/mistakes/identification.hpp"
#include "drivers/scene/scene.hpp"

namespace assay::drivers {

/// Why mistakes of a code are not looked for in that scene, as the rest of a sentence; empty: they are.
std::string why_no_mistakes(const Scene& scene);

/// Until `end`. Throws MaterialFailure, InputError.
PerturbedProblem perturbed_problem(const Scene& scene, const std::shared_ptr<const Material>& material, double end);

/// At these times. errors: of the body around a ring, whether it is there and moves. A ring without it may be held at
/// its faces or not: then there are two.
PerturbedMotions perturbed_motions(const Scene& scene, const PerturbedProblem& problem, const BinnedErrors& errors,
                                   const std::vector<double>& times);

/// The error of a right code of linear elements with edges h: root of the mean square over the times and bins [m].
double error_of_grid(const Scene& scene, const PerturbedProblem& problem, const BinnedErrors& errors, double h);

/// The bins of a scene's body.
BinnedErrors bins_of(const Scene& scene);

}  // namespace assay::drivers
