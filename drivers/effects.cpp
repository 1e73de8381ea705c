// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/effects.hpp"

#include "adapters/worker/remote_table.hpp"
#include "mpm/setup/with_basis.hpp"

namespace assay::drivers {

namespace {

using mpm::Column;
using mpm::Effect;

bool has_traction(const Problem& problem, mpm::TractionAlgorithm algorithm) {
  return problem.setup.traction && problem.setup.traction->algorithm == algorithm;
}

const mpm::Method& method_of(const Problem& problem) { return problem.setup.method; }

bool has_own_domains(const Problem& problem) {
  const bool differ = !problem.setup.seeds.half_edges.empty() || problem.setup.remedies.largest_domain > 0;
  return differ && mpm::traits_of<2>(method_of(problem).basis).domain_components > 0;
}

bool has_velocity_terms(const Problem& problem) {
  const mpm::Transfer transfer = method_of(problem).transfer;
  return transfer == mpm::Transfer::xpic || transfer == mpm::Transfer::fmpm;
}

#define IF(expression) [](const Problem& p) -> bool { return expression; }

// clang-format off
std::vector<EffectEntry> of_forces() {
  using enum mpm::TractionAlgorithm;
  return {
      {Effect::body_force, "body_force", "the body force b of the exact motion acts on the particles", "force.response",
       IF(p.setup.body_force), {"body_force"}, {Column::body_force}, {}, false, "the response from which b is computed"},
      {Effect::averaging, "averaging", "b is the mean over each particle's reference domain", "force.evaluation",
       IF(p.setup.averages_force()), {"body_force"}, {}, {}, false, "the domains, cut at the ring's edges"},
      {Effect::moving_frame, "moving_frame", "Coriolis and centrifugal terms of a frame that spins", "frame.spin",
       IF(p.setup.body_force && p.setup.frame && p.setup.frame->spin != 0), {"moving_frame"}, {}, {}, false, {}},
      {Effect::inertia_to_particles, "inertia_to_particles", "particles get the acceleration of the exact motion",
       "force.inertia", IF(p.setup.body_force && p.setup.inertia == mpm::Inertia::particles),
       {"inertia_to_particles"}, {}, {}, false, {}},
      {Effect::edge_traction, "edge_traction", "tractions by the corners of the domains on the surface",
       "traction.algorithm", IF(has_traction(p, edges)), {"traction", "traction_work"}, {}, {}, true,
       "loads of the surface"},
      {Effect::virtual_stress, "virtual_stress", "tractions as the exact stress, continued beyond the surface",
       "traction.algorithm", IF(has_traction(p, virtual_stress)), {"virtual_stress", "inertia_to_particles"},
       {Column::excess_stress}, {}, true, {}},
      {Effect::particle_traction, "particle_traction", "tractions at the particles of the surface",
       "traction.algorithm", IF(has_traction(p, particles)), {"traction", "traction_work"}, {}, {}, true,
       "loads of the surface"},
      {Effect::undeformed_traction, "undeformed_traction", "tractions by the undeformed length of the edges",
       "traction.algorithm", IF(has_traction(p, undeformed_edges)), {"traction", "traction_work"}, {}, {}, true,
       "loads of the surface"},
      {Effect::images, "images", "symmetry planes and periodic ends", "body", IF(p.setup.has_images()),
       {"fold_images", "unfold_images"}, {}, {}, false, "pairs of nodes"},
      {Effect::outside_held, "outside_held", "nodes and particles outside the ring are fixed", "body.outside",
       IF(p.setup.hold_outside), {"hold_nodes"}, {}, {"held_mass"}, false, {}},
  };
}

std::vector<EffectEntry> of_particles() {
  return {
      {Effect::history, "history", "state variables of the material", "material.adapter",
       IF(p.material->state_size() > 0), {}, {Column::history}, {}, false, {}},
      {Effect::material_direction, "material_direction", "each particle's material has a direction of its own",
       "material.adapter", IF(has_direction(p.material->table())), {}, {}, {}, false,
       "directions at rest, in the history"},
      {Effect::affine_velocity, "affine_velocity", "particles carry the velocity around them", "method.transfer",
       IF(method_of(p).is_affine()), {"affine", "first_affine_moment"}, {Column::affine}, {}, false, {}},
      {Effect::convected_corners, "convected_corners", "corners of the domains move one by one", "method.basis",
       IF(mpm::traits_of<2>(method_of(p).basis).moves_corners), {}, {Column::corners}, {}, false, {}},
      {Effect::own_domains, "own_domains", "particles' domains differ, by their lattice or as they are shortened",
       "body.lattice", IF(has_own_domains(p)), {}, {Column::domain}, {}, false, {},
       [](const Problem& p) -> std::string {
         return p.setup.seeds.half_edges.empty() ? "remedies.largest_domain" : "body.lattice";
       }},
      {Effect::mass_matrix, "mass_matrix", "consistent mass, or a series of its inverse", "method.mass",
       IF(method_of(p).mass != mpm::Mass::lumped), {"grid_update"}, {}, {"solver", "inverse_mass", "mass_stencil"},
       false, {}},
      {Effect::velocity_terms, "velocity_terms", "terms of the mass matrix in the velocity, as XPIC and FMPM have",
       "method.transfer", IF(has_velocity_terms(p)), {"grid_update"}, {},
       {"solver", "inverse_mass", "mass_stencil"},
       false, {}},
      {Effect::force_stages, "force_stages", "several evaluations of the forces in a step", "method.integrator",
       IF(method_of(p).has_stages()), {"grid_update", "grid_forces"}, {}, {"solver", "inverse_mass", "mass_stencil"},
       false, {}},
      {Effect::stress_first, "stress_first", "the stress is updated before the forces", "method.update",
       IF(method_of(p).update == mpm::Update::usf), {"grid_velocity", "velocity_gradient", "grid_forces"}, {}, {},
       false, {}},
      {Effect::remapped_velocity, "remapped_velocity", "L comes from the updated velocities of the particles",
       "method.update", IF(method_of(p).update == mpm::Update::musl),
       {"particles_to_grid_again", "grid_velocity", "velocity_gradient"}, {}, {}, false, {}},
      {Effect::anti_locking, "anti_locking", "the stress is computed with J averaged over cells or nodes",
       "remedies.anti_locking", IF(p.setup.remedies.averages_volume()), {"step_volumes", "average_volume"},
       {Column::step_volumes, Column::volume_scale}, {"cell_volume"}, false, {}},
      {Effect::largest_domain, "largest_domain", "domains that reach too far are shortened", "remedies.largest_domain",
       IF(p.setup.remedies.largest_domain > 0), {"limit_domains"}, {}, {}, false, "domains that differ, of cpdi"},
      {Effect::small_mass, "small_mass", "light nodes take up force in proportion to their mass",
       "remedies.small_mass", IF(p.setup.remedies.small_mass > 0), {"small_mass"}, {}, {}, false, {}},
      {Effect::artificial_viscosity, "artificial_viscosity", "a viscous pressure in compression",
       "remedies.artificial_viscosity", IF(p.setup.remedies.has_viscosity()), {"artificial_viscosity"}, {}, {}, false,
       {}},
      {Effect::energy_account, "energy_account", "accounts of mass, momentum and energy", "output.accounts",
       IF(p.setup.accounts), {"accounts", "traction_work"}, {}, {}, false,
       "sums over the particles, and checks of them"},
      {Effect::third_dimension, "third_dimension", "particles in space; scenes are plane strain", "",
       IF(p.setup.seeds.X.size() > 2), {}, {}, {}, false, {}},
  };
}

std::vector<EffectEntry> of_runs() {
  return {
      {Effect::time_control, "time_control", "steps from the present fastest wave and fastest particle", "time.control",
       IF(p.scene.time.control == TimeChoice::Control::current), {}, {}, {}, false,
       "calls of the material at some or all particles, between steps"},
      {Effect::screening, "screening", "whether the exact motion is a stable solution", "force.response",
       IF(p.compared), {}, {}, {}, false, "updates of the material along the path, before the run"},
      {Effect::error_sampling, "error_sampling", "errors against the exact motion", "force.response", IF(p.compared),
       {}, {}, {}, false, "the exact fields at the particles, between steps"},
      {Effect::shadow, "shadow", "histories of the response, stepped during the run", "force.response",
       IF(p.compared && p.scene.force.response == ForceChoice::Response::shadow && ring_of(p.scene.motion)), {}, {},
       {}, true, "histories"},
      {Effect::isolation, "isolation", "the material in processes of its own", "material.isolation",
       IF(!adapters::start_of(&p.material->table()).task.empty()), {}, {}, {}, false,
       "workers, and memory shared with them"},
      {Effect::snapshots, "snapshots", "particles as VTU files", "output.particles", IF(p.scene.output.writes_particles()),
       {}, {}, {}, false, "files, between steps"},
      {Effect::pictures, "pictures", "particles and errors as PNG files", "output.pictures",
       IF(p.scene.output.pictures && p.compared), {}, {}, {}, false, "two frames of the particles"},
      {Effect::report, "report", "report.html", "output.report", IF(p.scene.output.report), {}, {}, {}, false,
       "a page, after the run"},
      {Effect::traction_table, "traction_table", "the algorithms of tractions side by side", "output.tractions",
       IF(p.scene.output.tractions), {}, {}, {}, false, "runs of the scene on three grids"},
  };
}
// clang-format on
#undef IF

}  // namespace

std::span<const EffectEntry> effects() {
  static const std::vector<EffectEntry> list = [] {
    std::vector<EffectEntry> all = of_forces();
    for (auto part : {of_particles(), of_runs()}) all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return list;
}

const EffectEntry& entry_of(mpm::Effect effect) { return effects()[static_cast<std::size_t>(effect)]; }

std::vector<mpm::Effect> effects_of(const Problem& problem) {
  std::vector<mpm::Effect> found;
  for (const EffectEntry& entry : effects()) {
    if (entry.called_for(problem)) found.push_back(entry.effect);
  }
  return found;
}

void require_compiled(const Problem& problem) {
  for (const mpm::Effect effect : effects_of(problem)) {
    if (mpm::compiled(effect)) continue;
    const EffectEntry& entry = entry_of(effect);
    const std::string key = entry.key_of(problem);
    throw InputError(problem.scene.place(key), key,
                     "calls for " + entry.name + ": this build has the spine's effects only (ASSAY_EFFECTS=spine)");
  }
}

}  // namespace assay::drivers
