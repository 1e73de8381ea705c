// SPDX-License-Identifier: BSD-3-Clause
// How far a material stays strongly elliptic along the baselines: a property, and no defect.
#include <algorithm>
#include <cmath>

#include "harness/check/tests.hpp"
#include "harness/stability/stability_probe.hpp"

namespace assay::check {

namespace {

constexpr int steps = 64, steps_between = 8;

/// F = I + eps D from 0 to `end`.
struct Baseline {
  const char* name;
  Tensor direction;  ///< D
  double end;        ///< eps [1]
  const char* measure;
  double per_eps;  ///< of what `measure` names
};

std::vector<Baseline> baselines() {
  Tensor shear = Tensor::Zero(), uniaxial = Tensor::Zero();
  shear(1, 0) = 2;
  uniaxial(0, 0) = 1;
  return {{"simple shear", shear, 0.5, "gamma", 2},
          {"uniaxial extension", uniaxial, 0.5, "strain", 1},
          {"uniaxial compression", uniaxial, -0.3, "strain", 1}};
}

assay::Path straight_path(const Baseline& baseline) {
  assay::Path path;
  path.name = "straight";
  path.parameter = {baseline.end, baseline.end};
  path.reversals = [](double) { return std::vector<double>{}; };
  path.direction = baseline.direction;
  path.amplitude = [](double t) { return t; };
  path.amplitude_rate = [](double) { return 1.0; };
  path.amplitude_range = [](double) { return Interval{0, 1}; };
  return path;
}

/// What is found on the way along a baseline.
struct Finding {
  double smallest = INFINITY;  ///< over the largest eigenvalue at rest
  std::string words;
};

Finding along(const Specimen& specimen, const Baseline& baseline) {
  const assay::Path path = straight_path(baseline);
  const auto place = [&](double t) {
    return std::string(baseline.measure) + " = " + rounded(baseline.per_eps * baseline.end * t + 0.0);  // no -0
  };
  Finding finding;
  finding.words = std::string(baseline.name) + " up to " + place(1);
  Point now{Tensor::Zero(), specimen.rest_state()};
  double t = 0;
  try {
    const StabilityProbe probe(specimen, path, 1);
    const double at_rest = probe.at_rest().value;
    if (at_rest < -probe.noise_floor()) {
      finding.smallest = at_rest / probe.scale();
      finding.words = std::string(baseline.name) + ": lost at " + place(0);
      return finding;
    }
    for (int k = 0; k < steps; ++k) {
      t = (k + 1.0) / steps;
      now = stepped(specimen, t - 1.0 / steps, 1.0 / steps, path.deformation_gradient(baseline.end, t - 1.0 / steps),
                    path.deformation_gradient(baseline.end, t), now.state);
      if ((k + 1) % steps_between != 0) continue;
      const double value = probe.at(baseline.end, t, now.state).value;
      finding.smallest = std::min(finding.smallest, value / probe.scale());
      if (value >= -probe.noise_floor()) continue;
      finding.words = std::string(baseline.name) + ": lost at " + place(t);
      break;
    }
  } catch (const MaterialFailure&) {
    finding.words = std::string(baseline.name) + ": the material fails at " + place(t);
  }
  return finding;
}

}  // namespace

/// The smallest eigenvalue of the acoustic tensor, over the largest at rest, along simple shear (16) and uniaxial
/// strain (38); the sentence tells where it falls below zero. Never fails.
TestResult ellipticity(const Specimen& specimen) {
  if (specimen.rest_pressure() > 0) {
    return left_out("a state of rest under pressure has no stress-free wave speeds to compare with");
  }
  double smallest = INFINITY;
  std::string words;
  for (const Baseline& baseline : baselines()) {
    const Finding finding = along(specimen, baseline);
    smallest = std::min(smallest, finding.smallest);
    words += (words.empty() ? "" : "; ") + finding.words;
  }
  TestResult result = left_out(std::string("strong ellipticity") + (specimen.space.is_plane() ? " in the plane" : "") +
                               " (a property of the material, not a defect): " + words);
  if (!std::isfinite(smallest)) return result;
  result.measure = smallest;
  result.verdict = Verdict::pass;
  return result;
}

}  // namespace assay::check
