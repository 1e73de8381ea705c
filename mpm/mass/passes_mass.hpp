// SPDX-License-Identifier: BSD-3-Clause
// From momentum and force of the nodes to their velocity, by the mass matrix M_ij = sum m_p phi_ip phi_jp.
//
//   M x:      particle by particle (kernel multiply_mass)      weights change in every step
//             MassStencil: a row for each node, made once      weights never change (total formulation)
//   M^-1 q:   divide         M_L^-1 q, M_L the row sums of M   lumped
//             add_terms      sum_l (I - M_L^-1 M)^l M_L^-1 q   series, XPIC, FMPM: k terms
//             solve          conjugate gradients               consistent
//                  |
//                  +--> precondition: row sums at the body's edges, and where rows are made once, inside it
//                       MassPreconditioner: the mean row, as if every node had it
//
// Nodes that are held, and nodes without mass, have M_L^-1 = 0: they take no part. Nodes at the body's edges keep their
// row sums in `solve`, for M is as good as singular there.
#pragma once

#include "mpm/step/effect.hpp"

namespace assay::mpm {

template <int Dim>
std::vector<Pass<Dim>> inversion_passes(const Setup<Dim>& setup);

template <int Dim>
std::vector<GridFieldUse> inversion_fields(const Setup<Dim>& setup);

}  // namespace assay::mpm
