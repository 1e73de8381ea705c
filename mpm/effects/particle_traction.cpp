// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/effects/tractions.hpp"

namespace assay::mpm {

template <int Dim>
EffectRecord<Dim> particle_traction_effect() {
  return traction_effect<Dim, TractionAlgorithm::particles>(70, "tractions at the particles of the surface");
}

template EffectRecord<ASSAY_DIMENSION> particle_traction_effect();

}  // namespace assay::mpm
