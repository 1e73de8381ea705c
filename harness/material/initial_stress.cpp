// SPDX-License-Identifier: BSD-3-Clause
#include "harness/material/initial_stress.hpp"

#include "harness/material/checked_update.hpp"
#include "harness/numeric/norms.hpp"
#include "harness/numeric/number_text.hpp"

namespace assay {

std::string fault_of_initial_stress(const Material& material, const Tensor& cauchy) {
  constexpr double carried = 1e-5;     // of the stress: models of single precision carry it, too
  constexpr double short_time = 1e-9;  // too short for creep [s]
  if (cauchy.isZero(0)) return {};
  const Tensor I = Tensor::Identity();
  try {
    const std::vector<double> state = material.initial_state(1, nine_of(cauchy));
    const Tensor found = stepped(material, 0, short_time, I, I, state).cauchy;
    const double off = largest_of(found - cauchy), size = largest_of(cauchy);
    if (off <= carried * size) return {};
    return "material '" + material.name() +
           "' does not carry it: a step without deformation returns a stress that is " + rounded_text(off, 3) +
           " Pa off";
  } catch (const MaterialFailure& failure) {
    return failure.what();
  }
}

}  // namespace assay
