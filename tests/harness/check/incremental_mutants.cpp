// SPDX-License-Identifier: BSD-3-Clause
// The incremental model as a table, and what is planted in it.
#include <string>
#include <vector>

#include "harness/check/battery.hpp"
#include "tests/harness/check/incremental_model.hpp"

namespace assay::check_tests::incremental_mutants {

namespace {

using namespace incremental;

std::int32_t initial_state(void* self, std::size_t n, const double* cauchy, double* state) {
  const auto& m = *static_cast<const Model*>(self);
  std::memset(state, 0, state_size * n * sizeof *state);
  for (std::size_t q = 0; q < n; ++q) {
    Tensor sigma = read(cauchy, n, q);
    if (m.defect == half_initial_stress) sigma *= 0.5;
    if (m.defect == drops_initial_stress) sigma.setZero();
    if (m.defect == initial_stress_in_another_order) sigma = exchanged(sigma);
    write(sigma, state, n, q, stress_at);
    if (m.defect == yields_as_at_first) state[p_at * n + q] = worked;
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

std::vector<Subject> subjects() {
  using namespace check::causes;
  const Planted planted{{"hughes_winget", hughes_winget, ""},
                        {"green_naghdi", green_naghdi, ""},
                        {"logarithmic", logarithmic, ""},
                        {"exponential_spin", exponential_spin, ""},
                        {"two_half_rotations", two_half_rotations, ""},
                        {"yields_as_at_first", yields_as_at_first, forgotten},
                        {"no_rotation", no_rotation, rotation_missing},
                        {"opposite_spin", opposite_spin, wrong_spin},
                        {"half_spin", half_spin, wrong_spin},
                        {"double_spin", double_spin, wrong_spin},
                        {"euler_spin", euler_spin, explicit_spin},
                        {"double_euler_spin", double_euler_spin, wrong_spin},
                        {"opposite_euler_spin", opposite_euler_spin, wrong_spin},
                        {"fixed_back_stress", fixed_back_stress, state_not_rotated},
                        {"back_stress_kept_in_the_reference", back_stress_kept_in_the_reference, wrong_role},
                        {"back_stress_turned_back", back_stress_turned_back, wrong_spin},
                        {"swapped_back_stress", swapped_back_stress, components_swapped},
                        {"back_stress_as_strain", back_stress_as_strain, shear_factor},
                        {"swapped_stress", swapped_stress, components_swapped},
                        {"voigt_stress", voigt_stress, other_order},
                        {"cycled_strain", cycled_strain, other_order},
                        {"cycled_rotation", cycled_rotation, other_order},
                        {"voigt_back_stress", voigt_back_stress, other_order},
                        {"swapped_strain", swapped_strain, components_swapped},
                        {"swapped_rotation", swapped_rotation, components_swapped},
                        {"engineering_shear", engineering_shear, shear_factor},
                        {"halved_shear", halved_shear, shear_factor},
                        {"small_increment", small_increment, small_strain},
                        {"stiffer_axis", stiffer_axis, not_isotropic},
                        {"hidden_stress", hidden_stress, hidden_state},
                        {"hidden_counter", hidden_counter, hidden_state},
                        {"shared_scratch", shared_scratch, of_batch},
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
                        {"swallows_nan", swallows_nan, not_a_number},
                        {"flows_by_an_absent_routine", flows_by_an_absent_routine, missing_routine},
                        {"refuses_to_flow", refuses_to_flow, refuses},
                        {"shear_once_in_norm", shear_once_in_norm, shear_factor},
                        {"swapped_flow", swapped_flow, components_swapped},
                        {"drops_initial_stress", drops_initial_stress, initial_stress},
                        {"overshooting_return", overshooting_return, no_convergence},
                        {"hardens_by_the_step", hardens_by_the_step, drifts},
                        {"rotation_of_F", rotation_of_F, wrong_spin},
                        {"infinite_first_slope", infinite_first_slope, not_finite},
                        {"back_stress_feeds_itself", back_stress_feeds_itself, dissipation},
                        {"unloading_undoes_flow", unloading_undoes_flow, dissipation},
                        {"refuses_by_the_last_digits", refuses_by_the_last_digits, refuses}};
  std::vector<Subject> subjects;
  add(subjects, table(), planted);
  static const assay_material scalars = [] {
    static std::vector<std::string> names;
    for (std::size_t c = 0; c < state_size; ++c) names.push_back("s" + std::to_string(c + 1));
    static std::vector<assay_state_variable> each;
    for (const std::string& name : names) each.push_back({name.c_str(), "1", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, "scalar"});
    assay_material t = *table();
    t.state = each.data();
    t.state_count = state_size;
    return t;
  }();
  add(subjects, &scalars,
      {{"hughes_winget_in_scalars", hughes_winget, ""},
       {"euler_spin_in_scalars", euler_spin, explicit_spin},
       {"double_euler_spin_in_scalars", double_euler_spin, wrong_spin},
       {"opposite_euler_spin_in_scalars", opposite_euler_spin, wrong_spin},
       {"half_spin_in_scalars", half_spin, wrong_spin}});
  static const assay_material silent = [] {
    assay_material t = *table();
    t.flags &= ~ASSAY_USES_INCREMENT;
    return t;
  }();
  add(subjects, &silent, {{"increments_that_are_not_declared", hughes_winget, undeclared_increment}});
  return subjects;
}

}  // namespace assay::check_tests::incremental_mutants
