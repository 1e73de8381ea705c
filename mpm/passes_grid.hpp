// SPDX-License-Identifier: BSD-3-Clause
// Passes on the grid alone.
#pragma once

#include "mpm/pass.hpp"

namespace assay::mpm {

/// v_i = (m v)_i / m_i, a_i = 0: the velocity before the forces.
template <int Dim>
Pass<Dim> grid_velocity_pass();

/// a_i = f_i / m_i, v_i = (m v)_i / m_i + dt a_i.
template <int Dim>
Pass<Dim> grid_update_pass();

/// v_i = a_i = 0 on nodes outside the ring; the reaction enters the momentum account.
template <int Dim>
Pass<Dim> hold_nodes_pass();

}  // namespace assay::mpm
