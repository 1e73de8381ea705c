// SPDX-License-Identifier: BSD-3-Clause
// How many nodes will have rows of their own in a mass matrix that is made once.
#pragma once

#include <cstddef>

#include "mpm/setup/setup.hpp"

namespace assay::mpm {

/// In space an upper bound: nodes that particles reach and that do not lie among full cells. In the plane all nodes.
/// 0 where there is no such matrix.
template <int Dim>
std::size_t nodes_with_mass_rows(const Setup<Dim>& setup);

/// Bytes that such a node takes for its row; 0 where there is no such matrix.
template <int Dim>
std::size_t mass_row_bytes(const Setup<Dim>& setup);

}  // namespace assay::mpm
