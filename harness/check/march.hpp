// SPDX-License-Identifier: BSD-3-Clause
// Deformations of which the tests are made, and a material taken along them in equal steps from a given state.
#pragma once

#include <functional>
#include <type_traits>
#include <vector>

#include "harness/material/checked_update.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::check {

inline constexpr double turning_angle = 2.3;  ///< [rad], no fraction of a turn

/// The rotation about an axis, which need not be a unit vector, by an angle [rad].
Tensor turn_about(const Vector3& axis, double angle);

/// All deformations, or those of the plane 12 alone (ASSAY_IN_PLANE), with a stretch 33.
class Space {
 public:
  explicit Space(const Material& material) : is_plane_(material.has(ASSAY_IN_PLANE)) {}

  bool is_plane() const { return is_plane_; }
  /// Whether the index 0..8 of a component (ABI) is of this space.
  bool has(int component) const { return !is_plane_ || is_in_plane(component); }
  /// Without the components that are not of this space.
  Tensor within(const Tensor& A) const;
  /// By `angle` [rad] about (1, 2, 3): no component of a tensor keeps to itself; in the plane about its normal.
  Tensor turn(double angle) const;
  /// A stretch along turning axes, out, back and beyond: 0 <= s <= 1, F = I at 0.
  Tensor stretch(double amplitude, double s) const;
  /// Equal stretches along two axes, or three, that are no axes of the frame; in the plane one of two is its normal.
  /// One of them is longer by `difference`.
  Tensor equal_stretches(double amplitude, bool three, double difference) const;

 private:
  bool is_plane_;
};

/// F(t) [1] for 0 <= t <= phases; at the integers something begins or ends.
struct Loading {
  std::function<Tensor(double)> F;
  int phases = 1;
};

using Point = StepEnd;
using assay::stepped;

/// Points that a host takes together, each from a state of its own.
struct Batch {
  std::vector<std::vector<double>> states;  ///< one for each point, as the next step finds it

  /// Stresses [Pa] of one step of all points, from F0 to F1 of each. Throws MaterialFailure.
  std::vector<Tensor> step(const Material& material, double t, double dt, const std::vector<Tensor>& F0,
                           const std::vector<Tensor>& F1);
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

/// A body that is held at F in some steps of one length [s], the first of which begins at t. Throws MaterialFailure.
Point hold(const Material& material, double t, double length, const Tensor& F, Point from, int steps = 1);

/// The same from 0 to a time [s], in some steps.
Point hold_until(const Material& material, double time, const Tensor& F, Point from, int steps);

/// Throws MaterialFailure.
March march(const Material& material, const Loading& loading, const MarchOptions& options);

/// What a call gives; `otherwise` where the material fails in it.
template <class Call>
std::invoke_result_t<Call> if_taken(const Call& call,
                                    const std::type_identity_t<std::invoke_result_t<Call>>& otherwise) {
  try {
    return call();
  } catch (const MaterialFailure&) {
    return otherwise;
  }
}

/// Whether the material takes that step.
bool takes(const Material& material, const FailedStep& step);

/// State at rest under a pressure [Pa] of a material whose direction, if it has one, is `direction`. Throws
/// std::runtime_error where the material cannot carry that.
std::vector<double> state_at_rest(const Material& material, double pressure,
                                  const Vector3& direction = Vector3::UnitX());

/// The largest |component|, where none can be NaN.
template <class M>
double size_of(const Eigen::MatrixBase<M>& A) {
  return A.cwiseAbs().maxCoeff();
}

/// The largest |component| of A - B.
inline double distance(const Tensor& A, const Tensor& B) { return largest_of(A - B); }

inline Tensor deviator(const Tensor& A) { return A - A.trace() / 3 * Tensor::Identity(); }

/// Q A Q^T.
inline Tensor rotated(const Tensor& Q, const Tensor& A) { return Q * A * Q.transpose(); }

/// The multiple of `along` that is nearest to A, A : along / along : along, of numbers whose squares may overflow or
/// vanish. Not a number along nothing.
template <class M, class N>
double share_along(const Eigen::MatrixBase<M>& A, const Eigen::MatrixBase<N>& along) {
  const double unit = along.cwiseAbs().maxCoeff();
  const auto scaled = (along / unit).eval();
  return (A / unit).cwiseProduct(scaled).sum() / scaled.squaredNorm();
}

}  // namespace assay::check
