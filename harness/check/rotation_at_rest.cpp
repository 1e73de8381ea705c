// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "harness/check/march.hpp"
#include "harness/check/rotation.hpp"
#include "harness/check/share_along.hpp"

namespace assay::check {

namespace {

/// A turn by a small angle, its square half a strain at which most materials are elastic.
Tensor little_turn(const Space& space, double t) { return space.turn(3e-3 * t); }
Tensor strain_of_little_turn(const Space& space, double t) {
  return 0.5 * (little_turn(space, t) + little_turn(space, t).transpose());
}

/// Above that of rest, at the end of a loading of so many seconds.
Tensor stress_after(const Specimen& specimen, Tensor (*F)(const Space&, double), double length) {
  const MarchOptions options{.steps = specimen.steps(), .phase_length = length, .state = specimen.rest_state()};
  const Loading loading{[&](double t) { return F(specimen.space, t); }, 1};
  return march(*specimen.material, loading, options).marks[0].cauchy + specimen.rest_pressure() * Tensor::Identity();
}

/// The stress of a turn Q, as a multiple of that of the strain sym(Q - I). 0 where the stress is of another kind: a
/// body may swell in time.
double small_strain_share(const Specimen& specimen) {
  constexpr double alike = 0.2;
  const Tensor mistaken = stress_of(specimen.stiffness, little_turn(specimen.space, 1) - Tensor::Identity());
  const Tensor found = stress_after(specimen, little_turn, 1);
  const double share = share_along(found, mistaken);
  return distance(found, share * mistaken) < alike * found.cwiseAbs().maxCoeff() ? share : 0;
}

/// The same after ages, when overstresses, which may know no mistake, are gone.
double relaxed_small_strain_share(const Specimen& specimen) {
  constexpr double ages = 1e6;  // [s]
  try {
    return share_along(stress_after(specimen, little_turn, ages), stress_after(specimen, strain_of_little_turn, ages));
  } catch (const MaterialFailure&) {
    return INFINITY;
  }
}

/// The same of each part that relaxes, in one step: the nearest to 1. Viscous stress of sym(F1 - F0)/dt is such a part.
double relaxing_small_strain_share(const Specimen& specimen) {
  const Tensor Q = little_turn(specimen.space, 1);
  double nearest = 0;
  const auto stress = [&](double length) {
    return stepped(*specimen.material, 0, length, Tensor::Identity(), Q, specimen.rest_state()).cauchy;
  };
  for (const RelaxingPart& part : specimen.parts) {
    if (std::isinf(part.longer)) continue;
    const Tensor found = stress(part.brief) - stress(part.longer);
    const Tensor mistaken = stress_of(part.stiffness, Q - Tensor::Identity());
    const double share = share_along(found, mistaken);
    const bool alike = distance(found, mistaken) < 0.1 * mistaken.cwiseAbs().maxCoeff();
    if (alike && std::abs(share - 1) < std::abs(nearest - 1)) nearest = share;
  }
  return nearest;
}

}  // namespace

RotationFinding rotation_at_rest(const Specimen& specimen) {
  const Material& material = *specimen.material;
  std::array<double, 3> errors{};
  FailedStep last;
  const auto deviation = [&](const March& turned) {
    return distance(turned.marks[0].cauchy, -specimen.rest_pressure() * Tensor::Identity()) / specimen.modulus;
  };
  for (int k = 0; k < 3; ++k) {
    const Loading loading{[&](double t) { return specimen.space.turn(turning_angle * t); }, 1};
    const March turned = march(material, loading, {.steps = specimen.steps() << k, .state = specimen.rest_state()});
    errors[static_cast<std::size_t>(k)] = deviation(turned);
    last = turned.last;
  }
  const Limit limit = limit_of(errors);
  RotationFinding finding{{.id = "rotation.at_rest", .measure = limit.value, .threshold = converging_limit}};
  finding.result.step = last;
  finding.result.order = limit.order;
  finding.result.verdict = limit.passes() ? Verdict::pass : Verdict::fail;
  finding.result.sentence =
      "stress of a body that rotates without load, relative to the modulus: " + rounded(errors[2]);
  finding.small_strain = small_strain_share(specimen);
  if (finding.result.verdict == Verdict::fail && specimen.rate_dependent()) {
    const double later = relaxed_small_strain_share(specimen);
    if (std::abs(later - 1) < std::abs(finding.small_strain - 1)) finding.small_strain = later;
  }
  finding.relaxing_small_strain = relaxing_small_strain_share(specimen);
  return finding;
}

}  // namespace assay::check
