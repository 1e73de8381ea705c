// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/setup/method.hpp"

namespace assay::mpm {

namespace {

/// A symplectic step of stages wants x' = A v, v' = B(x, t) and nothing else.
std::optional<Contradiction> contradiction_of_stages(const Method& m) {
  if (!m.is_total()) {
    return Contradiction{"method.integrator",
                         "symplectic_rkn4 needs weights that do not move with the particles: take formulation: total"};
  }
  if (m.transfer == Transfer::aflip) {
    return Contradiction{
        "method.transfer",
        "symplectic_rkn4 has no place for the gradient that aflip carries from step to step: take flip"};
  }
  if (m.transfer != Transfer::flip) {
    return Contradiction{"method.transfer",
                         "only flip leaves the energy alone, and symplectic_rkn4 transfers back and forth: take flip"};
  }
  if (m.flip != 1) {
    return Contradiction{"method.flip",
                         "a share of the grid's velocity takes energy, which symplectic_rkn4 keeps: take 1"};
  }
  if (m.update != Update::usl) {
    return Contradiction{"method.update", "symplectic_rkn4 moves F together with the positions: take usl"};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Contradiction> contradiction(const Method& m) {
  if (m.is_total() && m.basis == Basis::cpgimp) {
    return Contradiction{"method.basis",
                         "the boxes of cpgimp do not stretch in the reference configuration: take ugimp"};
  }
  if (m.is_total() && m.basis == Basis::cpdi2) {
    return Contradiction{"method.basis",
                         "no corner moves in the reference configuration, where cpdi2 is cpdi: take that"};
  }
  if (m.mass != Mass::lumped && (m.transfer == Transfer::xpic || m.transfer == Transfer::fmpm)) {
    return Contradiction{"method.mass", "xpic and fmpm are series of the mass matrix themselves: take lumped"};
  }
  if (m.mass == Mass::series && m.transfer == Transfer::pic) {
    return Contradiction{"method.mass", "pic with a series of the mass matrix is transfer: fmpm"};
  }
  if (m.is_affine() && m.affine == Affine::moment && m.basis == Basis::linear) {
    return Contradiction{"method.affine",
                         "the second moment of linear functions vanishes at their nodes: set affine: gradient"};
  }
  if (m.flip != 1 && !m.keeps_velocity()) {
    return Contradiction{"method.flip", "blends flip or aflip with the grid's velocity, and transfer is neither"};
  }
  return m.has_stages() ? contradiction_of_stages(m) : std::nullopt;
}

}  // namespace assay::mpm
