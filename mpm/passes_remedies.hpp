// SPDX-License-Identifier: BSD-3-Clause
// Passes of the remedies that a scene calls for.
#pragma once

#include "mpm/pass.hpp"

namespace assay::mpm {

/// Before `stress`: J of each particle after the step.
template <int Dim>
Pass<Dim> volume_ratio_pass();

/// After it: J averaged over the cells or nodes around a particle, and the factor (J averaged / J)^(1/Dim) by which F
/// is scaled for the material, at both ends of the step.
template <int Dim>
Pass<Dim> average_volume_pass(const Method& method, AntiLocking over);

/// Before `weights`: half edges of the reference domain such that no corner of the deformed one is farther from its
/// particle than the setup's largest_domain; of domains whose corners move one by one, these corners.
template <int Dim>
Pass<Dim> limit_domains_pass(bool moves_corners);

/// Before the grid moves: of the force on nodes lighter than the setup's small_mass only their share of it is left.
template <int Dim>
Pass<Dim> small_mass_pass();

/// After `stress`: an isotropic pressure q where the volume shrinks.
template <int Dim>
Pass<Dim> viscosity_pass(const Method& method);

}  // namespace assay::mpm
