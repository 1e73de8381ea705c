// SPDX-License-Identifier: BSD-3-Clause
// A material taken along a deformation history in equal steps, from a given state.
#pragma once

#include <functional>
#include <vector>

#include "harness/material/material.hpp"
#include "harness/material/material_failure.hpp"
#include "harness/numeric/largest.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay::check {

/// F(t) [1] for 0 <= t <= phases; at the integers something begins or ends.
struct Loading {
  std::function<Tensor(double)> F;
  int phases = 1;
};

/// Stress [Pa] and state of one point.
struct Point {
  Tensor cauchy = Tensor::Zero();
  std::vector<double> state;
};

/// Points at the end of each phase; the largest component of stress on the way and the norm of the stress after each
/// step [Pa]; the last step taken.
struct March {
  std::vector<Point> marks;
  double largest = 0;
  std::vector<double> sizes;
  FailedStep last;
};

struct MarchOptions {
  int steps = 100;            ///< in each phase
  double phase_length = 1;    ///< [s]
  double begin = 0;           ///< clock at the beginning [s]
  std::vector<double> state;  ///< at the beginning
};

/// One step of one point. Throws MaterialFailure.
Point stepped(const Material& material, double t, double dt, const Tensor& F0, const Tensor& F1,
              const std::vector<double>& state0);

/// Whether the material takes that step.
bool takes(const Material& material, const FailedStep& step);

/// Throws MaterialFailure.
March march(const Material& material, const Loading& loading, const MarchOptions& options);

/// State at rest under a pressure [Pa] of a material whose direction, if it has one, is `direction`. Throws
/// std::runtime_error where the material cannot carry that.
std::vector<double> state_at_rest(const Material& material, double pressure,
                                  const Vector3& direction = Vector3::UnitX());

/// The largest |component| of A - B.
inline double distance(const Tensor& A, const Tensor& B) { return largest_of(A - B); }

inline Tensor deviator(const Tensor& A) { return A - A.trace() / 3 * Tensor::Identity(); }

/// Q A Q^T.
inline Tensor rotated(const Tensor& Q, const Tensor& A) { return Q * A * Q.transpose(); }

}  // namespace assay::check
