// SPDX-License-Identifier: BSD-3-Clause
// The tests of the battery, and what some of them tell the diagnosis beyond their verdicts.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/check/arrays.hpp"
#include "harness/check/call_steps.hpp"
#include "harness/check/specimen.hpp"
#include "harness/check/symmetry_class.hpp"
#include "harness/check/turned_step.hpp"

namespace assay::check {

// What must hold without any comparison: where nothing is deformed, or nothing more, nothing happens.

/// F = I leaves no stress.
TestResult stress_at_rest(const Specimen& specimen);

/// sigma = sigma^T along the loading, which turns.
TestResult symmetry(const Specimen& specimen);

/// Steps with F1 = F0 after loading change neither stress nor state of a rate-independent model; of another one, in
/// the limit of no time.
TestResult zero_increment(const Specimen& specimen);

/// Whether the stress at F = I is a pressure, the same in every frame.
bool pressed_at_rest(const Specimen& specimen);

/// Whether a stress comes up at F = I that depends on the time alone, not on the number of steps: growth, swelling, a
/// temperature of its own.
bool grows_at_rest(const Specimen& specimen);

/// Name of a tensor or vector of the state that changes in steps without deformation, and in no time; empty where there
/// is none. No defect where the stress does not show it.
std::string drifting_variable(const Specimen& specimen);

/// initial_state takes a stress, or refuses it; a step without deformation returns it, and it turns with the body.
TestResult initial_stress(const Specimen& specimen);

// The stiffness at rest.

/// Shears couple to their own stress alone: 13 to 13, 23 to 23. Fails with the cause of an order
/// where they lie in another one.
TestResult shear_components(const Specimen& specimen);

/// The shear modulus follows from the axial stiffness: sigma_12 = (C11 - C12) eps_12. Fails with `shear_factor` where
/// it is twice or half that.
TestResult shear_modulus(const Specimen& specimen);

/// The smallest eigenvalue of the stiffness at rest, where that is linear, over its largest component: below zero a
/// strain makes a stress that drives it on. None is right of a fluid in shear. Of what depends on the rate the
/// stiffness that is left in the end counts as well.
TestResult positive_stiffness(const Specimen& specimen);

/// A finding about the stiffness at rest.
struct ClassFinding {
  TestResult result;
  std::vector<ClassFit> axes = {};  ///< of the class declared, that suit the stiffness best
  bool fits_no_class = false;       ///< at all
};

/// The stiffness at rest is of the class declared. Fails with `shear_factor` or `components_swapped` where that alone
/// keeps it from being so.
ClassFinding class_at_rest(const Specimen& specimen);

/// The stiffness at rest of what declares a class is symmetric: C = C^T. Without that a cycle of small strains brings
/// work out of nothing.
TestResult major_symmetry(const Specimen& specimen);

/// Body and frame turned by the rotations of the class: F' = Q F Q^T, sigma' = Q sigma Q^T along the loading. at_rest:
/// axes that suit the stiffness at rest; empty where they are not known.
TestResult class_in_loading(const Specimen& specimen, std::vector<ClassFit> at_rest);

// Frames that are turned once for all.

/// Orientation of the frame from the beginning on; sigma = Q sigma_0 Q^T.
TestResult constant_rotation(const Specimen& specimen);

/// The same of a stretch along axes that stand still, which no spin enters: whether it is right.
bool right_without_spin(const Specimen& specimen);

/// Body and frame turned: F' = Q F Q^T.
TestResult change_of_basis(const Specimen& specimen);

/// The body alone turned before it is loaded: F' = F Q^T, sigma' = sigma for isotropic materials.
TestResult isotropy(const Specimen& specimen);

// Frames that turn.

/// A test, and what else it tells the diagnosis.
struct RotationFinding {
  TestResult result;
  /// Of the stress that was found: it is turned by this many times the frame's angle. Null where it is not turned as a
  /// whole, or rightly.
  std::optional<double> turned = {};
  /// The same of one small turn, in which a step that is no rotation is no error yet. Null where the stress is not
  /// turned as a whole.
  std::optional<double> spin = {};
  /// At rest: stress over that of the strain sym(Q - I), which a small-strain law takes for one.
  double small_strain = 0;
  double relaxing_small_strain = 0;  ///< the same of a part that relaxes
  std::string left_behind = {};      ///< names of tensors and vectors of the state that have not turned with the stress
};

/// Before, while and after it is loaded, and after an expansion that may have come to an apex, by 2.3 rad about
/// (1, 2, 3).
enum class When { before, during, after, apex };
TestResult rotation(const Specimen& specimen, When when);

/// When::apex at an amplitude that the material stands, if there is one.
TestResult rotation_at_apex(const Specimen& specimen);

/// The frame turns while the stretch is held: exact for any increment that keeps rotations apart.
RotationFinding rotation_at_fixed_stretch(const Specimen& specimen);

/// Many revolutions at fixed stretch must not change the size of the stress.
TestResult revolutions(const Specimen& specimen);

/// A rigid rotation from rest leaves no stress.
RotationFinding rotation_at_rest(const Specimen& specimen);

/// The tensors and vectors of the state after a rotation at fixed stretch. One that did not turn is no defect by
/// itself: a model may keep it in a frame of its own.
RotationFinding rotation_of_state(const Specimen& specimen);

// Two or three principal stretches that are equal, or nearly so: where a spectral form divides by their difference.

/// Stretches that differ by 0, 1e-15, ... 1e-4 along axes of any direction: the stress changes no more than they do.
TestResult nearly_equal_stretches(const Specimen& specimen);

/// A rotation at equal stretches, as rotation_at_fixed_stretch.
TestResult rotation_at_equal_stretches(const Specimen& specimen);

// Steps, time and memory.

/// N, 2N, 4N, 8N steps along one path approach each other. Correct but first order in the step is no defect.
TestResult step_halving(const Specimen& specimen);

/// A failure of `step_halving` where a body that depends on the rate is held and bears another stress than one that
/// hardly moves, or where a loaded body answers to short strains with less than a hundredth of the stress that longer
/// ones make in proportion; nothing where it does not, or where its longer steps make none.
std::optional<TestResult> short_steps(const Specimen& specimen);

/// The result does not depend on the time of the day, nor that of a rate-independent model on the length of a step in
/// seconds: t from 0 and from 1e6 s, steps of 1e-9 to 1 s.
TestResult clock_independence(const Specimen& specimen);

/// A change of F in its last digits changes the stress no more than that.
TestResult continuity(const Specimen& specimen);

/// Along paths of single steps the stress jumps nowhere, unless the state does: a crack is remembered, a switch that
/// opens where the branches differ is not.
TestResult jumps(const Specimen& specimen);

/// A number of the state that no step reads, that is not zero at first and that departs from that value by what the
/// last step alone adds, is forgotten: nothing accumulates.
TestResult memory(const Specimen& specimen);

// What a model offers besides its stress, and the work of the stress.

/// assay.tangent/1 against differences of `update` at deformed states, on and off the loading branch. One that does not
/// agree is compared with those of other conventions.
TestResult tangent(const Specimen& specimen);

/// assay.energy/1: P = dW/dF at fixed state.
TestResult energy(const Specimen& specimen);

/// assay.rate/1: the rates of stress and state that steps approach as they become short.
TestResult rate_form(const Specimen& specimen);

/// assay.wave_speed/1, against the acoustic tensor of probed steps: one too low makes explicit runs unstable. Only of
/// what does not depend on the rate, whose steps are stiffer the shorter they are.
TestResult wave_speed(const Specimen& specimen);

/// assay.closed_form/1: tau and d tau / d eps along simple shear (16) and uniaxial strain (38).
TestResult closed_form(const Specimen& specimen);

/// The work done on the material is stored or dissipated, never made: against its energy along a path out, back and
/// beyond; and, of any model, from rest out and back no more comes out than was put in.
TestResult dissipation(const Specimen& specimen);

/// The smallest eigenvalue of the acoustic tensor, over the largest at rest, along simple shear (16) and uniaxial
/// strain (38); the sentence tells where it falls below zero. Never fails.
TestResult ellipticity(const Specimen& specimen);

// That `update` is a pure function of its arguments, and knows what is no number.

/// The same step again, after others, in another order, and of another instance, gives the same; so do the histories
/// that were the first of the process. `found`: the largest difference, however small.
TestResult repeated_calls(const Specimen& specimen, const std::vector<History>& first, Difference& found);

/// A step that is taken again is the same to the last bit: from arrays at other addresses that are as far beyond a
/// multiple of 64 bytes, deeper in the stack, with other words left in memory by earlier calls, in the same place of an
/// equal batch, of other instances, in another process, and at the end of the battery. `repeated`: what calls.repeated
/// has found, of which it forgives the last digits.
TestResult last_digits(const Specimen& specimen, const std::vector<History>& first, const Difference& repeated);

/// Steps in batches of many sizes, up to the largest, are those that are taken alone, but for rounding: the last points
/// of a batch are worked on by other code than those before. `alike`: what the first calls have found.
TestResult batches(const Specimen& specimen, const BatchFinding& alike);

/// Arrays that begin 8, 16, 32 bytes ... beyond a multiple of 64 give the same, but for rounding.
TestResult alignment(const Specimen& specimen);

/// A model that does not declare ASSAY_USES_INCREMENT does not read F0.
TestResult undeclared_increment(const Specimen& specimen);

/// F that is not a number, infinite, or turned inside out is refused or comes back as no number; nothing worse.
TestResult senseless_deformation(const Specimen& specimen);

/// A step that the model refuses is refused again, and leaves no trace in what it answers; and it is not the last
/// digits of F that decide what is refused.
TestResult refusals(const Specimen& specimen);

/// Two threads at once get what each gets alone: of one instance with ASSAY_THREAD_SAFE, each of its own without. A
/// race is met by chance: none that is short is sure to be found.
TestResult threads(const Specimen& specimen);

/// What the tests tell beyond their verdicts.
struct Evidence {
  RotationFinding at_rest, fixed, state;
  ClassFinding symmetry;
  std::optional<TurnedStep> turned;
  bool right_without_spin = false;  ///< rotation.constant of a stretch along axes that stand still
  FirstCalls first;                 ///< of the process
  Difference repeated;              ///< of steps that were taken again
  bool has_spin = false;            ///< steps turn something of the state
  bool has_state_that_turns = false;
  bool pressed_at_rest = false;    ///< what stress there is at rest is a pressure
  bool grows_at_rest = false;      ///< a stress at rest that time brings, and not steps
  std::string growth_declaration;  ///< how the author of a model declares that
  std::string overshoots;          ///< what a body that is held does in a step longer than its time of relaxation
  std::string drifting;            ///< a variable of the state that changes in steps without deformation
};

/// One test of the list.
struct Entry {
  const char* id;
  const char* cause_of_failure;  ///< where the material refuses a step; null: that it does
  std::function<TestResult(const Specimen&, Evidence&)> run;
  bool decides = false;  ///< where it fails, no later test can be judged
};

/// Whether results mean anything: to be taken first.
std::vector<Entry> first_entries();

std::vector<Entry> entries();

}  // namespace assay::check
