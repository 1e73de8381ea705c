// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/step/passes_to_grid.hpp"

#include <cmath>

#include "mpm/data/dimension.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/kernels/kernels.hpp"
#include "mpm/setup/with_basis.hpp"

namespace assay::mpm {

namespace {

/// Those that particles reach, those of held particles, those whose images are among them and all images of these.
template <int Dim>
void find_live_nodes(State<Dim>& s) {
  s.live.forget();
  for (const NodeBox<Dim>& box : s.reach) s.live.mark(box);
  for (const auto& mark : s.markers) mark(s.live);
  mark_images(s.live, s.images);
  s.live.merge();
}

}  // namespace

template <int Dim>
Pass<Dim> weights_pass(const Method& method, bool domains_differ) {
  Pass<Dim> pass;
  pass.name = "weights";
  pass.slot = {Phase::weights};
  pass.called_for_by = "method.basis";
  pass.once = method.is_total();
  pass.doc = pass.once ? "nodes, phi_ip and grad phi_ip of every particle in the reference configuration"
                       : "nodes, phi_ip and grad phi_ip of every particle, shared by the passes of the step";
  const BasisTraits basis = traits_of<Dim>(method.basis);
  pass.reads = {basis.moves_corners ? Column::corners : pass.once ? Column::reference_position : Column::position};
  if (basis.uses_deformation && !pass.once) pass.reads.push_back(Column::deformation_gradient);
  if (domains_differ && basis.domain_components > 0) pass.reads.push_back(Column::domain);
  pass.writes = {Column::weights};
  pass.bind = [basis](State<Dim>& s) -> Kernel {
    s.reach.resize(blocks_of(s.particles));
    if (!s.basis) {
      s.basis = with_basis<Dim>(s.setup.method.basis, [&](auto tag) -> std::shared_ptr<void> {
        return std::make_shared<typename decltype(tag)::type>(s.setup.grid, s.setup.seeds.half_size, s.particles);
      });
    }
    Kernel kernel;
    const auto place = s.kernels.place;
    kernel.block = [&s, place](const Instant& now, const Block& block) { return place(s, block, now); };
    kernel.end = [&s, basis](const Instant&, std::optional<std::size_t> outside) {
      if (!outside) return find_live_nodes(s);
      bool number = true;
      for (int d = 0; d < Dim; ++d) number = number && std::isfinite(s.column(Column::position, d)[*outside]);
      if (!number) {
        s.finding = Finding{
            Finding::Kind::unstable, "the position is not a finite number", static_cast<std::int64_t>(*outside), {}};
        return;
      }
      s.finding = Finding{Finding::Kind::unstable,
                          basis.moves_corners ? "a corner of a domain left the grid, or a domain turned inside out"
                          : basis.nodes_across == 0 ? "a particle or a corner of its domain left the grid"
                                                    : "a particle left the grid",
                          static_cast<std::int64_t>(*outside)};
    };
    return kernel;
  };
  return pass;
}

namespace {

template <int Dim>
std::size_t around_of(const Method& method) {
  if (!method.is_affine()) return static_cast<std::size_t>(Around::nothing);
  return static_cast<std::size_t>(method.affine == Affine::moment ? Around::moment : Around::gradient);
}

template <int Dim>
Kernel scatter_kernel(State<Dim>& s, BlockKernel<Dim> scatter, bool momentum, bool force) {
  Kernel kernel;
  kernel.scatters = true;
  kernel.begin = [&s, momentum, force](const Instant&) {
    if (momentum) s.inertia.zero(s.live.runs());
    if (momentum && !s.held_mass.empty()) s.live.each([&](std::size_t i) { s.inertia.node(i)[0] = s.held_mass[i]; });
    if (force) s.force.zero(s.live.runs());
  };
  kernel.block = [&s, scatter](const Instant& now, const Block& block) { return scatter(s, block, now); };
  kernel.end = [&s, momentum, force](const Instant&, std::optional<std::size_t>) {
    if (momentum) s.inertia.reduce_ghosts();
    if (force) s.force.reduce_ghosts();
  };
  return kernel;
}

template <int Dim>
void call_for_force(Pass<Dim>& pass, bool with_body_force) {
  pass.reads.insert(pass.reads.end(), {Column::stress, Column::volume, Column::deformation_gradient});
  if (with_body_force) pass.reads.push_back(Column::body_force);
  pass.grid_fields.push_back("force");
}

}  // namespace

template <int Dim>
Pass<Dim> particles_to_grid_pass(const Method& method) {
  Pass<Dim> pass;
  pass.name = "particles_to_grid";
  pass.slot = {Phase::to_grid};
  pass.stages = Stages::first;
  pass.doc = method.is_affine() ? "nodal mass and momentum, of the velocity around the particles, too"
                                : "nodal mass and momentum";
  pass.called_for_by = method.is_affine() ? "method.transfer" : "method";
  pass.reads = {Column::weights, Column::mass, Column::velocity};
  if (method.is_affine()) pass.reads.push_back(affine_column(method));
  pass.grid_fields = {"mass", "momentum"};
  pass.bind = [around = around_of<Dim>(method)](State<Dim>& s) -> Kernel {
    return scatter_kernel(s, s.kernels.momentum[around], true, false);
  };
  return pass;
}

template <int Dim>
Pass<Dim> particles_and_forces_to_grid_pass(const Method& method, bool with_body_force) {
  Pass<Dim> pass = particles_to_grid_pass<Dim>(method);
  pass.doc =
      std::string("nodal mass, momentum") + (with_body_force ? ", internal and body force" : " and internal force");
  if (method.is_total()) pass.doc += ", by the first Piola-Kirchhoff stress";
  call_for_force(pass, with_body_force);
  pass.bind = [with_body_force, around = around_of<Dim>(method)](State<Dim>& s) -> Kernel {
    return scatter_kernel(s, s.kernels.momentum_and_force[around][with_body_force ? 1 : 0], true, true);
  };
  return pass;
}

template <int Dim>
Pass<Dim> force_pass(const Method& method, bool with_body_force) {
  Pass<Dim> pass;
  pass.name = "grid_forces";
  pass.slot = {Phase::forces};
  pass.stages = Stages::kicks;
  pass.doc = with_body_force ? "nodal internal and body force" : "nodal internal force";
  if (method.is_total()) pass.doc += ", by the first Piola-Kirchhoff stress";
  pass.called_for_by = "method";
  pass.reads = {Column::weights};
  if (with_body_force) pass.reads.push_back(Column::mass);
  call_for_force(pass, with_body_force);
  pass.bind = [with_body_force](State<Dim>& s) -> Kernel {
    return scatter_kernel(s, s.kernels.force[with_body_force ? 1 : 0], false, true);
  };
  return pass;
}

template Pass<ASSAY_DIMENSION> weights_pass(const Method&, bool);
template Pass<ASSAY_DIMENSION> particles_to_grid_pass(const Method&);
template Pass<ASSAY_DIMENSION> particles_and_forces_to_grid_pass(const Method&, bool);
template Pass<ASSAY_DIMENSION> force_pass(const Method&, bool);

}  // namespace assay::mpm
