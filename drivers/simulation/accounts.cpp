// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/accounts.hpp"

#include <algorithm>
#include <cmath>

#include "harness/numeric/largest.hpp"

namespace assay::drivers {

using mpm::Column;

Accounts::Amounts Accounts::amounts_of(const mpm::State<2>& s) {
  Amounts a;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const double m = s.column(Column::mass)[p];
    const double v[] = {s.column(Column::velocity, 0)[p], s.column(Column::velocity, 1)[p]};
    const double square = v[0] * v[0] + v[1] * v[1];
    a.momentum[0] += m * v[0];
    a.momentum[1] += m * v[1];
    a.momentum_scale += m * std::sqrt(square);
    const double moment = m * (s.column(Column::position, 0)[p] * v[1] - s.column(Column::position, 1)[p] * v[0]);
    a.angular_momentum += moment;
    a.angular_scale += std::abs(moment);
    a.kinetic_energy += 0.5 * m * square;
  }
  return a;
}

Accounts::Accounts(const mpm::State<2>& state)
    : first_(amounts_of(state)),
      held_(state.setup.hold_outside || state.setup.has_images()),
      momentum_scale_(first_.momentum_scale),
      angular_scale_(first_.angular_scale),
      energy_scale_(first_.kinetic_energy) {}

void Accounts::check(const mpm::State<2>& s) {
  const Amounts now = amounts_of(s);
  const mpm::Ledger& given = s.ledger;
  momentum_scale_ = larger(momentum_scale_, now.momentum_scale);
  for (std::size_t d = 0; d < 2; ++d) {
    momentum_ = larger(momentum_, std::abs(now.momentum[d] - first_.momentum[d] - given.impulse[d]));
  }
  angular_scale_ = larger(angular_scale_, now.angular_scale);
  angular_ = larger(angular_, std::abs(now.angular_momentum - first_.angular_momentum - given.angular_impulse));
  if (given.grid_angular) angular_ = given.grid_angular_defect, angular_scale_ = given.grid_angular_scale;
  energy_scale_ = std::max({energy_scale_, now.kinetic_energy, std::abs(given.internal_work)});
  energy_ =
      larger(energy_, std::abs(now.kinetic_energy - first_.kinetic_energy + given.internal_work - given.external_work));
  mass_ = larger(mass_, given.mass_defect);
}

DriftFigures Accounts::drift() const {
  const auto relative = [](double drift, double scale) { return scale > 0 ? Figure(drift / scale) : Figure(drift); };
  DriftFigures figures;
  figures.mass = mass_;
  figures.momentum = relative(momentum_, momentum_scale_);
  if (!held_) figures.angular_momentum = relative(angular_, angular_scale_);
  figures.energy = relative(energy_, energy_scale_);
  return figures;
}

}  // namespace assay::drivers
