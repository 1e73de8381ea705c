// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion.hpp"

namespace assay {

double period_of(const Motion& motion) {
  if (const auto* vortex = std::get_if<Vortex>(&motion)) return vortex->amplitude.period;
  return std::get<Homogeneous>(motion).period;
}

}  // namespace assay
