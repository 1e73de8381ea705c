// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/step/passes_to_particles.hpp"

#include "mpm/data/dimension.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/kernels/kernels.hpp"
#include "mpm/setup/with_basis.hpp"

namespace assay::mpm {

namespace {

Velocity velocity_of(const Method& method) {
  if (!method.keeps_velocity()) return Velocity::of_grid;
  return method.flip == 1 ? Velocity::kept : Velocity::blended;
}

template <int Dim>
void end_gather(State<Dim>& s, const Instant& now, std::optional<std::size_t> bad) {
  for (const double power : s.block_power) s.ledger.external_work += now.kick * power;  // none without a kick
  if (!bad) return;
  s.finding = Finding{Finding::Kind::unstable, "a particle's position or velocity is not finite",
                      static_cast<std::int64_t>(*bad)};
}

}  // namespace

template <int Dim>
bool fits_with_corners(const Method& method) {
  return traits_of<Dim>(method.basis).moves_corners && method.is_affine() && fits_gradient(method);
}

template <int Dim>
Pass<Dim> grid_to_particles_pass(const Method& method, bool with_velocity_gradient, bool with_work) {
  Pass<Dim> pass;
  const Velocity kind = velocity_of(method);
  pass.name = "grid_to_particles";
  pass.slot = {Phase::to_particles};
  pass.doc = kind == Velocity::of_grid ? "positions and velocities by grid velocity"
             : kind == Velocity::kept  ? "positions by grid velocity, velocities by grid acceleration"
                                       : "positions by grid velocity, velocities by both";
  pass.called_for_by = "method.transfer";
  pass.reads = {Column::weights, Column::position};
  if (method.keeps_velocity()) pass.reads.push_back(Column::velocity);
  if (with_work) pass.reads.insert(pass.reads.end(), {Column::mass, Column::body_force});
  pass.writes = {Column::position, Column::velocity};
  if (with_velocity_gradient) pass.writes.push_back(Column::velocity_gradient);
  const bool fits = fits_with_corners<Dim>(method);
  if (traits_of<Dim>(method.basis).moves_corners) {
    pass.doc += fits ? "; corners and the fitted gradient" : "; corners";
    pass.reads.push_back(Column::corners);
    pass.writes.push_back(Column::corners);
  }
  if (fits) pass.writes.push_back(Column::affine);
  pass.grid_fields = {"velocity", "acceleration"};
  pass.bind = [=](State<Dim>& s) -> Kernel {
    if (with_work) s.block_power.assign(blocks_of(s.particles), 0.0);
    const Gathers<Dim>& gathers = fits ? s.kernels.gather_and_fit : s.kernels.gather;
    const auto gather = gathers[static_cast<std::size_t>(kind)][with_velocity_gradient ? 1 : 0][with_work ? 1 : 0];
    Kernel kernel;
    kernel.block = [&s, gather](const Instant& now, const Block& block) { return gather(s, block, now); };
    kernel.end = [&s](const Instant& now, std::optional<std::size_t> bad) { end_gather(s, now, bad); };
    return kernel;
  };
  return pass;
}

template <int Dim>
Pass<Dim> velocity_gradient_pass(const Method& method) {
  Pass<Dim> pass;
  pass.name = "velocity_gradient";
  pass.slot = {gradient_phase(method), Part::last};
  pass.doc = "L of the particles from the grid velocity";
  pass.called_for_by = "method.update";
  pass.reads = {Column::weights};
  pass.writes = {Column::velocity_gradient};
  pass.grid_fields = {"velocity"};
  pass.bind = [](State<Dim>& s) -> Kernel {
    Kernel kernel;
    const auto gather = s.kernels.velocity_gradient;
    kernel.block = [&s, gather](const Instant& now, const Block& block) { return gather(s, block, now); };
    return kernel;
  };
  return pass;
}

template bool fits_with_corners<ASSAY_DIMENSION>(const Method&);
template Pass<ASSAY_DIMENSION> grid_to_particles_pass(const Method&, bool, bool);
template Pass<ASSAY_DIMENSION> velocity_gradient_pass(const Method&);

}  // namespace assay::mpm
