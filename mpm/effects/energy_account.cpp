// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "harness/numeric/norms.hpp"
#include "mpm/data/blocks.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/kernels/kernel_state.hpp"
#include "mpm/step/effect.hpp"

namespace assay::mpm {

namespace {

/// Sums of one block, added up in the order of the blocks.
struct BlockSums {
  std::array<double, 3> impulse{};
  double torque = 0, internal = 0, external = 0;
};

template <int Dim>
BlockSums sums_of_block(const State<Dim>& s, bool with_body_force, std::size_t begin, std::size_t end) {
  BlockSums sums;
  for (std::size_t p = begin; p < end; ++p) {
    const double m = s.column(Column::mass)[p];
    if (with_body_force) {
      for (int d = 0; d < Dim; ++d) sums.impulse[static_cast<std::size_t>(d)] += m * s.column(Column::body_force, d)[p];
      sums.torque += m * (s.column(Column::position, 0)[p] * s.column(Column::body_force, 1)[p] -
                          s.column(Column::position, 1)[p] * s.column(Column::body_force, 0)[p]);
    }
    const Mat<Dim> F = s.template at<Dim * Dim>(Column::deformation_gradient, p);
    Mat<Dim> L = s.template at<Dim * Dim>(Column::velocity_gradient, p);
    if (s.setup.method.is_total()) L = product<Dim>(L, inverse<Dim>(F));  // of dF/dt
    double power = 0, taken = 0;                                          // sigma : L
    const bool virtual_stress = s.has(Column::excess_stress);
    for (int c = 0; c < Dim * Dim; ++c) {
      const double sigma = s.column(Column::stress, c)[p], rate = L[static_cast<std::size_t>(c)];
      power += sigma * rate;
      if (virtual_stress) taken += (sigma - s.column(Column::excess_stress, c)[p]) * rate;
    }
    const double volume = s.column(Column::volume)[p] * determinant<Dim>(F);
    sums.internal += volume * power;
    sums.external += volume * taken;
  }
  return sums;
}

/// Of all forces with what the nodes' velocities gain by them. Half of it is what the velocity after a kick gives them
/// too much: they work with the mean of those before and after.
template <int Dim>
double power_of_kick(const State<Dim>& s, double kick) {
  double power = 0;
  s.live.each([&](std::size_t i) {
    for (std::size_t d = 0; d < Dim; ++d) power += kick * s.force.node(i)[d] * s.motion.node(i)[Dim + d];
  });
  return power;
}

/// Whether L is that of the velocity after the kick. USF takes it from the one before, MUSL from a second map of the
/// particles' velocities: their accounts hold to first order in dt. Stages kick and drift apart.
bool rates_follow_kick(const Method& method) {
  return method.integrator == Integrator::leapfrog || (method.update == Update::usl && !method.has_stages());
}

/// Of the momentum that the particles brought, before the step's own impulse. In the total formulation nodes do not
/// move with the body; MUSL maps a second time; images take up a moment; inertia reaches particles before.
template <int Dim>
bool counts_grid_angular_momentum(const Setup<Dim>& setup) {
  return Dim == 2 && !setup.method.is_total() && setup.method.update != Update::musl && !setup.method.has_stages() &&
         !setup.has_images() && !setup.hold_outside && setup.inertia == Inertia::grid;
}

template <int Dim>
void count_grid_angular_momentum(State<Dim>& s) {
  const GridGeometry<Dim>& grid = s.setup.grid;
  double sum = 0, scale = 0;
  const auto across = static_cast<std::size_t>(grid.count[0]);
  s.live.each([&](std::size_t i) {
    const double x = grid.coordinate(0, static_cast<std::int32_t>(i % across));
    const double y = grid.coordinate(1, static_cast<std::int32_t>(i / across));
    const double* mv = s.inertia.node(i) + 1;
    const double moment = x * mv[1] - y * mv[0];
    sum += moment, scale += std::abs(moment);
  });
  Ledger& ledger = s.ledger;
  if (!ledger.grid_angular) ledger.grid_angular = sum;
  ledger.grid_angular_scale = larger(ledger.grid_angular_scale, scale);
  ledger.grid_angular_defect =
      larger(ledger.grid_angular_defect, std::abs(sum - *ledger.grid_angular - ledger.angular_impulse_before));
  ledger.angular_impulse_before = ledger.angular_impulse;
}

/// Impulse of the body force, work of the stress; mass on the grid against mass of the particles. Forces work with the
/// velocity that they leave; where velocities belong to the middles of steps, with the mean over the kick.
template <int Dim>
Kernel accounts_kernel(State<Dim>& s, bool with_body_force, bool works_after_kick) {
  auto blocks = std::make_shared<std::vector<BlockSums>>(blocks_of(s.particles));
  double particle_mass = 0;
  for (std::size_t p = 0; p < s.particles; ++p) particle_mass += s.column(Column::mass)[p];
  for (const double m : s.template own<Held>().mass) particle_mass += m;
  const auto sum_block = [&s, with_body_force, blocks](const Instant&, const Block& block) {
    (*blocks)[block.begin / block_size] = sums_of_block(s, with_body_force, block.begin, block.end);
    return none_bad;
  };
  const bool turns = counts_grid_angular_momentum(s.setup);
  const auto book = [&s, blocks, particle_mass, works_after_kick, turns](const Instant& now, const auto&) {
    for (const BlockSums& sums : *blocks) {
      for (std::size_t d = 0; d < 3; ++d) s.ledger.impulse[d] += now.kick * sums.impulse[d];
      s.ledger.angular_impulse += now.kick * sums.torque;
      s.ledger.internal_work += now.kick * sums.internal;
      s.ledger.external_work += now.kick * sums.external;
    }
    if (turns) count_grid_angular_momentum(s);  // in the plane
    if (works_after_kick) s.ledger.internal_work += 0.5 * now.kick * power_of_kick(s, now.kick);
    double grid_mass = 0;
    s.live.each([&](std::size_t i) { grid_mass += s.inertia.node(i)[0]; });
    s.ledger.mass_defect = larger(s.ledger.mass_defect, std::abs(grid_mass / particle_mass - 1));
  };
  return Kernel::over_blocks(sum_block, book);
}

template <int Dim>
Pass<Dim> accounts_pass(const Method& method, bool with_body_force) {
  Pass<Dim> pass{
      {.name = "accounts",
       .slot = {Phase::accounts},
       .doc = "momentum, mass and energy accounts",
       .reads = {Column::mass, Column::volume, Column::deformation_gradient, Column::stress, Column::velocity_gradient},
       .grid_fields = {"mass"},
       .stages = Stages::kicks}};
  if (with_body_force) pass.reads.insert(pass.reads.end(), {Column::body_force, Column::position});
  const bool works_after_kick = rates_follow_kick(method);
  if (works_after_kick) pass.grid_fields.insert(pass.grid_fields.end(), {"force", "acceleration"});
  pass.bind = [=](State<Dim>& s) { return accounts_kernel(s, with_body_force, works_after_kick); };
  return pass;
}

}  // namespace

template <int Dim>
EffectRecord<Dim> energy_account_effect() {
  EffectRecord<Dim> effect{240, "accounts of mass, momentum and energy", "output.accounts"};
  effect.called_for = [](const Setup<Dim>& s) { return s.accounts; };
  effect.passes = [](const Setup<Dim>& s) {
    return std::vector{accounts_pass<Dim>(s.method, Dim == 2 && s.body_force)};
  };
  effect.around = "sums over the particles, and checks of them";
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> energy_account_effect();

}  // namespace assay::mpm
