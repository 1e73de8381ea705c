// SPDX-License-Identifier: BSD-3-Clause
// From verdicts to causes: which one defect explains what the tests have found.
#pragma once

#include "harness/check/arrays.hpp"
#include "harness/check/call_steps.hpp"
#include "harness/check/material_symmetry.hpp"
#include "harness/check/rotation.hpp"
#include "harness/check/turned_step.hpp"

namespace assay::check {

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

/// Fills in the cause of failed tests that have none, and lists the causes; none for one that follows from another.
std::vector<Diagnosis> diagnose(std::vector<TestResult>& tests, const Evidence& evidence);

}  // namespace assay::check
