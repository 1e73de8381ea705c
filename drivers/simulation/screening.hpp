// SPDX-License-Identifier: BSD-3-Clause
// The stability screen of a scene's motion: its figures, and what a verb says of them.
#pragma once

#include <optional>
#include <string>

#include "drivers/result/result.hpp"
#include "drivers/scene/scene.hpp"
#include "harness/material/material.hpp"

namespace assay::drivers {

/// Over 0 .. end [s], at most four periods. A terminal sees how far it is, unless `quiet`. Throws MaterialFailure.
ScreenFigures screen_of(const Scene& scene, const Material& material, double end, bool quiet);

/// Why the motion is no stable solution, one sentence; empty where it is one.
std::string instability_sentence(const ScreenFigures& screen, const std::string& material);

/// The same where the scene does not allow it: why a run is refused.
std::string refusal_sentence(const Scene& scene, const ScreenFigures& screen, const std::string& material);

/// "stable, ...", for explain and for people, one line without its end.
std::string screen_sentence(const ScreenFigures& screen);

/// One line on standard error where the motion is unstable and the scene does not allow that. Never stops a verb: a
/// material that fails on the way is found by what follows. Throws Interrupted when a signal came.
void warn_of_instability(const Scene& scene, const Material& material, double end, bool quiet);

}  // namespace assay::drivers
