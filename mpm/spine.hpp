// SPDX-License-Identifier: BSD-3-Clause
// The spine: what every step has, whatever a scene calls for.
#pragma once

#include "mpm/step/effect.hpp"

namespace assay::mpm {

template <int Dim>
std::vector<Pass<Dim>> spine_passes(const Setup<Dim>& setup);

template <int Dim>
std::vector<ColumnRecord<Dim>> spine_columns();

template <int Dim>
std::vector<GridFieldUse> spine_fields(const Setup<Dim>& setup);

}  // namespace assay::mpm
