// SPDX-License-Identifier: BSD-3-Clause
// Passes of the remedies that a scene calls for.
#pragma once

#include "mpm/step/effect.hpp"

namespace assay::mpm {

/// Before `stress`: volumes of each particle, of which the ratio is averaged. In the updated formulation that of the
/// step, det(I + dt L); in the total one J.
template <int Dim>
Pass<Dim> step_volumes_pass();

/// After it: the ratio averaged over the cells or nodes around a particle, and the factor (averaged / own)^(1/Dim) of
/// F. In the updated formulation F keeps it: what F has of volume is then never a particle's own. In the total one F
/// stays the gradient of the motion, and the material alone sees it scaled.
template <int Dim>
Pass<Dim> average_volume_pass(const Method& method, AntiLocking over);

/// Before `weights`: half edges of the reference domain such that no corner of the deformed one is farther from its
/// particle than the setup's largest_domain; of domains whose corners move one by one, these corners.
template <int Dim>
Pass<Dim> limit_domains_pass(bool moves_corners);
template <>
Pass<2> limit_domains_pass<2>(bool moves_corners);

/// Before the grid moves: of the force on nodes lighter than the setup's small_mass only their share of it is left.
template <int Dim>
Pass<Dim> small_mass_pass();

/// After `stress`: an isotropic pressure q where the volume shrinks.
template <int Dim>
Pass<Dim> viscosity_pass(const Method& method);

}  // namespace assay::mpm
