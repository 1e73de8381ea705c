// SPDX-License-Identifier: BSD-3-Clause
// Frame indifference: a history and the same history seen from a frame that turns.
#pragma once

#include "harness/check/judge.hpp"
#include "harness/check/specimen.hpp"

namespace assay::check {

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

}  // namespace assay::check
