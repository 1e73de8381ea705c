// SPDX-License-Identifier: BSD-3-Clause
// The smallest acoustic eigenvalue of a material at one place of a path, on the branch on which the path loads.
#pragma once

#include <span>
#include <vector>

#include "harness/motion/path.hpp"
#include "harness/stability/tangent_modulus.hpp"

namespace assay {

/// By differences of `update`, whose size suits the material: found at rest.
class StabilityProbe {
 public:
  /// On 0 .. end [s]. Throws MaterialFailure where the material fails at rest.
  StabilityProbe(const Material& material, const Path& path, double end);

  const AcousticExtreme& at_rest() const { return rest_; }       ///< the smallest eigenvalue
  double scale() const { return scale_; }                        ///< the largest at rest [Pa]
  double noise_floor() const { return noise_floor_; }            ///< what differences cannot tell from zero [Pa]
  const std::vector<double>& breaks() const { return breaks_; }  ///< 0, reversals, end [s]

  /// The smallest eigenvalue at (xi, t) with the state there; the scale where the path stands still. The probe's own
  /// steps go a little beyond the path: throws MaterialFailure where the material fails in them.
  AcousticExtreme at(double xi, double t, const std::vector<double>& state) const;

  /// The same at many xi of one time, in batches: throws where any of them fails.
  std::vector<AcousticExtreme> at(std::span<const double> xi, double t,
                                  std::span<const std::vector<double>> states) const;

 private:
  /// Steps of strain. The state is settled first: a history's state is known to a tolerance, and only `update` itself
  /// puts it exactly on a yield surface. Then a step along the path, and differences small against it.
  struct Steps {
    double settle, base, difference;
  };
  static constexpr Steps fine{1e-4, 1e-6, 2e-8};
  static constexpr Steps coarse{1e-2, 1e-2, 1e-3};  ///< for a model in single precision

  void look_at_rest();
  Tensor loading(double xi, double t) const;
  std::vector<std::vector<double>> settled_states(double xi, double t, std::span<const ProbedStep> steps,
                                                  double dt) const;

  const Material& material_;
  const Path& path_;
  double end_;
  std::vector<double> breaks_;
  double rate_ = 0;  ///< of F along the path [1/s]
  AcousticExtreme rest_;
  double scale_ = 1, noise_floor_ = 0;
  Steps steps_ = fine;
};

}  // namespace assay
