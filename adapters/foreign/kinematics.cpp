// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/kinematics.hpp"

#include "adapters/models/tensor_functions.hpp"

namespace assay::adapters {

namespace {

Tensor symmetric_part(const Tensor& A) { return 0.5 * (A + A.transpose()); }

/// ln V of f = V R.
Tensor left_strain(const Tensor& f) { return 0.5 * models::logarithm(Tensor(f * f.transpose())); }

/// (A1 - A0) ((A0 + A1) / 2)^-1.
Tensor midpoint_rate(const Tensor& A0, const Tensor& A1) { return 2 * (A1 - A0) * (A0 + A1).inverse(); }

/// d f(s) / ds at s = 0 by central differences of fourth order, good to 1e-11 of smooth kinematics.
StepStrain slope(const auto& f) {
  constexpr double h = 1e-4;
  const StepStrain a = f(h), b = f(-h), c = f(2 * h), d = f(-2 * h);
  return {(8 * (a.strain - b.strain) - (c.strain - d.strain)) / (12 * h),
          (8 * (a.rotation - b.rotation) - (c.rotation - d.rotation)) / (12 * h)};
}

}  // namespace

StepStrain step_strain(const Tensor& F0, const Tensor& F1, Kinematics kinematics) {
  if (F0 == F1) return {Tensor::Zero(), Tensor::Identity()};  // routines compare with 0
  if (kinematics == Kinematics::abaqus) {
    const Tensor l = midpoint_rate(F0, F1), half_spin = 0.25 * (l - l.transpose()), I = Tensor::Identity();
    return {symmetric_part(l), Tensor((I - half_spin).inverse() * (I + half_spin))};
  }
  const Tensor f = F1 * F0.inverse();
  return {left_strain(f), models::rotation_of(f)};
}

CorotationalStep corotational_step(const Tensor& F0, const Tensor& F1, Kinematics kinematics) {
  CorotationalStep step;
  step.R0 = models::rotation_of(F0);
  step.R1 = models::rotation_of(F1);
  step.U0 = symmetric_part(step.R0.transpose() * F0);
  step.U1 = symmetric_part(step.R1.transpose() * F1);
  if (kinematics == Kinematics::abaqus) {
    step.strain = symmetric_part(midpoint_rate(step.U0, step.U1));
  } else if (F0 == F1) {
    step.strain.setZero();
  } else {
    const Tensor g = step.U1 * step.U0.inverse();
    step.strain = 0.5 * (left_strain(g) + left_strain(g.transpose()));
  }
  const Tensor spin = midpoint_rate(step.R0, step.R1);
  step.spin = 0.5 * (spin - spin.transpose());
  return step;
}

StepStrain logarithmic_strain_of(const Tensor& F) {
  return {0.5 * models::logarithm(Tensor(F.transpose() * F)), models::rotation_of(F)};
}

StepStrain rate_of_logarithmic_strain(const Tensor& F, const Tensor& E) {
  return slope([&](double by) { return logarithmic_strain_of(F + by * E); });
}

StepStrain rate_of_step(const Tensor& F0, const Tensor& F1, const Tensor& E, Kinematics kinematics) {
  return slope([&](double by) -> StepStrain {
    const StepStrain at = step_strain(F0, F1 + by * E, kinematics);
    return {at.rotation.transpose() * at.strain * at.rotation, at.rotation};
  });
}

StepStrain rate_of_corotational_step(const Tensor& F0, const Tensor& F1, const Tensor& E, Kinematics kinematics) {
  return slope([&](double by) -> StepStrain {
    const CorotationalStep at = corotational_step(F0, F1 + by * E, kinematics);
    return {at.strain, at.R1};
  });
}

}  // namespace assay::adapters
