// SPDX-License-Identifier: BSD-3-Clause
// The causes that a diagnosis can name, in the order in which it lists them.
#pragma once

#include <string>
#include <vector>

#include "harness/check/names.hpp"

namespace assay::check {

inline const std::vector<std::string>& all_causes() {
  using namespace causes;
  static const std::vector<std::string> all{components_swapped,
                                            other_order,
                                            shear_factor,
                                            wrong_sign,
                                            small_strain,
                                            rotation_missing,
                                            wrong_spin,
                                            explicit_spin,
                                            state_not_rotated,
                                            wrong_role,
                                            not_isotropic,
                                            not_of_class,
                                            not_positive,
                                            repeated_stretch,
                                            tangent_convention,
                                            tangent_wrong,
                                            hidden_state,
                                            not_reproducible,
                                            of_batch,
                                            of_alignment,
                                            kept_by_element,
                                            host_counters,
                                            clock,
                                            overrun,
                                            state_undeclared,
                                            properties_missing,
                                            undeclared_increment,
                                            not_indifferent,
                                            stress_at_rest,
                                            initial_stress,
                                            drifts,
                                            no_convergence,
                                            jump,
                                            forgotten,
                                            energy,
                                            rate_form,
                                            wave_speed,
                                            closed_form,
                                            dissipation,
                                            not_a_number,
                                            no_stress,
                                            refuses,
                                            refuses_length,
                                            missing_routine,
                                            not_reached,
                                            grows,
                                            single_precision,
                                            not_finite,
                                            not_symmetric,
                                            ends_process,
                                            disturbs_process,
                                            other_stress};
  return all;
}

}  // namespace assay::check
