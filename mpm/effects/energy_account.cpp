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
  std::array<double, 3> torque{};
  double internal = 0, external = 0;
};

template <int Dim>
BlockSums sums_of_block(const State<Dim>& s, bool with_body_force, std::size_t begin, std::size_t end) {
  BlockSums sums;
  for (std::size_t p = begin; p < end; ++p) {
    const double m = s.column(Column::mass)[p];
    if (with_body_force) {
      for (int d = 0; d < Dim; ++d) sums.impulse[static_cast<std::size_t>(d)] += m * s.column(Column::body_force, d)[p];
      add_moment(sums.torque, m, s.template at<Dim>(Column::position, p), s.template at<Dim>(Column::body_force, p));
    }
    const Mat<Dim> F = s.template at<Dim * Dim>(Column::deformation_gradient, p);
    Mat<Dim> L = s.template at<Dim * Dim>(Column::velocity_gradient, p);
    if (s.setup.method.is_total()) L = product<Dim>(L, inverse<Dim>(F));  // of dF/dt
    double power = 0, taken = 0;                                          // sigma : L
    const bool virtual_stress = s.has(Column::excess_stress);
    for (int c = 0; c < Dim * Dim; ++c) {
      const std::size_t row = stress_index<Dim>(static_cast<std::size_t>(c / Dim), static_cast<std::size_t>(c % Dim));
      const double sigma = s.column(Column::stress, row)[p], rate = L[static_cast<std::size_t>(c)];
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
  return !setup.method.is_total() && setup.method.update != Update::musl && !setup.method.has_stages() &&
         !setup.has_images() && !setup.hold_outside && setup.inertia == Inertia::grid;
}

template <int Dim>
void count_grid_angular_momentum(State<Dim>& s) {
  const GridGeometry<Dim>& grid = s.setup.grid;
  std::array<double, 3> sum{};
  double scale = 0;
  s.live.each([&](std::size_t i) {
    std::array<double, Dim> x, mv;
    std::size_t rest = i;
    for (std::size_t d = 0; d < Dim; ++d) {
      const auto across = static_cast<std::size_t>(grid.count[d]);
      x[d] = grid.coordinate(static_cast<int>(d), static_cast<std::int32_t>(rest % across));
      rest /= across;
      mv[d] = s.inertia.node(i)[1 + d];
    }
    std::array<double, 3> moment{};
    add_moment(moment, 1, x, mv);
    for (std::size_t d = 0; d < 3; ++d) sum[d] += moment[d];
    scale += Dim == 2 ? std::abs(moment[2]) : std::hypot(moment[0], moment[1], moment[2]);
  });
  Ledger& ledger = s.ledger;
  if (!ledger.grid_angular) ledger.grid_angular = sum;
  ledger.grid_angular_scale = larger(ledger.grid_angular_scale, scale);
  for (std::size_t d = 0; d < 3; ++d) {
    ledger.grid_angular_defect = larger(
        ledger.grid_angular_defect, std::abs(sum[d] - (*ledger.grid_angular)[d] - ledger.angular_impulse_before[d]));
  }
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
      for (std::size_t d = 0; d < 3; ++d) {
        s.ledger.impulse[d] += now.kick * sums.impulse[d];
        s.ledger.angular_impulse[d] += now.kick * sums.torque[d];
      }
      s.ledger.internal_work += now.kick * sums.internal;
      s.ledger.external_work += now.kick * sums.external;
    }
    if (turns) count_grid_angular_momentum(s);
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
  effect.passes = [](const Setup<Dim>& s) { return std::vector{accounts_pass<Dim>(s.method, s.body_force)}; };
  effect.around = "sums over the particles, and checks of them";
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> energy_account_effect();

}  // namespace assay::mpm
