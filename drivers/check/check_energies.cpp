// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_energies.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "drivers/check/check_foreign.hpp"
#include "harness/check/judge.hpp"
#include "harness/check/march.hpp"
#include "harness/material/material_failure.hpp"

namespace assay::drivers {

namespace {

constexpr const char* energy_test = "energy";

struct Energies {
  double counted;  ///< by the model
  double work;     ///< of its stress, on the reference volume
};

/// Along a straight loading from rest. Throws MaterialFailure.
Energies energies_along(const Material& material, std::size_t energy, const Tensor& slope, double amplitude) {
  constexpr int steps = 100;
  double work = 0;
  Tensor F = Tensor::Identity();
  check::Point now{Tensor::Zero(), material.initial_state(1)};
  for (int k = 0; k < steps; ++k) {
    const Tensor next = Tensor::Identity() + amplitude * (k + 1.0) / steps * slope;
    const check::Point end = check::stepped(material, static_cast<double>(k) / steps, 1.0 / steps, F, next, now.state);
    const Tensor middle = 0.5 * (F + next), l = (next - F) * middle.inverse();
    const Tensor stress = 0.5 * (now.cauchy + end.cauchy);
    work += middle.determinant() * stress.cwiseProduct(0.5 * (l + l.transpose())).sum();
    F = next, now = end;
  }
  return {now.state[energy], work};
}

}  // namespace

void judge_energies(const ResolvedMaterial& material, check::Report& report) {
  const auto test = std::find_if(report.tests.begin(), report.tests.end(),
                                 [](const check::TestResult& each) { return each.id == energy_test; });
  const bool is_vumat = material.foreign && material.foreign->interface == adapters::ForeignInterface::vumat;
  const std::size_t energy = place_in_state(material.material.table(), "ENERINTERN");
  if (!is_vumat || test == report.tests.end() || energy >= material.material.state_size() || report.strain == 0) return;
  Tensor extension = Tensor::Zero(), shear = Tensor::Zero();
  extension(0, 0) = 1, shear(0, 1) = 1;
  constexpr double most = 0.1;  // of increments of finite length, and of the density that is taken
  constexpr double farthest = 0.02;
  const double amplitude = std::min(farthest, report.strain);
  try {
    constexpr double significant = 1e-6;  // of the work of the other: a fluid takes none in shear, or in extension
    const Energies of_extension = energies_along(material.material, energy, extension, amplitude);
    const Energies of_shear = energies_along(material.material, energy, shear, amplitude);
    const double least = significant * std::max(std::abs(of_extension.work), std::abs(of_shear.work));
    if (!(std::abs(of_extension.work) > least && std::abs(of_shear.work) > least)) return;
    const double extension_share = of_extension.counted / of_extension.work,
                 shear_share = of_shear.counted / of_shear.work;
    const double larger = std::max(std::abs(extension_share), std::abs(shear_share));
    if (larger == 0) return;
    const double apart = std::abs(shear_share - extension_share) / std::abs(extension_share);  // infinite of no share
    *test = {.id = energy_test, .measure = apart, .threshold = most};
    test->sentence = "enerInternNew counts the work of shears and of extensions alike";
    if (apart <= most && extension_share > 0) return;
    test->verdict = check::Verdict::fail;
    test->cause = check::causes::energy;
    if (apart <= most)
      test->sentence = "enerInternNew falls when the stress does work, and grows when it gives work back";
    else if (extension_share == 0)
      test->sentence = "enerInternNew counts the work of a shear, and none of that of an extension";
    else
      test->sentence = "enerInternNew counts the work of a shear " + check::rounded(shear_share / extension_share) +
                       " times as it counts that of an extension: each shear of strainInc, which is the tensor's, "
                       "stands for two components";
    report.diagnosis.push_back({test->cause, test->sentence});
  } catch (const std::runtime_error&) {  // what it does not stand has been told
  }
}

}  // namespace assay::drivers
