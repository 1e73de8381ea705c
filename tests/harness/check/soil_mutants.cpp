// SPDX-License-Identifier: BSD-3-Clause
// Soils: a Drucker-Prager cone with an apex in increments, stiff from the first; and one without cohesion, whose
// stiffness is proportional to its pressure, so that it can be at rest under pressure alone. A parameter plants one
// defect.
#include <algorithm>

#include "harness/check/battery.hpp"
#include "tests/harness/check/model_table.hpp"

namespace assay::check_tests::soil_mutants {

namespace {

enum Defect : int {
  none,
  unturned,
  turned_back,
  euler_spin,
  swapped,
  engineering_shear,
  without_apex,
  nothing_at_apex,
  writes_while_it_flows,
  forgets_at_zero,
  dilates_with_time,
  first_call,
  static_flow,
  half_initial_stress,
  pressed_at_rest,
  creeps,
  divides_by_strain,
  corrects_the_diagonal,
  swallows_nan,
  defects
};

struct Soil {
  static constexpr std::size_t state_size = 7;  // stress, plastic strain
  double shear, bulk, cohesion, friction, dilation;
  bool by_pressure;  ///< moduli are multiples of the pressure
  int defect;
  bool has_flown = false;  ///< in this batch

  explicit Soil(const double* p)
      : shear(p[0]),
        bulk(p[1]),
        cohesion(p[2]),
        friction(p[3]),
        dilation(p[4]),
        by_pressure(p[5] > 0),
        defect(static_cast<int>(p[6])) {}

  bool rest(const Tensor& cauchy, double* state) const {
    write_symmetric((defect == half_initial_stress ? 0.5 : 1.0) * cauchy, state);
    return !by_pressure || cauchy.trace() < 0;
  }

  /// Carried on by the rotation of a step.
  Tensor turned(const Tensor& R, const Tensor& A) const {
    if (defect == unturned) return A;
    if (defect == turned_back) return R.transpose() * A * R;
    if (defect == euler_spin) {
      const Tensor w = 0.5 * (R - R.transpose());
      return A + w * A - A * w;
    }
    return R * A * R.transpose();
  }

  /// Back to the cone |s|/sqrt(2) + friction p = cohesion, p > 0 in tension. Returns the multiplier.
  double flow(double G, double K, double t, Tensor& sigma) const {
    const Tensor s = deviator(sigma);
    const double q = s.norm() / std::sqrt(2.0), p = sigma.trace() / 3, beyond = q + friction * p - cohesion;
    if (!(beyond > 0)) return 0;
    const double angle = defect == dilates_with_time ? dilation * std::exp(-t) : dilation;
    const double multiplier = beyond / (G + K * friction * angle), left = q - G * multiplier;
    if (left < 0 && defect != without_apex) {
      sigma = (defect == nothing_at_apex ? NAN : cohesion / friction) * Tensor::Identity();
      return multiplier;
    }
    Tensor back = (p - K * angle * multiplier) * Tensor::Identity() + left / q * s;
    if (defect == corrects_the_diagonal) {
      for (int i = 0; i < 3; ++i)
        back(i, (i + 1) % 3) = sigma(i, (i + 1) % 3), back((i + 1) % 3, i) = back(i, (i + 1) % 3);
    }
    sigma = back;
    return multiplier;
  }

  Tensor strain_of(const Tensor& f, const Tensor& R) const {
    Tensor e = logarithm(R.transpose() * f);
    if (defect == engineering_shear) e = sheared(e, 2);
    if (defect == divides_by_strain) e *= e.norm() / e.norm();  // as a direction and a length
    return e;
  }

  /// Secant of p = p0 exp(-bulk tr e), or 1.
  double stiffness_of(const Tensor& sigma, const Tensor& e) const {
    const double x = -bulk * e.trace();
    return by_pressure ? -sigma.trace() / 3 * (x == 0 ? 1 : std::expm1(x) / x) : 1;
  }

  std::optional<Tensor> take(const PointStep& step, const double* state0, double* state1) {
    const Tensor f = step.F1 * step.F0.inverse(), R = polar(f), e = strain_of(f, R);
    Tensor sigma = read_symmetric(state0);
    if (defect == forgets_at_zero && step.t == 0) sigma = sphere(sigma);
    const double scale = stiffness_of(sigma, e), G = scale * shear, K = scale * bulk;
    if (by_pressure && !(scale > 0)) return std::nullopt;
    sigma = turned(R, sigma) + R * (2 * G * deviator(e) + K * e.trace() * Tensor::Identity()) * R.transpose();
    if (defect == creeps) sigma *= 0.95;
    const double multiplier = flow(G, K, step.t, sigma);
    has_flown = has_flown || multiplier > 0;
    if (defect == static_flow) statics.largest = std::max(statics.largest, multiplier), sigma *= 1 - statics.largest;
    if (defect == first_call && !std::exchange(statics.called, true)) sigma *= 0.5;
    if (defect == swallows_nan && !sigma.allFinite()) sigma.setZero();
    write_symmetric(sigma, state1);
    state1[6] = state0[6] + multiplier;
    if (defect == swapped) sigma = exchanged(sigma);
    if (defect == pressed_at_rest) sigma -= 1e-3 * bulk * Tensor::Identity();
    if (by_pressure && !(sigma.trace() < 0)) return std::nullopt;
    return sigma;
  }

  /// One variable too many, where there is something to write to it.
  void misbehave(std::size_t n, double* state1, double*) {
    if (defect == writes_while_it_flows && has_flown) std::fill_n(state1 + state_size * n, n, 1.0);
    has_flown = false;
  }
};

}  // namespace

std::vector<Subject> subjects() {
  using namespace check::causes;
  static const assay_parameter parameters[] = {
      {"shear", "Pa", 400, 0, 1e12, "modulus, or its multiple of the pressure"},
      {"bulk", "Pa", 900, 0, 1e12, "the same"},
      {"cohesion", "Pa", 3, 0, 1e12, "yield stress in shear"},
      {"friction", "1", 0.3, 0, 10, "of the cone"},
      {"dilation", "1", 0.1, 0, 10, "of the flow"},
      {"by_pressure", "1", 0, 0, 1, "stiffness proportional to the pressure"},
      {"defect", "1", 0, 0, defects - 1, "which"}};
  static const assay_state_variable state[] = {
      {"stress", "Pa", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_PLAIN, "Cauchy stress"},
      {"p", "1", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, "plastic multiplier"}};
  static const assay_material soil =
      table_of<Soil>("soil_for_tests", ASSAY_NON_SMOOTH | ASSAY_USES_INCREMENT, parameters, state);
  std::vector<Subject> all;
  add(all, &soil,
      {{"cone", none, ""},
       {"unturned_cone", unturned, rotation_missing},
       {"cone_turned_back", turned_back, wrong_spin},
       {"cone_of_euler_spin", euler_spin, explicit_spin},
       {"swapped_cone", swapped, components_swapped},
       {"cone_of_engineering_shear", engineering_shear, shear_factor},
       {"cone_without_apex", without_apex, repeated_stretch},
       {"nothing_at_apex", nothing_at_apex, not_finite},
       {"writes_while_it_flows", writes_while_it_flows, overrun},
       {"cone_forgets_at_zero", forgets_at_zero, clock},
       {"dilates_with_time", dilates_with_time, clock},
       {"cone_first_call", first_call, hidden_state},
       {"static_flow", static_flow, hidden_state},
       {"half_stress_of_cone", half_initial_stress, initial_stress},
       {"cone_pressed_at_rest", pressed_at_rest, stress_at_rest},
       {"cone_creeps", creeps, drifts},
       {"divides_by_strain", divides_by_strain, not_finite},
       {"corrects_the_diagonal", corrects_the_diagonal, shear_factor},
       {"cone_of_nan", swallows_nan, not_a_number}});
  add(all, &soil,
      {{"pressed_soil", none, ""},
       {"unturned_soil", unturned, rotation_missing},
       {"soil_turned_back", turned_back, wrong_spin},
       {"soil_of_euler_spin", euler_spin, explicit_spin},
       {"swapped_soil", swapped, components_swapped},
       {"soil_of_engineering_shear", engineering_shear, shear_factor},
       {"soil_writes_while_it_flows", writes_while_it_flows, overrun},
       {"soil_forgets_at_zero", forgets_at_zero, clock},
       {"half_stress_of_soil", half_initial_stress, initial_stress},
       {"soil_creeps", creeps, drifts}},
      {{"shear", 100}, {"bulk", 150}, {"cohesion", 0}, {"friction", 0.6}, {"by_pressure", 1}});
  return all;
}

}  // namespace assay::check_tests::soil_mutants
