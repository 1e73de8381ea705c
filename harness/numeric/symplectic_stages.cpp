// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/symplectic_stages.hpp"

// clang-format off: Odeint's stepper does not include its base
#include <boost/numeric/odeint/stepper/base/symplectic_rkn_stepper_base.hpp>
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_m4_mclachlan.hpp>
// clang-format on

namespace assay {

std::vector<SymplecticStage> symplectic_rkn4() {
  const boost::numeric::odeint::symplectic_rkn_sb3a_m4_mclachlan<std::vector<double>> stepper;
  std::vector<SymplecticStage> stages;
  double begin = 0, kick = 0;
  for (std::size_t k = 0; k < stepper.coef_a().size(); ++k) {
    stages.push_back({begin, stepper.coef_a()[k], kick});
    begin += stepper.coef_a()[k];
    kick = stepper.coef_b()[k];  // Odeint drifts first; its last kick is none
  }
  return stages;
}

}  // namespace assay
