// SPDX-License-Identifier: BSD-3-Clause
// The grid update where the mass matrix is more than its row sums.
#pragma once

#include "mpm/step/pass.hpp"

namespace assay::mpm {

/// Grid fields of Dim components that the inversion takes.
inline std::size_t solver_fields(const Method& method) {
  return method.is_lumped() ? 0 : method.mass == Mass::consistent ? 8 : 4;
}

/// That call for an inversion.
inline std::vector<Effect> effects_of_matrix(const Method& method) {
  std::vector<Effect> effects;
  if (method.mass != Mass::lumped) effects.push_back(Effect::mass_matrix);
  if (method.transfer == Transfer::xpic || method.transfer == Transfer::fmpm) {
    effects.push_back(Effect::velocity_terms);
  }
  if (method.has_stages()) effects.push_back(Effect::force_stages);
  return effects;
}

/// a = M^-1 f, v = M^-1 (m v) + dt a, on nodes that are not held. M_ij = sum m_p phi_ip phi_jp is inverted by k terms
/// of sum_l (I - M_L^-1 M)^l M_L^-1, M_L its row sums, or by conjugate gradients:
///   series:      of f; m v is divided by M_L
///   consistent:  of f; and of m v where particles do not carry the velocity around them, which M_L serves exactly
///   xpic(k):     series of m v; f is divided by M_L
///   fmpm(k):     series of m v + dt f
/// What holding takes from the particles' momentum enters the account.
template <int Dim>
Pass<Dim> mass_matrix_pass(const Method& method);

/// Of an integrator with stages: a = M^-1 f, m v += dt sum m_p phi_ip phi_jp a_j, v = M^-1 (m v), the same M^-1 twice,
/// so that drifts and kicks are adjoint and the energy of the particles is that of the system. What the particles gain
/// reaches the nodes by the matrix: no transfer between the stages.
template <int Dim>
Pass<Dim> kick_pass(const Method& method);

}  // namespace assay::mpm
