// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/step/passes.hpp"

#include <algorithm>
#include <cmath>

#include "mpm/kernels/affine.hpp"
#include "mpm/setup/with_basis.hpp"

namespace assay::mpm {

namespace {

/// Those that particles reach, those of held particles, those whose images are among them and all images of these.
template <int Dim>
void find_live_nodes(State<Dim>& s, const Images<Dim>& images) {
  s.live.forget();
  for (const NodeBox<Dim>& box : s.reach) s.live.mark(box);
  for (const auto& mark : s.markers) mark(s.live);
  mark_images(s.live, images);
  s.live.merge();
}

/// Of a particle that cannot be placed.
template <int Dim>
Finding lost_particle(const State<Dim>& s, const BasisTraits& basis, std::size_t p) {
  bool number = true;
  for (int d = 0; d < Dim; ++d) number = number && std::isfinite(s.column(Column::position, d)[p]);
  const char* reason = !number                   ? "the position is not a finite number"
                       : basis.moves_corners     ? "a corner of a domain left the grid, or a domain turned inside out"
                       : basis.nodes_across == 0 ? "a particle or a corner of its domain left the grid"
                                                 : "a particle left the grid";
  return {Finding::Kind::unstable, reason, static_cast<std::int64_t>(p)};
}

std::size_t around_of(const Method& method) {
  const Around around = !method.is_affine()               ? Around::nothing
                        : method.affine == Affine::moment ? Around::moment
                                                          : Around::gradient;
  return static_cast<std::size_t>(around);
}

template <int Dim>
Kernel scatter_kernel(State<Dim>& s, BlockKernel<Dim> scatter, bool momentum, bool force) {
  Kernel kernel = over_blocks(s, scatter, [&s, momentum, force](const Instant&, std::optional<std::size_t>) {
    if (momentum) s.inertia.reduce_ghosts();
    if (force) s.force.reduce_ghosts();
  });
  kernel.scatters = true;
  kernel.begin = [&s, &held = s.template own<Held>(), momentum, force](const Instant&) {
    if (momentum) s.inertia.zero(s.live.runs());
    if (momentum && !held.mass.empty()) s.live.each([&](std::size_t i) { s.inertia.node(i)[0] = held.mass[i]; });
    if (force) s.force.zero(s.live.runs());
    if (force && !held.force.empty())
      s.live.each([&](std::size_t i) { std::copy_n(&held.force[Dim * i], Dim, s.force.node(i)); });
  };
  return kernel;
}

template <int Dim>
void call_for_force(Pass<Dim>& pass, const Method& method, bool with_body_force) {
  if (method.is_total()) pass.doc += ", by the first Piola-Kirchhoff stress";
  pass.reads.insert(pass.reads.end(), {Column::stress, Column::volume, Column::deformation_gradient});
  if (with_body_force) pass.reads.push_back(Column::body_force);
  pass.grid_fields.push_back("force");
}

template <int Dim>
void move_grid(State<Dim>& s, const Instant& now) {
  s.live.each([&](std::size_t i) {
    const double* inertia = s.inertia.node(i);
    const double* force = s.force.node(i);
    double* motion = s.motion.node(i);
    if (!(inertia[0] > 0)) {
      for (std::size_t d = 0; d < 2 * Dim; ++d) motion[d] = 0;
      return;
    }
    const double inverse = 1 / inertia[0];
    for (std::size_t d = 0; d < Dim; ++d) {
      motion[Dim + d] = force[d] * inverse;
      motion[d] = inertia[1 + d] * inverse + now.kick * motion[Dim + d];
    }
  });
}

}  // namespace

template <int Dim>
Pass<Dim> weights_pass(const Method& method, bool domains_differ) {
  const BasisTraits basis = traits_of<Dim>(method.basis);
  Pass<Dim> pass{{.name = "weights",
                  .slot = {Phase::weights},
                  .doc = "nodes, phi_ip and grad phi_ip of every particle",
                  .called_for_by = "method.basis",
                  .writes = {Column::weights},
                  .once = method.is_total()}};
  pass.doc += pass.once ? " in the reference configuration" : ", shared by the passes of the step";
  pass.reads = {basis.moves_corners ? Column::corners : pass.once ? Column::reference_position : Column::position};
  if (basis.uses_deformation && !pass.once) pass.reads.push_back(Column::deformation_gradient);
  if (domains_differ && basis.domain_components > 0) pass.reads.push_back(Column::domain);
  pass.bind = [basis](State<Dim>& s) {
    s.reach.resize(blocks_of(s.particles));
    if (!s.basis) {
      s.basis = with_basis<Dim>(s.setup.method.basis, [&](auto tag) -> std::shared_ptr<void> {
        return std::make_shared<typename decltype(tag)::type>(s.setup.grid, s.setup.seeds.half_size, s.particles);
      });
    }
    const auto& images = s.template own<Images<Dim>>();
    return over_blocks(s, kernels_for(s).place,
                       [&s, &images, basis](const Instant&, std::optional<std::size_t> outside) {
                         if (!outside) return find_live_nodes(s, images);
                         s.finding = lost_particle(s, basis, *outside);
                       });
  };
  return pass;
}

template <int Dim>
Pass<Dim> particles_to_grid_pass(const Method& method) {
  const bool affine = method.is_affine();
  Pass<Dim> pass{
      {.name = "particles_to_grid",
       .slot = {Phase::to_grid},
       .doc = affine ? "nodal mass and momentum, of the velocity around the particles, too" : "nodal mass and momentum",
       .called_for_by = affine ? "method.transfer" : "method",
       .reads = {Column::weights, Column::mass, Column::velocity},
       .grid_fields = {"mass", "momentum"},
       .stages = Stages::first},
      [around = around_of(method)](State<Dim>& s) {
        return scatter_kernel(s, kernels_for(s).momentum[around], true, false);
      }};
  if (affine) pass.reads.push_back(affine_column(method));
  return pass;
}

template <int Dim>
Pass<Dim> particles_and_forces_to_grid_pass(const Method& method, bool with_body_force) {
  Pass<Dim> pass = particles_to_grid_pass<Dim>(method);
  pass.doc =
      std::string("nodal mass, momentum") + (with_body_force ? ", internal and body force" : " and internal force");
  call_for_force(pass, method, with_body_force);
  pass.bind = [with_body_force, around = around_of(method)](State<Dim>& s) {
    return scatter_kernel(s, kernels_for(s).momentum_and_force[around][with_body_force ? 1 : 0], true, true);
  };
  return pass;
}

template <int Dim>
Pass<Dim> force_pass(const Method& method, bool with_body_force) {
  Pass<Dim> pass{{.name = "grid_forces",
                  .slot = {Phase::forces},
                  .doc = with_body_force ? "nodal internal and body force" : "nodal internal force",
                  .called_for_by = "method",
                  .reads = {Column::weights},
                  .stages = Stages::kicks},
                 [with_body_force](State<Dim>& s) {
                   return scatter_kernel(s, kernels_for(s).force[with_body_force ? 1 : 0], false, true);
                 }};
  if (with_body_force) pass.reads.push_back(Column::mass);
  call_for_force(pass, method, with_body_force);
  return pass;
}

template <int Dim>
Pass<Dim> grid_velocity_pass(const Method& method) {
  return {{.name = "grid_velocity",
           .slot = {gradient_phase(method)},
           .doc = "nodal velocity from momentum",
           .called_for_by = "method.update",
           .grid_fields = {"mass", "momentum", "velocity"}},
          [](State<Dim>& s) -> Kernel {
            return [&s](const Instant&) {
              s.live.each([&](std::size_t i) {
                const double* inertia = s.inertia.node(i);
                double* motion = s.motion.node(i);
                for (std::size_t d = 0; d < Dim; ++d) {
                  motion[d] = inertia[0] > 0 ? inertia[1 + d] / inertia[0] : 0;
                  motion[Dim + d] = 0;
                }
              });
            };
          }};
}

template <int Dim>
Pass<Dim> grid_update_pass() {
  return {{.name = "grid_update",
           .slot = {Phase::grid},
           .doc = "nodal acceleration and velocity",
           .called_for_by = "method",
           .grid_fields = {"mass", "momentum", "force", "velocity", "acceleration"}},
          [](State<Dim>& s) -> Kernel { return [&s](const Instant& now) { move_grid(s, now); }; }};
}

template <int Dim>
bool fits_with_corners(const Method& method) {
  return traits_of<Dim>(method.basis).moves_corners && method.is_affine() && fits_gradient(method);
}

template <int Dim>
Pass<Dim> grid_to_particles_pass(const Method& method, bool with_velocity_gradient, bool with_work) {
  const Velocity kind = !method.keeps_velocity() ? Velocity::of_grid
                        : method.flip == 1       ? Velocity::kept
                                                 : Velocity::blended;
  const bool fits = fits_with_corners<Dim>(method);
  Pass<Dim> pass{{.name = "grid_to_particles",
                  .slot = {Phase::to_particles},
                  .doc = kind == Velocity::of_grid ? "positions and velocities by grid velocity"
                         : kind == Velocity::kept  ? "positions by grid velocity, velocities by grid acceleration"
                                                   : "positions by grid velocity, velocities by both",
                  .called_for_by = "method.transfer",
                  .reads = {Column::weights, Column::position},
                  .writes = {Column::position, Column::velocity},
                  .grid_fields = {"velocity", "acceleration"}}};
  if (method.keeps_velocity()) pass.reads.push_back(Column::velocity);
  if (with_work) pass.reads.insert(pass.reads.end(), {Column::mass, Column::body_force});
  if (with_velocity_gradient) pass.writes.push_back(Column::velocity_gradient);
  if (traits_of<Dim>(method.basis).moves_corners) {
    pass.doc += fits ? "; corners and the fitted gradient" : "; corners";
    pass.reads.push_back(Column::corners);
    pass.writes.push_back(Column::corners);
  }
  if (fits) pass.writes.push_back(Column::affine);
  pass.bind = [=](State<Dim>& s) {
    if (with_work) s.block_power.assign(blocks_of(s.particles), 0.0);
    const Gathers<Dim>& gathers = fits ? kernels_for(s).gather_and_fit : kernels_for(s).gather;
    const auto gather = gathers[static_cast<std::size_t>(kind)][with_velocity_gradient ? 1 : 0][with_work ? 1 : 0];
    return over_blocks(s, gather, [&s](const Instant& now, std::optional<std::size_t> bad) {
      for (const double power : s.block_power) s.ledger.external_work += now.kick * power;  // none without a kick
      if (!bad) return;
      s.finding = Finding{Finding::Kind::unstable, "a particle's position or velocity is not finite",
                          static_cast<std::int64_t>(*bad)};
    });
  };
  return pass;
}

template <int Dim>
Pass<Dim> velocity_gradient_pass(const Method& method) {
  return {{.name = "velocity_gradient",
           .slot = {gradient_phase(method), Part::last},
           .doc = "L of the particles from the grid velocity",
           .called_for_by = "method.update",
           .reads = {Column::weights},
           .writes = {Column::velocity_gradient},
           .grid_fields = {"velocity"}},
          [](State<Dim>& s) { return over_blocks(s, kernels_for(s).velocity_gradient); }};
}

template Pass<ASSAY_DIMENSION> weights_pass(const Method&, bool);
template Pass<ASSAY_DIMENSION> particles_to_grid_pass(const Method&);
template Pass<ASSAY_DIMENSION> particles_and_forces_to_grid_pass(const Method&, bool);
template Pass<ASSAY_DIMENSION> force_pass(const Method&, bool);
template Pass<ASSAY_DIMENSION> grid_velocity_pass(const Method&);
template Pass<ASSAY_DIMENSION> grid_update_pass();
template bool fits_with_corners<ASSAY_DIMENSION>(const Method&);
template Pass<ASSAY_DIMENSION> grid_to_particles_pass(const Method&, bool, bool);
template Pass<ASSAY_DIMENSION> velocity_gradient_pass(const Method&);

}  // namespace assay::mpm
