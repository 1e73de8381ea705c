// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/precision.hpp"

#include <algorithm>
#include <vector>

namespace assay::check {

namespace {

constexpr double change = 4e-8;  ///< relative: less than 2^-24, whose steps then show, and 1e8 times those of 53 bits
constexpr int neighbours = 33;

/// How far the stress is from a smooth course along neighbouring steps, over the stress. What a kink does happens once;
/// of the steps of rounding there are many.
template <class StressOf>
double roughness(const Specimen& specimen, const StressOf& stress_of_place) {
  std::vector<Tensor> stress;
  for (int k = 0; k < neighbours; ++k) stress.push_back(stress_of_place(1 + k * change));
  const double scale = std::max(stress.front().cwiseAbs().maxCoeff(), specimen.least_stress());
  std::vector<double> departures;
  for (std::size_t k = 1; k + 1 < stress.size(); ++k) {
    departures.push_back(distance(stress[k], 0.5 * (stress[k - 1] + stress[k + 1])) / scale);
  }
  std::sort(departures.begin(), departures.end());
  return departures[departures.size() * 3 / 4];
}

}  // namespace

bool is_of_single_precision(const Specimen& specimen) {
  constexpr double least = 1e-9, most = 1e-5;  // 2^-24 = 6e-8, and what a few operations make of it
  const Tensor H = specimen.space.stretch(specimen.amplitude, 0.3) - Tensor::Identity();
  const auto stress = [&](double length, const Tensor& F1) {
    return stepped(*specimen.material, 0, length, Tensor::Identity(), F1, specimen.rest_state()).cauchy;
  };
  try {
    double rough = roughness(specimen, [&](double by) { return stress(1, Tensor::Identity() + by * H); });
    for (const double length : {1e-3, 1.0, 1e3}) {
      if (!specimen.rate_dependent()) break;
      const auto of_length = [&](double by) { return stress(by * length, Tensor::Identity() + H); };
      rough = std::max(rough, roughness(specimen, of_length));
    }
    return rough > least && rough < most;
  } catch (const MaterialFailure&) {
    return false;
  }
}

}  // namespace assay::check
