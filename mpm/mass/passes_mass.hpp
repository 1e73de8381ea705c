// SPDX-License-Identifier: BSD-3-Clause
// The grid update where the mass matrix is more than its row sums: what the effects that call for it bring.
#pragma once

#include "mpm/step/effect.hpp"

namespace assay::mpm {

template <int Dim>
std::vector<Pass<Dim>> inversion_passes(const Setup<Dim>& setup);

template <int Dim>
std::vector<GridFieldUse> inversion_fields(const Setup<Dim>& setup);

}  // namespace assay::mpm
