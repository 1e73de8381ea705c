// SPDX-License-Identifier: BSD-3-Clause
// The tests of the battery, and what some of them tell the diagnosis beyond their verdicts.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/check/arrays.hpp"
#include "harness/check/call_steps.hpp"
#include "harness/check/judge.hpp"
#include "harness/check/specimen.hpp"
#include "harness/check/symmetry_class.hpp"
#include "harness/check/turned_step.hpp"

namespace assay::check {

/// The tests that need nothing but a specimen, in their order; each is described where it is defined.
using Test = TestResult(const Specimen& specimen);
Test alignment, clock_independence, continuity, stress_at_rest, symmetry, zero_increment, shear_components,
    shear_modulus, positive_stiffness, major_symmetry, constant_rotation, change_of_basis, isotropy, rotation_at_apex,
    revolutions, nearly_equal_stretches, rotation_at_equal_stretches, initial_stress, step_halving, jumps, memory,
    tangent, energy, rate_form, wave_speed, closed_form, dissipation, ellipticity, undeclared_increment, refusals,
    threads, senseless_deformation;

/// Whether the stress at F = I is a pressure, the same in every frame.
bool pressed_at_rest(const Specimen& specimen);

/// Whether a stress comes up at F = I that depends on the time alone, not on the number of steps: growth, swelling, a
/// temperature of its own.
bool grows_at_rest(const Specimen& specimen);

/// Whether the stress of a small strain from rest is not symmetric: an error of the answer alone, whatever turns.
bool asymmetric_at_rest(const Specimen& specimen);

/// Name of a tensor or vector of the state that changes in steps without deformation, and in no time; empty where there
/// is none. No defect where the stress does not show it.
std::string drifting_variable(const Specimen& specimen);

/// A finding about the stiffness at rest.
struct ClassFinding {
  TestResult result;
  std::vector<ClassFit> axes = {};  ///< of the class declared, that suit the stiffness best
  bool fits_no_class = false;       ///< at all
};

/// The stiffness at rest is of the class declared. Fails with `shear_factor` or `components_swapped` where that alone
/// keeps it from being so.
ClassFinding class_at_rest(const Specimen& specimen);

/// Body and frame turned by the rotations of the class: F' = Q F Q^T, sigma' = Q sigma Q^T along the loading. at_rest:
/// axes that suit the stiffness at rest; empty where they are not known.
TestResult class_in_loading(const Specimen& specimen, std::vector<ClassFit> at_rest);

/// Whether rotation.constant is right of a stretch along axes that stand still, which no spin enters.
bool right_without_spin(const Specimen& specimen);

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

/// The frame turns while the stretch is held: exact for any increment that keeps rotations apart.
RotationFinding rotation_at_fixed_stretch(const Specimen& specimen);

/// A rigid rotation from rest leaves no stress.
RotationFinding rotation_at_rest(const Specimen& specimen);

/// The tensors and vectors of the state after a rotation at fixed stretch. One that did not turn is no defect by
/// itself: a model may keep it in a frame of its own.
RotationFinding rotation_of_state(const Specimen& specimen);

/// A failure of `step_halving` where a body that depends on the rate is held and bears another stress than one that
/// hardly moves, or where a loaded body answers to short strains with less than a hundredth of the stress that longer
/// ones make in proportion; nothing where it does not, or where its longer steps make none.
std::optional<TestResult> short_steps(const Specimen& specimen);

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

// Why a material cannot be loaded at all, how far and in which steps it can, and what the tests have not seen of it.

/// A failure of the material in a test: a finding with the step that fails. cause: where its twin stands the same; null
/// where it is that failure alone.
TestResult refused(const std::string& id, const char* cause, const MaterialFailure& failure);

/// Of a material that fails before any test can be made: what of its first steps it does not stand.
TestResult not_loaded(const Material& material, const std::runtime_error& error);

/// Of a material that answers in a straight line as far as it is finite.
TestResult not_finite_beyond(const MaterialFailure& failure);

/// Of a material that no small strain gives a stress.
TestResult without_stress(const Material& material);

/// A failed test of a material that does not stand the strain that was asked for, refuses the kink that it declares, or
/// calls a routine that is not there; nothing where there is none of these.
std::optional<TestResult> not_reached(const Specimen& specimen);

/// What a pass says nothing of, as parts of a sentence: "strains above 0.01".
std::vector<std::string> not_tested(const Specimen& specimen);

/// The longest step [s] of tests of a rate-dependent material that relaxes in much less time than their usual steps
/// take. Nothing where it does not: whatever is left in such steps is all that it has.
std::optional<double> own_pace(const Material& material, const Report& report);

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
  bool asymmetric_at_rest = false;  ///< the stress of a small strain from rest
  bool pressed_at_rest = false;     ///< what stress there is at rest is a pressure
  bool grows_at_rest = false;       ///< a stress at rest that time brings, and not steps
  std::string growth_declaration;   ///< how the author of a model declares that
  std::string overshoots;           ///< what a body that is held does in a step longer than its time of relaxation
  std::string drifting;             ///< a variable of the state that changes in steps without deformation
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
