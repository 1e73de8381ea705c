// SPDX-License-Identifier: BSD-3-Clause
// A material that cannot go on: the one step of one point at which it failed, with all that is needed to take it again,
// and what is thrown.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "harness/material/material.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay {

/// Arguments of `update` for one point: a pure call, so that the same arguments fail again.
struct FailedStep {
  double t = 0, dt = 0;              ///< beginning and length [s]
  Tensor F0 = Tensor::Identity();    ///< deformation gradient at t [1]
  Tensor F1 = Tensor::Identity();    ///< at t + dt [1]
  std::vector<double> state0 = {};   ///< every component of the point's state at t, in declared order
  std::vector<double> fields1 = {};  ///< fields (ASSAY_ROLE_FIELD) at t + dt, in declared order; empty: as at t
};

/// Point p of a batch of n: F0, F1 9 * n, state0 state_size * n, component-major as in the ABI.
inline FailedStep failed_step(double t, double dt, std::size_t n, std::size_t p, const double* F0, const double* F1,
                              const double* state0, std::size_t state_size) {
  return {t, dt, tensor_at(F0, n, p), tensor_at(F1, n, p), point_of(state0, n, p, state_size)};
}

/// The same, with the fields that the material prescribes.
inline FailedStep failed_step(const Material& material, double t, double dt, std::size_t n, std::size_t p,
                              const double* F0, const double* F1, const double* state0) {
  FailedStep step = failed_step(t, dt, n, p, F0, F1, state0, material.state_size());
  step.fields1 = material.field_values(t + dt, step.state0);
  return step;
}

/// Takes the step again.
inline UpdateReport take_again(const Material& material, const FailedStep& step) {
  double cauchy[9];
  std::vector<double> state1(step.state0.size());
  return material.update(step.t, step.dt, 1, nine_of(step.F0).data(), nine_of(step.F1).data(), step.state0.data(),
                         state1.data(), cauchy, step.fields1);
}

/// Says where on a path a material failed, and how.
struct FailurePlace {
  double xi = 0, t = 0;
  std::optional<FailedStep> step = {};  ///< where a call of `update` failed
  bool not_finite = false;              ///< its stress or state is no number
  bool final = false;                   ///< no shorter step would do: its process died
  bool late = false;                    ///< a call took longer than it may: another one would take as long
  bool too_accurate = false;            ///< a larger tolerance of its history may do
};

/// A material refused a step, or returned a non-finite stress.
class MaterialFailure : public std::runtime_error, public FailurePlace {
 public:
  MaterialFailure(const std::string& what, double at_xi, double at_t, std::optional<FailedStep> at_step = {})
      : MaterialFailure(what, {at_xi, at_t, std::move(at_step)}) {}
  MaterialFailure(const std::string& what, FailurePlace place)
      : std::runtime_error(what), FailurePlace(std::move(place)) {}
};

/// A material has no state to begin with: at no place of a path.
class CannotBegin : public MaterialFailure {
 public:
  CannotBegin(const std::string& what, std::string because)
      : MaterialFailure(what + (because.empty() ? "" : ": " + because), NAN, NAN), reason(std::move(because)) {
    final = true;
  }
  std::string reason;  ///< in the model's words
};

/// A function of a model let an exception pass. At no place of a path: xi and t are no numbers. No shorter step would
/// do.
class ModelThrew : public MaterialFailure {
 public:
  explicit ModelThrew(const std::string& what) : MaterialFailure(what, NAN, NAN) { final = true; }
  /// "material 'rubber': wave_speed threw ..."
  ModelThrew(const std::string& model, const std::string& function, const std::string& thrown)
      : ModelThrew("material '" + model + "': " + function + " " + thrown) {}
};

}  // namespace assay
