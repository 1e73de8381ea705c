// SPDX-License-Identifier: BSD-3-Clause
// Splittings of a step in time for x' = A v, v' = B(x, t): stages that kick v, then let x drift.
#pragma once

#include <vector>

namespace assay {

/// Fractions of a step. v += kick dt B at x and at the time `begin`; then x += drift dt A v.
struct SymplecticStage {
  double begin = 0, drift = 1, kick = 1;
};

/// The symmetric Runge-Kutta-Nystroem method SB3A of fourth order with four forces a step (McLachlan 1995), by
/// Boost.Odeint. The first stage has no kick. Times go forth and back within the step.
std::vector<SymplecticStage> symplectic_rkn4();

}  // namespace assay
