// SPDX-License-Identifier: BSD-3-Clause
// J2 plasticity in increments, with linear isotropic and kinematic hardening; a parameter plants one defect.
#pragma once

#include "tests/harness/check/model_table.hpp"

namespace assay::check_tests::incremental {

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
  double_euler_spin,
  opposite_euler_spin,
  fixed_back_stress,
  back_stress_turned_back,
  swapped_back_stress,
  back_stress_as_strain,
  swapped_stress,
  voigt_stress,
  cycled_strain,
  cycled_rotation,
  voigt_back_stress,
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
  shear_once_in_norm,
  swapped_flow,
  drops_initial_stress,
  overshooting_return,
  hardens_by_the_step,
  rotation_of_F,
  infinite_first_slope,
  back_stress_feeds_itself,
  yields_as_at_first,
  back_stress_kept_in_the_reference,
  unloading_undoes_flow,
  refuses_by_the_last_digits,
  flows_by_an_absent_routine,
  refuses_to_flow,
  defects
};

constexpr double worked = 0.02;  ///< p at first, of yields_as_at_first
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

void update(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1, double* cauchy,
            std::int32_t* status, double* dt_factor, char* message);

}  // namespace assay::check_tests::incremental
