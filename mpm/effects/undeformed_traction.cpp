// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/effects/tractions.hpp"

namespace assay::mpm {

template <int Dim>
EffectRecord<Dim> undeformed_traction_effect() {
  return traction_effect<Dim, TractionAlgorithm::undeformed_edges>(80,
                                                                   "tractions by the undeformed length of the edges");
}

template EffectRecord<ASSAY_DIMENSION> undeformed_traction_effect();

}  // namespace assay::mpm
