// SPDX-License-Identifier: BSD-3-Clause
// The names of the tests and of the causes: what reports, scenes of replays and docs/check.md are written in.
#pragma once

namespace assay::check {

/// The tests, in their order.
namespace ids {
inline constexpr const char* arrays = "calls.arrays";
inline constexpr const char* loading = "loading";
inline constexpr const char* repeated = "calls.repeated";
inline constexpr const char* batch = "calls.batch";
inline constexpr const char* alignment = "calls.alignment";
inline constexpr const char* clock = "clock";
inline constexpr const char* continuity = "continuity";
inline constexpr const char* rest = "rest";
inline constexpr const char* symmetry = "symmetry";
inline constexpr const char* zero_increment = "zero_increment";
inline constexpr const char* shear_components = "elasticity.components";
inline constexpr const char* shear_modulus = "elasticity.shear";
inline constexpr const char* positive_stiffness = "elasticity.positive";
inline constexpr const char* class_at_rest = "elasticity.class";
inline constexpr const char* major_symmetry = "elasticity.major";
inline constexpr const char* constant_rotation = "rotation.constant";
inline constexpr const char* basis = "basis";
inline constexpr const char* isotropy = "isotropy";
inline constexpr const char* class_in_loading = "symmetry_class";
inline constexpr const char* rotation_at_rest = "rotation.at_rest";
inline constexpr const char* rotation_before = "rotation.before";
inline constexpr const char* rotation_during = "rotation.during";
inline constexpr const char* rotation_after = "rotation.after";
inline constexpr const char* rotation_at_apex = "rotation.apex";
inline constexpr const char* fixed_stretch = "rotation.fixed_stretch";
inline constexpr const char* revolutions = "rotation.revolutions";
inline constexpr const char* rotation_of_state = "rotation.state";
inline constexpr const char* nearly_equal_stretches = "stretches.nearly_equal";
inline constexpr const char* turning_stretches = "stretches.turning";
inline constexpr const char* initial_stress = "initial_stress";
inline constexpr const char* step_halving = "step_halving";
inline constexpr const char* jumps = "jumps";
inline constexpr const char* memory = "memory";
inline constexpr const char* tangent = "tangent";
inline constexpr const char* energy = "energy";
inline constexpr const char* rate = "rate";
inline constexpr const char* wave_speed = "wave_speed";
inline constexpr const char* closed_form = "closed_form";
inline constexpr const char* dissipation = "dissipation";
inline constexpr const char* ellipticity = "ellipticity";
inline constexpr const char* increment = "calls.increment";
inline constexpr const char* refused = "calls.refused";
inline constexpr const char* threads = "calls.threads";
inline constexpr const char* bits = "calls.bits";
inline constexpr const char* senseless = "calls.senseless";
}  // namespace ids

/// The causes that a diagnosis can name, in the order in which it lists them.
namespace causes {
inline constexpr const char* components_swapped = "components 13 and 23 swapped";
inline constexpr const char* other_order = "components in another order";
inline constexpr const char* shear_factor = "shear factor 2";
inline constexpr const char* wrong_sign = "component of the wrong sign";
inline constexpr const char* small_strain = "small-strain law used at finite strain";
inline constexpr const char* rotation_missing = "increment rotation missing";
inline constexpr const char* wrong_spin = "wrong spin";
inline constexpr const char* explicit_spin = "explicit spin grows stress";
inline constexpr const char* state_not_rotated = "state variable not rotated";
inline constexpr const char* wrong_role = "state variable with a wrong role";
inline constexpr const char* not_isotropic = "material not isotropic";
inline constexpr const char* not_of_class = "material not of the declared symmetry";
inline constexpr const char* not_positive = "stiffness not positive";
inline constexpr const char* repeated_stretch = "unstable at repeated principal stress";
inline constexpr const char* tangent_convention = "tangent of another convention";
inline constexpr const char* tangent_wrong = "tangent wrong";
inline constexpr const char* hidden_state = "hidden state";
inline constexpr const char* not_reproducible = "not reproducible";
inline constexpr const char* of_batch = "depends on its batch";
inline constexpr const char* of_alignment = "depends on alignment";
inline constexpr const char* kept_by_element = "state kept by element";
inline constexpr const char* host_counters = "depends on the host's counters";
inline constexpr const char* clock = "clock";
inline constexpr const char* overrun = "overrun";
inline constexpr const char* state_undeclared = "state not declared";
inline constexpr const char* properties_missing = "properties missing";
inline constexpr const char* undeclared_increment = "increment read undeclared";
inline constexpr const char* not_indifferent = "not frame-indifferent";
inline constexpr const char* stress_at_rest = "stress at rest";
inline constexpr const char* initial_stress = "initial stress not carried";
inline constexpr const char* drifts = "changes at zero strain increment";
inline constexpr const char* no_convergence = "does not converge with the step";
inline constexpr const char* jump = "stress jumps";
inline constexpr const char* forgotten = "state variable forgotten";
inline constexpr const char* energy = "energy not consistent with stress";
inline constexpr const char* rate_form = "rate form not consistent with stress";
inline constexpr const char* wave_speed = "wave speed too low";
inline constexpr const char* closed_form = "closed form not consistent with stress";
inline constexpr const char* dissipation = "negative dissipation";
inline constexpr const char* not_a_number = "numbers out of nothing";
inline constexpr const char* no_stress = "no stress";
inline constexpr const char* refuses = "refuses a step";
inline constexpr const char* refuses_length = "refuses the length of a step";
inline constexpr const char* missing_routine = "routine missing";
inline constexpr const char* not_reached = "strain not reached";
inline constexpr const char* grows = "strain of its own in time";
inline constexpr const char* single_precision = "single precision";
inline constexpr const char* not_finite = "stress or state not finite";
inline constexpr const char* not_symmetric = "stress not symmetric";
inline constexpr const char* ends_process = "ends the process";
inline constexpr const char* disturbs_process = "disturbs its process";
inline constexpr const char* other_stress = "vortex not reproduced";
}  // namespace causes

}  // namespace assay::check
