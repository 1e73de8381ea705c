// SPDX-License-Identifier: BSD-3-Clause
// Two or three principal stretches that are equal, or nearly so: where a spectral form divides by their difference.
#include <algorithm>

#include "harness/check/frame_twins.hpp"
#include "harness/check/tests.hpp"

namespace assay::check {

namespace {

/// Noise of a spectral form in double precision is up to 1e-8 where its stretches differ by 1e-8; a wrong limit is of
/// order one.
constexpr double most_change = 1e-4;
constexpr double per_difference = 1e3;       ///< of stress, relative, over a difference of stretches
constexpr double per_large_difference = 20;  ///< the same where stretches differ by more than rounding could explain

constexpr double stretch_differences[] = {1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-4, 1e-3};

/// `apart`: of stretches that are not nearly equal.
Tensor stress_at(const Specimen& specimen, double amplitude, bool three, double difference, double* largest = nullptr,
                 double apart = 0) {
  const Loading loading{[=, &specimen](double t) {
                          return specimen.space.equal_stretches(amplitude * t, three, (apart + difference) * t);
                        },
                        1};
  const March found = from_rest(specimen, loading, 5);
  if (largest) *largest = found.largest;
  return found.marks[0].cauchy;
}

/// The largest amplitude at which the material stands stretches that differ: cracks and voids are no defect of equal
/// ones. Throws MaterialFailure where there is none.
double standing_amplitude(const Specimen& specimen, bool three) {
  constexpr double least = 1e-6, apart = 0.1;
  for (double amplitude = specimen.amplitude;; amplitude *= 0.5) {
    try {
      stress_at(specimen, amplitude, three, apart * amplitude);
      return amplitude;
    } catch (const MaterialFailure&) {
      if (amplitude < least) throw;
    }
  }
}

}  // namespace

/// Stretches that differ by 0, 1e-15, ... 1e-4 along axes of any direction: the stress changes no more than they do.
TestResult nearly_equal_stretches(const Specimen& specimen) {
  double worst = 0, at = 0;
  for (const bool three : {false, true}) {
    const double amplitude = standing_amplitude(specimen, three);
    double largest = 0;
    const Tensor equal = stress_at(specimen, amplitude, three, 0, &largest);
    // A fluid that is expanded evenly has no viscous stress, beside which what a shear adds could be measured.
    const bool flows = three && specimen.rate_dependent();
    const double sheared = flows ? distance(stress_at(specimen, amplitude, three, 0.1 * amplitude), equal) : 0;
    const double scale = std::max({largest, sheared, 1e-6 * specimen.modulus * amplitude});
    for (const double difference : stretch_differences) {
      const bool large = difference > 1e-5;
      if (large && difference > 0.02 * amplitude) continue;
      const double least = large ? 0.1 * specimen.modulus * amplitude : 0;  // a fluid may have none in expansion
      const double change = distance(stress_at(specimen, amplitude, three, difference), equal) / std::max(scale, least);
      const double slope = large ? per_large_difference : per_difference;
      // where the stress is cut off or spent, a small shear brings its own
      const double little = std::max(1.0, specimen.modulus * amplitude / std::max(scale, least));
      double excess = std::max(0.0, change - slope * difference / amplitude * little);
      if (large && excess > most_change) {  // what grows without bounds does so from stretches that differ, too
        const double apart = 0.2 * amplitude;
        const double usual = distance(stress_at(specimen, amplitude, three, difference, nullptr, apart),
                                      stress_at(specimen, amplitude, three, 0, nullptr, apart));
        excess = std::max(0.0, excess - 3 * usual / std::max(scale, least));
      }
      // of a fluid that is expanded the rate has no shear: any, however small, may bring a finite stress
      if (flows && excess < 1) excess = 0;
      if (!(excess <= worst)) worst = excess, at = difference;
    }
  }
  return judged(worst, most_change, "stretches that are nearly equal give nearly the same stress",
                causes::repeated_stretch,
                "stretches that differ by " + rounded(at) + " change the stress by " + rounded(worst) + " of itself");
}

/// A rotation at equal stretches, as rotation_at_fixed_stretch.
TestResult rotation_at_equal_stretches(const Specimen& specimen) {
  const int steps = specimen.steps() / 4;
  const Turn Q = turning_between(specimen.space, 1, 2);
  RigidTurn turned;
  FailedStep last;
  for (const bool three : {false, true}) {
    const double a = standing_amplitude(specimen, three);
    const Loading still{[&](double t) { return specimen.space.equal_stretches(a * std::min(t, 1.0), three, 0); }, 2};
    for (int k = 0; k < 3; ++k) {
      const Twins twins = march_twins(specimen, still, Q, steps << k);
      turned.note(k, twins.seen.marks[1].cauchy, rotated(Q(2), twins.still.marks[1].cauchy),
                  specimen.scale(twins.still.largest));
      last = twins.seen.last;
    }
  }
  TestResult result = turned.judged("a body with equal stretches that turns", steps);
  if (result.verdict == Verdict::fail) result.cause = causes::repeated_stretch;
  result.step = last;
  return result;
}

}  // namespace assay::check
