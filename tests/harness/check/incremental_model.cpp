// SPDX-License-Identifier: BSD-3-Clause
#include "tests/harness/check/incremental_model.hpp"

#include <utility>

namespace assay::check_tests::incremental {

namespace {

/// Strain and rotation of a step.
struct Kinematics {
  Tensor strain, rotation;
  Tensor spin = Tensor::Zero();
};

Kinematics kinematics(int defect, const Tensor& F0, const Tensor& F1) {
  const Tensor I = Tensor::Identity();
  if (defect == small_increment) return {0.5 * (F1 - F0 + (F1 - F0).transpose()), I};
  if (defect == rotation_of_F) return {logarithm(polar(F1).transpose() * F1 * F0.inverse() * polar(F0)), polar(F1)};
  if (defect == logarithmic) {
    const Tensor f = F1 * F0.inverse(), R = polar(f);
    return {logarithm(f * R.transpose()), R};
  }
  const Tensor L = 2 * (F1 - F0) * (F0 + F1).inverse();  // of the middle of the step
  const Tensor d = 0.5 * (L + L.transpose()), w = 0.5 * (L - L.transpose());
  if (defect == green_naghdi) {
    const Tensor R0 = polar(F0), R1 = polar(F1), half = polar(Tensor(R1 * R0.transpose() + I));
    return {half * d * half.transpose(), R1 * R0.transpose()};
  }
  if (defect == exponential_spin) return {d, exponential(w), w};
  if (defect == two_half_rotations) {
    const Tensor half = cayley(0.5 * w);
    return {half * d * half.transpose(), half * half, w};
  }
  const double factor = defect == no_rotation     ? 0
                        : defect == opposite_spin ? -1
                        : defect == half_spin     ? 0.5
                        : defect == double_spin   ? 2
                                                  : 1;
  return {d, cayley(factor * w), factor * w};
}

struct Step {
  double t, dt;
  Tensor F0, F1;
  std::size_t point;
};

/// Radial return on the shifted stress. Returns p at the end.
double plastic(const Model& m, Tensor& sigma, Tensor& back, double p) {
  const double mu = m.E / 2 / (1 + m.nu);
  const Tensor shifted = deviator(sigma) - back;
  const double weight = m.defect == shear_once_in_norm ? std::sqrt(0.5) : 1;
  const double size = sheared(shifted, weight).norm(), radius = std::sqrt(2.0 / 3) * (m.yield + m.isotropic * p);
  const bool unloads = size <= radius && !(m.defect == unloading_undoes_flow && p > 0 && size > 0);
  if (unloads) return p;
  if (m.defect == infinite_first_slope && p == 0) sigma *= NAN;
  const double flow = (size - radius) / (2 * mu + 2.0 / 3 * (m.isotropic + m.kinematic));
  const Tensor n = (m.defect == swapped_flow ? exchanged(shifted) : shifted) / size;
  sigma -= 2 * mu * flow * n;
  back += 2.0 / 3 * m.kinematic * flow * n;
  if (m.defect == back_stress_feeds_itself) back *= 1 + 18 * flow;
  if (m.defect == overshooting_return) sigma -= 0.2 * (deviator(sigma) - back);
  return p + std::sqrt(2.0 / 3) * flow;
}

/// Elastic stress of a strain, with its defects.
Tensor elastic(const Model& m, Tensor e) {
  if (m.defect == swapped_strain) e = exchanged(e);
  if (m.defect == cycled_strain) e = check::in_order({1, 2, 0}, e);
  if (m.defect == engineering_shear || m.defect == halved_shear) {
    e = sheared(e, m.defect == engineering_shear ? 2 : 0.5);
  }
  const double mu = m.E / 2 / (1 + m.nu), lambda = m.E * m.nu / ((1 + m.nu) * (1 - 2 * m.nu));
  Tensor sigma = 2 * mu * e + lambda * e.trace() * Tensor::Identity();
  if (m.defect == stiffer_axis) sigma(0, 0) += 0.2 * m.E * e(0, 0);
  return sigma;
}

/// The back stress after the rotation of a step; `rightly` where it has no defect of its own.
Tensor carried_back(int defect, const Tensor& R, const Tensor& back, const Tensor& rightly) {
  if (defect == fixed_back_stress) return back;
  if (defect == back_stress_turned_back) return R.transpose() * back * R;
  if (defect == swapped_back_stress) return exchanged(rightly);
  if (defect == voigt_back_stress) return check::in_order({2, 1, 0}, rightly);
  if (defect == back_stress_as_strain) return sheared(R * sheared(back, 0.5) * R.transpose(), 2);
  return rightly;
}

/// One point, in plain values. state: stress, back stress, p.
Tensor take(Model& m, const Step& step, Tensor& stress, Tensor& back, double& p) {
  const Kinematics k = kinematics(m.defect, step.F0, step.F1);
  const auto carry = [&](const Tensor& A) {
    if (m.defect == euler_spin || m.defect == double_euler_spin || m.defect == opposite_euler_spin) {
      const double times = m.defect == double_euler_spin ? 2 : m.defect == opposite_euler_spin ? -1 : 1;
      return Tensor(A + times * (k.spin * A - A * k.spin));
    }
    const Tensor turned = k.rotation * A * k.rotation.transpose();
    if (m.defect == cycled_rotation) return check::in_order({2, 0, 1}, turned);
    return m.defect == swapped_rotation ? exchanged(turned) : turned;
  };
  if (m.defect == yields_as_at_first) p = worked;
  if (m.defect == hidden_stress) stress = read(m.kept, 1, 0);
  if (m.defect == hardens_by_the_step && p > 0) p += 2e-3;
  if (m.defect == saved_by_point && step.t > 0) stress = statics.of_point.try_emplace(step.point, stress).first->second;
  stress = carry(stress) + elastic(m, k.strain);
  back = carried_back(m.defect, k.rotation, back, carry(back));
  p = plastic(m, stress, back, p);
  if (m.defect == hidden_stress) write(stress, m.kept, 1, 0);
  if (m.defect == saved_by_point) statics.of_point[step.point] = stress;
  if (m.defect == first_call && !std::exchange(statics.called, true)) stress *= 0.5;
  if (m.defect == hidden_counter) stress *= 1 + 1e-6 * ++m.kept[0];
  if (m.defect == reset_below_a_microsecond && step.t + step.dt < 1e-6) stress.setZero();
  if (m.defect == creeps_at_rest) stress *= 0.9;
  if (m.defect == pressed_at_rest) stress -= 1e-3 * m.E * Tensor::Identity();
  Tensor cauchy = stress;
  if (m.defect == viscous_undeclared) cauchy += 1e-2 * m.E * k.strain / step.dt;
  if (m.defect == time_of_day) cauchy *= 1 + 1e-3 * std::sin(step.t + step.dt);
  if (m.defect == swapped_stress) cauchy = exchanged(cauchy);
  if (m.defect == voigt_stress) cauchy = check::in_order({2, 1, 0}, cauchy);
  if (m.defect == noise_of_its_own) cauchy *= 1 + 0.3 * std::sin(1e9 * step.F1(0, 0));
  if (m.defect == swallows_nan && !cauchy.allFinite()) cauchy = stress = back = Tensor::Zero(), p = 0;
  return cauchy;
}

}  // namespace

void update(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1, double* cauchy,
            std::int32_t* status, double*, char* message) {
  auto& m = *static_cast<Model*>(self);
  for (std::size_t q = 0; q < n; ++q) {
    Tensor stress = read(state0, n, q, stress_at), back = read(state0, n, q, back_at);
    double p = state0[p_at * n + q];
    const Tensor F0 = read(step->F0, n, q), F1 = read(step->F1, n, q);
    const bool unturned = m.defect == back_stress_kept_in_the_reference;
    if (unturned) back = polar(F0) * back * polar(F0).transpose();
    const Tensor found = take(m, {step->t, step->dt, F0, F1, q}, stress, back, p);
    write(stress, state1, n, q, stress_at);
    write(unturned ? Tensor(polar(F1).transpose() * back * polar(F1)) : back, state1, n, q, back_at);
    if (m.defect != leaves_a_component) state1[p_at * n + q] = p;
    write(found, cauchy, n, q);
    const bool flows = p > state0[p_at * n + q];
    const bool refuses = m.defect == refuses_by_the_last_digits && flows && std::sin(1e13 * F1(0, 0)) > 0.9;
    const bool is_absent = m.defect == flows_by_an_absent_routine && flows;
    if (is_absent) std::strcpy(message, "the model called dsyev_, which nobody provides");
    status[q] = refuses || is_absent || (m.defect == refuses_to_flow && flows) ? ASSAY_FAILED : ASSAY_GOOD;
    // A batch whose points share what should be each one's own.
    if (m.defect == shared_scratch && n > 1) write(read(cauchy, n, 0), cauchy, n, q);
  }
  if (m.defect == writes_beyond_state) state1[state_size * n] = 0;
  if (m.defect == writes_beyond_stress || (m.defect == writes_beyond_large_batches && n > 1000)) cauchy[9 * n] = 0;
  if (m.defect == writes_its_input) const_cast<double*>(state0)[0] += 1;
}

}  // namespace assay::check_tests::incremental
