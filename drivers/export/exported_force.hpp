// SPDX-License-Identifier: BSD-3-Clause
// What the targets for particle codes share: the body force as pieces, steps, and the state at rest.
#pragma once

#include <optional>
#include <string>

#include "drivers/export/export.hpp"
#include "drivers/export/force_pieces.hpp"

namespace assay::drivers {

/// The body force of a plane vortex, with or without inertia, to 1e-6 of the largest or as well as the material's table
/// knows it. Throws InputError.
ForcePieces exported_pieces(const ExportedProblem& problem, const std::string& target, bool quasi_static = false);

/// Adds the body force of a plane vortex as source to a deck: in C, Fortran and Python, or as user routines of Abaqus.
/// Returns a section of README.md on them; empty, and without files, for another motion.
std::string add_force_sources(const ExportedProblem& problem, Deck& deck);
std::string add_abaqus_routines(const ExportedProblem& problem, Deck& deck);

/// Why a particle code with expressions cannot have the problem; empty: it can.
std::string fault_of_expressions(const ExportedProblem& problem, const std::string& code);

/// A sentence on pieces and error.
std::string pieces_words(const ForcePieces& pieces);

/// Equal steps until the end. courant: of the fastest wave and the spacing.
struct ExportedSteps {
  int count = 0, every = 0;  ///< steps in all, and between two outputs
  double step = 0;           ///< [s]
};

/// Steps in proportion to the spacing, so that their error falls with it; some 20 outputs.
ExportedSteps exported_steps(const ExportedProblem& problem, double h, double courant);

/// Outputs at the same times on all grids, for codes whose output does not say its time: 20, and perhaps the beginning.
inline constexpr int exported_outputs = 20;
ExportedSteps steps_of_outputs(const ExportedProblem& problem, double h, double courant);

/// Of a solid that is isotropic and elastic at rest [Pa].
struct RestModuli {
  double bulk = 0, shear = 0;
};

/// Absent where the stress is no function of F, where the solid is not isotropic, or where it has no stiffness.
std::optional<RestModuli> rest_moduli(const Material& material);

}  // namespace assay::drivers
