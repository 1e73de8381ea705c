// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/method.hpp"

namespace assay::mpm {

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
                         "the second moment of linear functions vanishes at their nodes: take affine: gradient"};
  }
  if (m.flip != 1 && !m.keeps_velocity()) {
    return Contradiction{"method.flip", "blends flip or aflip with the grid's velocity, and transfer is another"};
  }
  return std::nullopt;
}

}  // namespace assay::mpm
