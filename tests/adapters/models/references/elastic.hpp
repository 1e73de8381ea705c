// SPDX-License-Identifier: BSD-3-Clause
// Stress by the definitions of the models that no differential equation governs.
#pragma once

#include "tests/adapters/models/reference_integration.hpp"

namespace assay::model_tests {

/// (34).
inline Tensor neo_hookean_stress(const Lame& c, const Tensor& F) {
  const double J = F.determinant();
  return (c.lambda * std::log(J) * Tensor::Identity() + c.mu * (F * F.transpose() - Tensor::Identity())) / J;
}

/// S = lambda tr(E) I + 2 mu E.
inline Tensor saint_venant_kirchhoff_stress(const Lame& c, const Tensor& F) {
  const Tensor E = 0.5 * (F.transpose() * F - Tensor::Identity());
  return F * c(E) * F.transpose() / F.determinant();
}

/// J sigma = kappa ln J I + 2 dev(c10 b' + c01 (I1' b' - b'^2)), b' = J^(-2/3) b.
inline Tensor mooney_rivlin_stress(double c10, double c01, double kappa, const Tensor& F) {
  const double J = F.determinant();
  const Tensor b = std::pow(J, -2.0 / 3) * F * F.transpose();
  return (kappa * std::log(J) * Tensor::Identity() + 2 * deviator_of(c10 * b + c01 * (b.trace() * b - b * b))) / J;
}

struct Orthotropy {
  double E_r, E_t, E_z, nu_rt, nu_rz, nu_tz, G_rt, G_rz, G_tz;
};

/// S with E = compliance S in the axes r = direction, z = E3, t = z x r.
inline Tensor orthotropic_stress(const Orthotropy& c, const Tensor& F, const Eigen::Vector3d& direction) {
  Tensor axes, compliance;
  axes << direction, Eigen::Vector3d::UnitZ().cross(direction), Eigen::Vector3d::UnitZ();
  compliance << 1 / c.E_r, -c.nu_rt / c.E_r, -c.nu_rz / c.E_r,  //
      -c.nu_rt / c.E_r, 1 / c.E_t, -c.nu_tz / c.E_t,            //
      -c.nu_rz / c.E_r, -c.nu_tz / c.E_t, 1 / c.E_z;
  const Tensor strain = axes.transpose() * (0.5 * (F.transpose() * F - Tensor::Identity())) * axes;
  Tensor S = Eigen::Vector3d(compliance.partialPivLu().solve(strain.diagonal())).asDiagonal();
  S(0, 1) = S(1, 0) = 2 * c.G_rt * strain(0, 1);
  S(0, 2) = S(2, 0) = 2 * c.G_rz * strain(0, 2);
  S(1, 2) = S(2, 1) = 2 * c.G_tz * strain(1, 2);
  return F * axes * S * axes.transpose() * F.transpose() / F.determinant();
}

struct Fluid {
  double modulus, viscosity, bulk_viscosity, exponent;
};

/// sigma = -p I + 2 viscosity dev d + bulk_viscosity tr(d) I, p = modulus / exponent (J^-exponent - 1).
inline Tensor fluid_stress(const Fluid& c, const Tensor& F, const Tensor& l) {
  const Tensor d = symmetric_part(l);
  const double p = c.modulus / c.exponent * (std::pow(F.determinant(), -c.exponent) - 1);
  return 2 * c.viscosity * deviator_of(d) + (c.bulk_viscosity * d.trace() - p) * Tensor::Identity();
}

struct Damage {
  double E, nu, kappa_0, kappa_f, D_max;
};

inline double undamaged_energy(const Damage& c, const Tensor& F) {
  const Lame elastic(c.E, c.nu);
  const double ln_J = std::log(F.determinant());
  return 0.5 * elastic.lambda * ln_J * ln_J - elastic.mu * ln_J + 0.5 * elastic.mu * ((F.transpose() * F).trace() - 3);
}

/// (1 - D) of (34), kappa the largest energy at `fine` times, at the turns and at the end.
inline Tensor damage_stress(const Damage& c, const History& history, int fine) {
  double kappa = c.kappa_0;
  for (int k = 0; k <= fine; ++k) kappa = std::max(kappa, undamaged_energy(c, history.F(history.end * k / fine)));
  for (const double t : history.turns) kappa = std::max(kappa, undamaged_energy(c, history.F(t)));
  const double D = c.D_max * (1 - std::exp(-(kappa - c.kappa_0) / c.kappa_f));
  return (1 - D) * neo_hookean_stress({c.E, c.nu}, history.F(history.end));
}

}  // namespace assay::model_tests
