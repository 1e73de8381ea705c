// SPDX-License-Identifier: BSD-3-Clause
// A scene's material as Abaqus and CalculiX have it.
#pragma once

#include <string>

#include "drivers/export/export.hpp"

namespace assay::drivers {

/// From *MATERIAL on.
struct DeckLaw {
  std::string name;   ///< *MATERIAL, NAME=
  std::string lines;  ///< behind it
};

struct DeckLaws {
  DeckLaw abaqus, calculix;
  std::string words;  ///< sentences for README.md
};

/// A law of each code where it has one that answers this motion as the scene's material does. The motions of decks keep
/// the volume, so only the stress at J = 1 counts, and there all of these are the same:
///
///   neo_hookean    P = mu (F - F^-T) + lambda ln J F^-T, and at J = 1 mu (F - F^-T).
///                  Abaqus: *HYPERFOAM with alpha = 2, U = mu/2 (I1 - 3 + (J^-2beta - 1)/beta), beta = nu/(1 - 2 nu),
///                  so that P = mu (F - J^-2beta F^-T). CalculiX: its user material CIARLET_EL,
///                  S = mu (I - C^-1) + lambda/2 (det C - 1) C^-1
///   mooney_rivlin  both: *HYPERELASTIC, MOONEY-RIVLIN, with (J - 1)^2/D1 where the scene's has kappa/2 (ln J)^2. With
///                  D1 = 2/kappa both have no pressure at J = 1, and the same stiffness
///   saint_venant_kirchhoff    CalculiX: *ELASTIC with NLGEOM; Abaqus has another law for large strains
///
/// and *USER MATERIAL for all others.
DeckLaws deck_laws(const ExportedProblem& problem);

}  // namespace assay::drivers
