// SPDX-License-Identifier: BSD-3-Clause
// The pieces of a body force as source, in the templates of drivers/templates/export/force.
#pragma once

#include <functional>
#include <string>

#include "drivers/export/force_pieces.hpp"

namespace assay::drivers {

/// Which position of a point the code knows where it asks for b.
enum class ForceCoordinates { current, reference };

enum class ForceLanguage { c, fortran, python };

/// "vortex_force.c"
std::string force_file(ForceLanguage language);

/// A source with vortex_force(x, y, t): b along the fixed axes. title: of the scene.
std::string force_source(ForceLanguage language, const ForcePieces& pieces, ForceCoordinates at,
                         const std::string& title);

enum class AbaqusRoutine {
  vdload,  ///< of Abaqus/Explicit
  dload    ///< of Abaqus/Standard
};

/// A user routine in fixed form for loads BXNU and BYNU, rho0 b at the current position. density: rho0 [kg/m^3].
std::string abaqus_force(AbaqusRoutine routine, const ForcePieces& pieces, double density, const std::string& title);

/// How a language writes what an amplitude is made of.
struct AmplitudeWords {
  std::string sine = "sin";
  std::function<std::string(double)> number;
  /// The lesser of a variable and a number.
  std::function<std::string(const std::string& t, const std::string& T)> least;
};

/// g(t) of a variable t.
std::string amplitude_expression(const Amplitude& g, const std::string& t, const AmplitudeWords& words);

}  // namespace assay::drivers
