// SPDX-License-Identifier: BSD-3-Clause
// Whether a VUMAT counts the work of all components of the strain.
#include <algorithm>
#include <cmath>

#include "drivers/check/check_foreign.hpp"
#include "harness/check/judge.hpp"
#include "harness/check/march.hpp"

namespace assay::drivers {

namespace {

struct Energies {
  double counted;  ///< by the model
  double work;     ///< of its stress, on the reference volume
  double share() const { return counted / work; }
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
  check::TestResult* const test = test_of(report, "energy");
  const std::size_t energy = place_in_state(material.material.table(), "ENERINTERN");
  if (!is_of(material, adapters::ForeignInterface::vumat) || !test || energy >= material.material.state_size() ||
      report.strain == 0)
    return;
  constexpr double most = 0.1;  // of increments of finite length, and of the density that is taken
  constexpr double farthest = 0.02;
  constexpr double significant = 1e-6;  // of the work of the other: a fluid takes none in shear, or in extension
  Tensor extension = Tensor::Zero(), shear = Tensor::Zero();
  extension(0, 0) = shear(0, 1) = 1;
  const double amplitude = std::min(farthest, report.strain);
  try {
    const Energies of_extension = energies_along(material.material, energy, extension, amplitude);
    const Energies of_shear = energies_along(material.material, energy, shear, amplitude);
    const double least = significant * std::max(std::abs(of_extension.work), std::abs(of_shear.work));
    if (!(std::abs(of_extension.work) > least && std::abs(of_shear.work) > least)) return;
    const double extended = of_extension.share(), sheared = of_shear.share();
    if (std::max(std::abs(extended), std::abs(sheared)) == 0) return;
    const double apart = std::abs(sheared - extended) / std::abs(extended);  // infinite of no share
    *test = {.id = test->id, .measure = apart, .threshold = most};
    test->sentence = "enerInternNew counts the work of shears and of extensions alike";
    if (apart <= most && extended > 0) return;
    fail_test(report, *test, check::causes::energy,
              apart <= most   ? "enerInternNew falls when the stress does work, and grows when it gives work back"
              : extended == 0 ? "enerInternNew counts the work of a shear, and none of that of an extension"
                              : "enerInternNew counts the work of a shear " + check::rounded(sheared / extended) +
                                    " times as it counts that of an extension: each shear of strainInc, which is the "
                                    "tensor's, stands for two components");
  } catch (const std::runtime_error&) {  // what it does not stand has been told
  }
}

}  // namespace assay::drivers
