// SPDX-License-Identifier: BSD-3-Clause
// The optional effects by name, and which of them this build has. What each is, the scene key that calls for it and
// what it brings is one list: drivers/effects.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace assay::mpm {

/// Passes, columns and grid fields of no effect are the spine's.
enum class Effect {
  // of a step
  body_force,
  averaging,
  moving_frame,
  inertia_to_particles,
  edge_traction,
  virtual_stress,
  particle_traction,
  undeformed_traction,
  images,
  outside_held,
  history,
  material_direction,
  affine_velocity,
  convected_corners,
  own_domains,
  mass_matrix,
  velocity_terms,
  force_stages,
  stress_first,
  remapped_velocity,
  anti_locking,
  largest_domain,
  small_mass,
  artificial_viscosity,
  energy_account,
  third_dimension,
  // of a run, around its steps
  time_control,
  screening,
  error_sampling,
  shadow,
  isolation,
  snapshots,
  pictures,
  report,
  traction_table,
};
inline constexpr std::size_t effect_count = static_cast<std::size_t>(Effect::traction_table) + 1;

/// What the plain vortex takes, which a build with ASSAY_EFFECTS=spine keeps.
inline constexpr std::array spine_effects{Effect::body_force, Effect::screening, Effect::error_sampling};

#ifdef ASSAY_SPINE
inline constexpr bool spine_only = true;
#else
inline constexpr bool spine_only = false;
#endif

/// Whether this build has the effect: `if constexpr (compiled(...))` around what calls for its code leaves that out.
constexpr bool compiled(Effect effect) {
  return !spine_only || std::find(spine_effects.begin(), spine_effects.end(), effect) != spine_effects.end();
}

}  // namespace assay::mpm
