// SPDX-License-Identifier: BSD-3-Clause
// The passes of symmetry planes and periodic ends.
#pragma once

#include "mpm/step/passes_grid.hpp"

namespace assay::mpm {

/// What the particles have given to the grid since it was folded last.
enum class Folded { inertia, forces, both };

/// What particles gave to images goes to the nodes of which they are.
template <int Dim>
Pass<Dim> fold_images_pass(Folded what, bool accounts);

/// Images move as their nodes do. With the reaction of what a plane does to the particles' momentum where accounts are
/// kept.
template <int Dim>
Pass<Dim> unfold_images_pass(Reaction reaction, bool accounts);

}  // namespace assay::mpm
