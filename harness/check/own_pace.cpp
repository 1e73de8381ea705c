// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/own_pace.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "harness/check/march.hpp"
#include "harness/check/space.hpp"

namespace assay::check {

std::optional<double> own_pace(const Material& material, const Report& report) {
  constexpr double shortest = 1e-12, longest = 1e-3;  // [s]; the usual tests resolve what takes more
  constexpr double alike = 0.02, usual_strain = 0.01;
  constexpr double per_length = 250;  // what decays as exp(-t / T) has lost `alike` in T / 25: steps of T to 10 T
  if (!material.has(ASSAY_RATE_DEPENDENT)) return std::nullopt;
  const Tensor I = Tensor::Identity();
  const Tensor strained = Space(material).stretch(report.strain > 0 ? report.strain : usual_strain, 1);
  const auto stress_of_step = [&](double length) {
    return stepped(material, 0, length, I, strained, state_at_rest(material, report.pressure)).cauchy;
  };
  try {
    const Tensor sudden = stress_of_step(shortest);
    const double size = largest_of(sudden);
    double same = 0;
    for (double length = 10 * shortest; length < 2 * longest; length *= 10) {
      const Tensor stress = stress_of_step(length);
      const bool differs = !(distance(stress, sudden) <= alike * size);
      if (differs && same > 0 && largest_of(stress) < size) return per_length * same;  // it has relaxed
      if (differs) return std::nullopt;
      same = length;
    }
  } catch (const MaterialFailure&) {  // which says nothing of time
  }
  return std::nullopt;
}

}  // namespace assay::check
