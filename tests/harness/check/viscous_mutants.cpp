// SPDX-License-Identifier: BSD-3-Clause
// What relaxes: a generalised Maxwell solid with two overstresses in another state, and a Maxwell liquid whose state is
// its stress; a parameter plants one defect.
#include <algorithm>
#include <utility>

#include "harness/check/battery.hpp"
#include "harness/check/tangents.hpp"
#include "tests/harness/check/model_table.hpp"

namespace assay::check_tests::viscous_mutants {

namespace {

enum Defect : int {
  none,
  unturned,
  slow_unturned,
  turned_back,
  half_turned,
  swapped,
  turned_as_strain,
  doubled_in_state,
  explicit_convection,
  own_clock,
  forgets_at_zero,
  first_call,
  static_maximum,
  of_last_call,
  tangent_of_nothing,
  kirchhoff_tangent,
  tangent_of_solid,
  small_strain_solid,
  swapped_in_part,
  doubled_in_part,
  small_strain_in_part,
  refuses_short_steps,
  relaxes_by_the_step,
  grows,
  wrong_branch,
  explicit_relaxation,
  relaxes_in_the_next_step,
  kept_in_another_order,
  kept_doubled,
  kept_in_the_reference,
  integral_in_single_precision,
  swells,
  defects
};

/// Rotation and logarithmic strain of a step, in the axes of its beginning.
struct Increment {
  Tensor R, strain;
};

Increment increment_of(const PointStep& step) {
  const Tensor f = step.F1 * step.F0.inverse(), R = polar(f);
  return {R, logarithm(R.transpose() * f)};
}

/// A tensor of the state as the step carries it on.
Tensor carried(int defect, const Tensor& R, const Tensor& A) {
  switch (defect) {
    case unturned:
      return A;
    case turned_back:
      return R.transpose() * A * R;
    case half_turned: {
      const Tensor half = polar(R + Tensor::Identity());
      return half * A * half.transpose();
    }
    case turned_as_strain:
      return sheared(R * sheared(A, 0.5) * R.transpose(), 2);
    case explicit_convection: {
      const Tensor w = 0.5 * (R - R.transpose());
      return A + w * A - A * w;
    }
    default:
      return R * A * R.transpose();
  }
}

/// The strain of an overstress, in the axes of the step's beginning.
Tensor strain_of_part(int defect, const PointStep& step, const Tensor& R, const Tensor& strain) {
  switch (defect) {
    case swapped_in_part:
      return exchanged(strain);
    case doubled_in_part:
      return sheared(strain, 2);
    case small_strain_in_part: {
      const Tensor difference = step.F1 - step.F0;
      return R.transpose() * (0.5 * (difference + difference.transpose())) * R;
    }
    default:
      return strain;
  }
}

/// 11, 12, 13, 22, 23, 33 where 11, 22, 33, 12, 13, 23 are asked for, or back from there.
Tensor by_rows(const Tensor& q, bool back) {
  constexpr int asked[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}},
                kept[6][2] = {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}};
  Tensor result;
  for (int c = 0; c < 6; ++c) {
    const auto& from = back ? asked[c] : kept[c];
    const auto& to = back ? kept[c] : asked[c];
    result(to[0], to[1]) = result(to[1], to[0]) = q(from[0], from[1]);
  }
  return result;
}

/// An overstress as the state keeps it, whatever its role says, or back from there.
Tensor kept(int defect, const Tensor& F, const Tensor& q, bool back) {
  const Tensor R = polar(F);
  switch (defect) {
    case kept_in_another_order:
      return by_rows(q, back);
    case kept_doubled:
      return sheared(q, back ? 0.5 : 2);
    case kept_in_the_reference:
      return back ? Tensor(R * q * R.transpose()) : Tensor(R.transpose() * q * R);
    default:
      return q;
  }
}

/// (1 - exp(-x)) / x, the mean of what is left of a rate: to 24 bits, of which a small x keeps none.
double integral_of_24_bits(double x) {
  const float f = static_cast<float>(x);
  return (1.0F - std::exp(-f)) / f;
}

/// What is left of a stress after x times the time of relaxation.
double left_of(int defect, double x) {
  return defect == explicit_relaxation ? 1 - x : defect == relaxes_in_the_next_step ? 1 : std::exp(-x);
}

/// Hencky's law beside two overstresses that relax.
struct Solid {
  static constexpr std::size_t state_size = 12;
  double mu, bulk, share[2], time[2];
  int defect;

  explicit Solid(const double* p)
      : mu(p[0]), bulk(p[1]), share{p[2], p[3]}, time{p[4], p[5]}, defect(static_cast<int>(p[6])) {}

  bool rest(const Tensor& cauchy, double* state) const {
    write_symmetric(kept(defect, Tensor::Identity(), cauchy, false), state);
    return true;
  }

  Tensor elastic(const Tensor& F) {
    const Tensor e = defect == small_strain_solid ? Tensor(0.5 * (F + F.transpose()) - Tensor::Identity())
                                                  : Tensor(0.5 * logarithm(F * F.transpose()));
    double weakened = 1;
    if (defect == static_maximum) {
      statics.largest = std::max(statics.largest, e.norm());
      weakened = std::exp(-statics.largest);
    }
    return weakened * (2 * mu * deviator(e) + bulk * e.trace() * Tensor::Identity()) / F.determinant();
  }

  std::optional<Tensor> take(const PointStep& step, const double* state0, double* state1) {
    if (defect == refuses_short_steps && step.dt < 1e-5) return std::nullopt;
    const auto [R, strain] = increment_of(step);
    Tensor sigma = elastic(step.F1);
    if (defect == own_clock) sigma *= 1 + 0.05 * std::exp(-step.t);
    for (std::size_t k = 0; k < 2; ++k) {
      const int here = defect == slow_unturned ? (k == 1 ? unturned : none) : defect;
      const double time_of_step = defect == relaxes_by_the_step ? 0.01 : defect == grows ? -step.dt : step.dt;
      const double left = left_of(defect, time_of_step / time[k]);
      const double middle = defect == integral_in_single_precision ? integral_of_24_bits(time_of_step / time[k])
                                                                   : std::exp(-0.5 * time_of_step / time[k]);
      const Tensor before = left * kept(defect, step.F0, read_symmetric(state0 + 6 * k), true);
      const Tensor own = strain_of_part(defect, step, R, strain);
      const double sign = defect == wrong_branch && k == 1 ? -1 : 1;
      const Tensor added = R * (2 * mu * sign * share[k] * middle * deviator(own)) * R.transpose();
      Tensor q = carried(here, R, before) + added;
      if (defect == forgets_at_zero && step.t == 0) q = added;
      sigma += q;
      if (defect == swapped) q = exchanged(q);
      if (defect == doubled_in_state) q = sheared(q, 2);
      write_symmetric(kept(defect, step.F1, q, false), state1 + 6 * k);
    }
    if (defect == first_call && !std::exchange(statics.called, true)) sigma *= 0.5;
    return sigma;
  }

  void misbehave(std::size_t, double*, double*) const {}
};

/// A Maxwell liquid: the whole stress is in the state, its deviator relaxes.
struct Liquid {
  static constexpr std::size_t state_size = 6;
  double mu, bulk, time;
  int defect;

  explicit Liquid(const double* p) : mu(p[0]), bulk(p[1]), time(p[4]), defect(static_cast<int>(p[6])) {}

  bool rest(const Tensor& cauchy, double* state) const {
    write_symmetric(cauchy, state);
    return true;
  }

  std::optional<Tensor> take(const PointStep& step, const double* state0, double* state1) {
    const auto [R, strain] = increment_of(step);
    Tensor before = read_symmetric(state0);
    if (defect == of_last_call) before = statics.of_point.try_emplace(0, before).first->second;
    const double left = left_of(defect, step.dt / time);
    const Tensor old = left * deviator(before) + sphere(before);
    const double middle =
        defect == integral_in_single_precision ? integral_of_24_bits(step.dt / time) : std::exp(-0.5 * step.dt / time);
    const double swollen = defect == swells ? 0.1 * step.dt : 0;
    const Tensor added =
        2 * mu * middle * deviator(strain) + bulk * (strain.trace() - 3 * swollen) * Tensor::Identity();
    Tensor sigma = carried(defect, R, old) + R * added * R.transpose();
    if (defect == of_last_call) statics.of_point[0] = sigma;
    if (defect == swapped) sigma = exchanged(sigma);
    const Tensor next = deviator(sigma) * (1 - step.dt / time) + sphere(sigma);
    write_symmetric(defect == relaxes_in_the_next_step ? next : sigma, state1);
    return sigma;
  }

  void misbehave(std::size_t, double*, double*) const {}
};

/// d sigma / d F1 by differences of fourth order.
std::int32_t tangent(void* self, const assay_step* step, std::size_t n, const double* state0, double* out) {
  auto& model = *static_cast<Solid*>(self);
  constexpr double h = 1e-4;
  for (std::size_t p = 0; p < n; ++p) {
    const PointStep at = Calls<Solid>::step_of(*step, n, p);
    const auto before = Calls<Solid>::state_of(state0, n, p);
    const auto stress = [&](int c, double by) {
      PointStep moved = at;
      component(moved.F1, c) += by;
      auto ignored = before;
      return model.defect == tangent_of_solid ? model.elastic(moved.F1)
                                              : *model.take(moved, before.data(), ignored.data());
    };
    check::Tangent A;
    for (int c = 0; c < 9; ++c) {
      const Tensor d = (8 * (stress(c, h) - stress(c, -h)) - (stress(c, 2 * h) - stress(c, -2 * h))) / (12 * h);
      for (int r = 0; r < 9; ++r) A(r, c) = component(d, r);
    }
    constexpr std::size_t of_kirchhoff = 2;
    if (model.defect == kirchhoff_tangent) A = check::other_conventions(A, stress(0, 0), at.F1)[of_kirchhoff].second;
    if (model.defect == tangent_of_nothing) A(4, 4) = NAN;
    for (std::size_t k = 0; k < 81; ++k) out[k * n + p] = A(static_cast<int>(k / 9), static_cast<int>(k % 9));
  }
  return ASSAY_GOOD;
}

const void* extension(const char* id) {
  static const assay_tangent tangents{sizeof(assay_tangent), tangent};
  return std::string(id) == ASSAY_EXTENSION_TANGENT ? &tangents : nullptr;
}

constexpr assay_state_variable overstress{"overstress", "Pa", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_PLAIN, "fast"},
    slow{"slow_overstress", "Pa", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_PLAIN, "slow"},
    stress{"stress", "Pa", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_PLAIN, "Cauchy stress"};

}  // namespace

std::vector<Subject> subjects() {
  using namespace check::causes;
  static const assay_parameter parameters[] = {
      {"modulus", "Pa", 400, 0, 1e12, "of shear"},    {"bulk", "Pa", 900, 0, 1e12, "modulus"},
      {"share", "1", 1, 0, 1e3, "of the overstress"}, {"slow_share", "1", 0.7, 0, 1e3, "of the slow one"},
      {"time", "s", 0.3, 0, 1e12, "of relaxation"},   {"slow_time", "s", 5, 0, 1e12, "of the slow one"},
      {"defect", "1", 0, 0, defects - 1, "which"}};
  static const assay_state_variable two[] = {overstress, slow}, one[] = {stress};
  static const assay_state_variable two_of_their_own[] = {
      {"overstress", "Pa", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_ROTATES_ITSELF, "fast"},
      {"slow_overstress", "Pa", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_ROTATES_ITSELF, "slow"}};
  constexpr std::uint32_t flags = ASSAY_RATE_DEPENDENT | ASSAY_USES_INCREMENT;
  static const assay_material solid = [] {
    assay_material t = table_of<Solid>("solid_for_tests", flags, parameters, two);
    t.extension = extension;
    return t;
  }();
  static const assay_material liquid = table_of<Liquid>("liquid_for_tests", flags, parameters, one);
  static const assay_material silent = [] {
    assay_material t = liquid;
    t.flags &= ~ASSAY_USES_INCREMENT;
    return t;
  }();
  std::vector<Subject> all;
  add(all, &solid, {{"zener", none, ""}}, {{"slow_share", 0}});
  add(all, &solid, {{"brief_zener", none, ""}, {"unturned_brief_overstress", unturned, state_not_rotated}},
      {{"slow_share", 0}, {"time", 0.02}});
  add(all, &solid,
      {{"generalised_maxwell", none, ""},
       {"unturned_overstress", unturned, state_not_rotated},
       {"unturned_slow_overstress", slow_unturned, state_not_rotated},
       {"overstress_kept_in_another_order", kept_in_another_order, wrong_role},
       {"overstress_kept_doubled", kept_doubled, wrong_role},
       {"overstress_kept_in_the_reference", kept_in_the_reference, wrong_role},
       {"overstress_turned_back", turned_back, wrong_spin},
       {"swapped_overstress", swapped, components_swapped},
       {"overstress_turned_as_strain", turned_as_strain, shear_factor},
       {"overstress_of_engineering_shear", doubled_in_state, shear_factor},
       {"overstress_of_swapped_strain", swapped_in_part, components_swapped},
       {"overstress_of_doubled_shear", doubled_in_part, shear_factor},
       {"overstress_of_small_strain", small_strain_in_part, small_strain},
       {"refuses_short_steps", refuses_short_steps, refuses},
       {"relaxes_by_the_step", relaxes_by_the_step, drifts},
       {"viscous_clock", own_clock, clock},
       {"forgets_at_zero", forgets_at_zero, clock},
       {"viscous_first_call", first_call, hidden_state},
       {"static_maximum", static_maximum, hidden_state},
       {"tangent_of_nothing", tangent_of_nothing, tangent_wrong},
       {"tangent_of_solid", tangent_of_solid, tangent_wrong},
       {"viscous_kirchhoff_tangent", kirchhoff_tangent, tangent_convention},
       {"viscous_small_strain", small_strain_solid, small_strain}});
  add(all, &liquid,
      {{"maxwell", none, ""},
       {"unturned_liquid", unturned, rotation_missing},
       {"liquid_turned_back", turned_back, wrong_spin},
       {"liquid_turned_by_half", half_turned, wrong_spin},
       {"explicit_convection", explicit_convection, explicit_spin},
       {"liquid_turned_as_strain", turned_as_strain, shear_factor},
       {"swapped_liquid", swapped, components_swapped},
       {"stress_of_the_last_call", of_last_call, hidden_state},
       {"liquid_of_24_bits", integral_in_single_precision, single_precision},
       {"swelling_liquid", swells, check::causes::grows}});
  add(all, &solid, {{"growing_overstress", grows, dissipation}}, {{"share", 4}});
  add(all, &solid, {{"overstress_of_24_bits", integral_in_single_precision, single_precision}}, {{"share", 20}});
  add(all, &solid, {{"branch_that_relaxes_the_wrong_way", wrong_branch, dissipation}});
  const std::pair<const char*, double> liquids[] = {{"liquid_of_explicit_relaxation", 30},
                                                    {"brief_liquid_of_explicit_relaxation", 0.01},
                                                    {"fast_liquid_of_explicit_relaxation", 1e-3}};
  for (const auto& [name, time] : liquids)
    add(all, &liquid, {{name, explicit_relaxation, dissipation}}, {{"time", time}});
  add(all, &liquid, {{"liquid_that_relaxes_in_the_next_step", relaxes_in_the_next_step, dissipation}}, {{"time", 10}});
  add(all, &liquid, {{"brief_one_that_relaxes_in_the_next_step", relaxes_in_the_next_step, dissipation}},
      {{"time", 0.01}});
  const std::pair<const char*, double> solids[] = {{"explicit_relaxation", 1}, {"slow_explicit_relaxation", 1e3}};
  for (const auto& [name, time] : solids) {
    add(all, &solid, {{name, explicit_relaxation, dissipation}}, {{"slow_share", 0}, {"time", time}});
  }
  static const assay_material own = table_of<Solid>("own_for_tests", flags, parameters, two_of_their_own);
  add(all, &own, {{"unturned_overstress_that_should_turn_itself", unturned, state_not_rotated}});
  add(all, &silent, {{"liquid_that_says_nothing_of_increments", none, undeclared_increment}});
  return all;
}

}  // namespace assay::check_tests::viscous_mutants
