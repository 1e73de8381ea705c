// SPDX-License-Identifier: BSD-3-Clause
// One step, seen from a turned frame: which tensor of the state does not turn as it should, and how it does.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/check/specimen.hpp"
#include "harness/check/stiffness.hpp"
#include "harness/material/state_variable.hpp"

namespace assay::check {

/// How a tensor or vector of the state, or the stress, is treated by `update`.
enum class Turned {
  rightly,
  not_at_all,
  by_another_angle,
  in_another_order,
  with_shear_factor,
  otherwise,
};

struct TurnedVariable {
  std::string name = {};
  bool is_stress = false;  ///< proportional to the Cauchy stress
  Turned how = Turned::rightly;
  double times = 1;              ///< by_another_angle: of the body's
  bool exactly = false;          ///< so, to rounding
  bool is_own = false;           ///< declared to turn by itself
  ShearOrder order = {0, 1, 2};  ///< in_another_order
};

struct TurnedStep {
  double error = 0;                     ///< of the stress of one step from a turned state, relative
  Turned stress = Turned::rightly;      ///< the defect of the output that explains the error
  ShearOrder order = {0, 1, 2};         ///< of what is taken, or the stress, to be in another order
  std::vector<TurnedVariable> carried;  ///< in a step in which a loaded body turns and is not deformed
  std::vector<TurnedVariable> taken;    ///< in a loading from a turned state: as what they are read
};

/// Of states along the loading; nothing where the material fails.
std::optional<TurnedStep> turned_step(const Specimen& specimen);

/// A loaded point, and the lengths of its steps [s].
struct Loaded {
  Tensor F;
  Point point;
  double length, instant;
};

/// The tensors and vectors of the state that have to turn, and the tensors that are declared to turn by themselves.
std::vector<StatePlace> places_of(const Material& material);

/// A loading step goes on from place s of the loading to this F.
Tensor further_on(const Specimen& specimen, double s);

/// Fills in the error of a loading step from a turned state, `stress` and `taken`: the least unlikely assumptions that
/// explain it. The step goes on from place s of the loading.
void read_back(const Specimen& specimen, const Loaded& from, double s, TurnedStep& found);

}  // namespace assay::check
