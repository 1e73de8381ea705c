// SPDX-License-Identifier: BSD-3-Clause
// Momentum, mass and energy of the particles against what the forces gave them.
#pragma once

#include "drivers/result/result.hpp"
#include "mpm/step/state.hpp"

namespace assay::drivers {

/// Drift figures are the largest difference over all checks, relative to the largest amount seen.
class Accounts {
 public:
  explicit Accounts(const mpm::State<2>& state);

  void check(const mpm::State<2>& state);
  DriftFigures drift() const;

 private:
  struct Amounts {
    double momentum[2] = {};      ///< [N s]
    double momentum_scale = 0;    ///< sum of m |v| [N s]
    double angular_momentum = 0;  ///< about E_z [N m s]
    double angular_scale = 0;     ///< sum of its parts' sizes [N m s]
    double kinetic_energy = 0;    ///< [J]
  };
  static Amounts amounts_of(const mpm::State<2>& state);

  Amounts first_;
  bool held_ = false;  ///< reactions act: the angular account does not close
  double momentum_ = 0, momentum_scale_ = 0, angular_ = 0, angular_scale_ = 0, energy_ = 0, energy_scale_ = 0;
  double mass_ = 0;
};

}  // namespace assay::drivers
