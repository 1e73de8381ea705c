// SPDX-License-Identifier: BSD-3-Clause
// J2 plasticity in increments, with linear isotropic and kinematic hardening; a parameter plants one defect.
#include <utility>

#include "harness/check/battery.hpp"
#include "tests/harness/check/model_table.hpp"

namespace assay::check_tests {

namespace {

enum Defect : int {
  hughes_winget,  // the first five have none
  green_naghdi,
  logarithmic,
  exponential_spin,
  two_half_rotations,
  no_rotation,
  opposite_spin,
  half_spin,
  double_spin,
  euler_spin,
  fixed_back_stress,
  back_stress_turned_back,
  swapped_back_stress,
  back_stress_as_strain,
  swapped_stress,
  swapped_strain,
  swapped_rotation,
  engineering_shear,
  halved_shear,
  small_increment,
  stiffer_axis,
  hidden_stress,
  hidden_counter,
  shared_scratch,
  first_call,
  saved_by_point,
  reset_below_a_microsecond,
  viscous_undeclared,
  time_of_day,
  writes_beyond_state,
  writes_beyond_stress,
  writes_beyond_large_batches,
  leaves_a_component,
  writes_its_input,
  pressed_at_rest,
  half_initial_stress,
  initial_stress_in_another_order,
  creeps_at_rest,
  noise_of_its_own,
  swallows_nan,
  defects
};

constexpr std::size_t stress_at = 0, back_at = 9, p_at = 18, state_size = 19;

struct Model {
  double E, nu, yield, isotropic, kinematic;
  int defect;
  double kept[9] = {};
};

/// Strain and rotation of a step.
struct Kinematics {
  Tensor strain, rotation;
  Tensor spin = Tensor::Zero();
};

Kinematics kinematics(int defect, const Tensor& F0, const Tensor& F1) {
  const Tensor I = Tensor::Identity();
  if (defect == small_increment) return {0.5 * (F1 - F0 + (F1 - F0).transpose()), I};
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
  const double size = shifted.norm(), radius = std::sqrt(2.0 / 3) * (m.yield + m.isotropic * p);
  if (size <= radius) return p;
  const double flow = (size - radius) / (2 * mu + 2.0 / 3 * (m.isotropic + m.kinematic));
  const Tensor n = shifted / size;
  sigma -= 2 * mu * flow * n;
  back += 2.0 / 3 * m.kinematic * flow * n;
  return p + std::sqrt(2.0 / 3) * flow;
}

/// Elastic stress of a strain, with its defects.
Tensor elastic(const Model& m, Tensor e) {
  if (m.defect == swapped_strain) e = exchanged(e);
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
  if (defect == back_stress_as_strain) return sheared(R * sheared(back, 0.5) * R.transpose(), 2);
  return rightly;
}

/// One point, in plain values. state: stress, back stress, p.
Tensor take(Model& m, const Step& step, Tensor& stress, Tensor& back, double& p) {
  const Kinematics k = kinematics(m.defect, step.F0, step.F1);
  const auto carry = [&](const Tensor& A) {
    if (m.defect == euler_spin) return Tensor(A + k.spin * A - A * k.spin);
    const Tensor turned = k.rotation * A * k.rotation.transpose();
    return m.defect == swapped_rotation ? exchanged(turned) : turned;
  };
  if (m.defect == hidden_stress) stress = read(m.kept, 1, 0);
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
  if (m.defect == noise_of_its_own) cauchy *= 1 + 0.3 * std::sin(1e9 * step.F1(0, 0));
  if (m.defect == swallows_nan && !cauchy.allFinite()) cauchy = stress = back = Tensor::Zero(), p = 0;
  return cauchy;
}

void update(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1, double* cauchy,
            std::int32_t* status, double*, char*) {
  auto& m = *static_cast<Model*>(self);
  for (std::size_t q = 0; q < n; ++q) {
    Tensor stress = read(state0, n, q, stress_at), back = read(state0, n, q, back_at);
    double p = state0[p_at * n + q];
    const Tensor F0 = read(step->F0, n, q), F1 = read(step->F1, n, q);
    const Tensor found = take(m, {step->t, step->dt, F0, F1, q}, stress, back, p);
    write(stress, state1, n, q, stress_at);
    write(back, state1, n, q, back_at);
    if (m.defect != leaves_a_component) state1[p_at * n + q] = p;
    write(found, cauchy, n, q);
    status[q] = ASSAY_GOOD;
    // A batch whose points share what should be each one's own.
    if (m.defect == shared_scratch && n > 1) write(read(cauchy, n, 0), cauchy, n, q);
  }
  if (m.defect == writes_beyond_state) state1[state_size * n] = 0;
  if (m.defect == writes_beyond_stress || (m.defect == writes_beyond_large_batches && n > 1000)) cauchy[9 * n] = 0;
  if (m.defect == writes_its_input) const_cast<double*>(state0)[0] += 1;
}

std::int32_t initial_state(void* self, std::size_t n, const double* cauchy, double* state) {
  const auto& m = *static_cast<const Model*>(self);
  std::memset(state, 0, state_size * n * sizeof *state);
  for (std::size_t q = 0; q < n; ++q) {
    Tensor sigma = read(cauchy, n, q);
    if (m.defect == half_initial_stress) sigma *= 0.5;
    if (m.defect == initial_stress_in_another_order) sigma = exchanged(sigma);
    write(sigma, state, n, q, stress_at);
  }
  return ASSAY_GOOD;
}

const assay_material* table() {
  static const assay_parameter parameters[] = {{"E", "Pa", 1e3, 0, 1e12, "Young's modulus"},
                                               {"nu", "1", 0.3, -1, 0.5, "Poisson's ratio"},
                                               {"yield_stress", "Pa", 40, 0, 1e12, "at the first flow"},
                                               {"isotropic", "Pa", 30, 0, 1e12, "hardening"},
                                               {"kinematic", "Pa", 100, 0, 1e12, "hardening"},
                                               {"defect", "1", 0, 0, defects - 1, "which"}};
  static const assay_state_variable state[] = {{"stress", "Pa", ASSAY_TENSOR, ASSAY_ROLE_PLAIN, "Cauchy stress"},
                                               {"back_stress", "Pa", ASSAY_TENSOR, ASSAY_ROLE_PLAIN, "centre"},
                                               {"p", "1", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, "plastic strain"}};
  static const assay_material made = [] {
    assay_material t = named_table("incremental_for_tests", ASSAY_NON_SMOOTH | ASSAY_USES_INCREMENT, parameters, state);
    t.create = [](const double* p, char*) -> void* {
      return new Model{p[0], p[1], p[2], p[3], p[4], static_cast<int>(p[5])};
    };
    t.destroy = [](void* self) { delete static_cast<Model*>(self); };
    t.initial_state = initial_state;
    t.update = update;
    return t;
  }();
  return &made;
}

}  // namespace

std::vector<Subject> incremental_subjects() {
  using namespace check::causes;
  const Planted planted{{"hughes_winget", hughes_winget, ""},
                        {"green_naghdi", green_naghdi, ""},
                        {"logarithmic", logarithmic, ""},
                        {"exponential_spin", exponential_spin, ""},
                        {"two_half_rotations", two_half_rotations, ""},
                        {"no_rotation", no_rotation, rotation_missing},
                        {"opposite_spin", opposite_spin, wrong_spin},
                        {"half_spin", half_spin, wrong_spin},
                        {"double_spin", double_spin, wrong_spin},
                        {"euler_spin", euler_spin, explicit_spin},
                        {"fixed_back_stress", fixed_back_stress, state_not_rotated},
                        {"back_stress_turned_back", back_stress_turned_back, wrong_spin},
                        {"swapped_back_stress", swapped_back_stress, components_swapped},
                        {"back_stress_as_strain", back_stress_as_strain, shear_factor},
                        {"swapped_stress", swapped_stress, components_swapped},
                        {"swapped_strain", swapped_strain, components_swapped},
                        {"swapped_rotation", swapped_rotation, components_swapped},
                        {"engineering_shear", engineering_shear, shear_factor},
                        {"halved_shear", halved_shear, shear_factor},
                        {"small_increment", small_increment, small_strain},
                        {"stiffer_axis", stiffer_axis, not_isotropic},
                        {"hidden_stress", hidden_stress, hidden_state},
                        {"hidden_counter", hidden_counter, hidden_state},
                        {"shared_scratch", shared_scratch, hidden_state},
                        {"first_call", first_call, hidden_state},
                        {"saved_by_point", saved_by_point, hidden_state},
                        {"reset_below_a_microsecond", reset_below_a_microsecond, clock},
                        {"viscous_undeclared", viscous_undeclared, clock},
                        {"time_of_day", time_of_day, clock},
                        {"writes_beyond_state", writes_beyond_state, overrun},
                        {"writes_beyond_stress", writes_beyond_stress, overrun},
                        {"writes_beyond_large_batches", writes_beyond_large_batches, overrun},
                        {"leaves_a_component", leaves_a_component, overrun},
                        {"writes_its_input", writes_its_input, overrun},
                        {"pressed_at_rest", pressed_at_rest, stress_at_rest},
                        {"half_initial_stress", half_initial_stress, initial_stress},
                        {"initial_stress_in_another_order", initial_stress_in_another_order, components_swapped},
                        {"creeps_at_rest", creeps_at_rest, drifts},
                        {"noise_of_its_own", noise_of_its_own, no_convergence},
                        {"swallows_nan", swallows_nan, not_a_number}};
  std::vector<Subject> subjects;
  add(subjects, table(), planted);
  return subjects;
}

}  // namespace assay::check_tests
