// SPDX-License-Identifier: BSD-3-Clause
// The axes in which some components of a stiffness are least: a search over all rotations.
#pragma once

#include <functional>
#include <vector>

#include "harness/check/stiffness.hpp"

namespace assay::check {

/// The components of a stiffness, column by column, and a linear map of them.
using Components = Eigen::Matrix<double, 36, 1>;
using Projector = Eigen::Matrix<double, 36, 36>;

/// A symmetric tensor on an orthonormal basis (Mandel: 11, 22, 33, and 12, 13, 23 times sqrt(2)).
using Mandel = Eigen::Matrix<double, 6, 1>;
Mandel mandel_of(const Tensor& A);

/// A stiffness on that basis, and back.
Stiffness in_mandel(const Stiffness& C);
Stiffness without_mandel(const Stiffness& M);

/// The components of Q A Q^T from those of A, on that basis.
Stiffness rotation_in_mandel(const Tensor& Q);

/// Axes, as columns, turned about a vector in them by its length [rad].
Tensor turned_axes(const Tensor& axes, const Vector3& by);

/// Numbers that depend on axes, and their slopes when the axes turn about the first, second, third of them.
struct OfAxes {
  std::function<Eigen::VectorXd(const Tensor& axes)> value;
  std::function<Eigen::MatrixX3d(const Tensor& axes, const Eigen::VectorXd& value)> slope;
};

/// The minimum of |value| to which ways down lead from `axes`; it is enough where |value| is rounding beside 1.
Tensor minimum_from(const Tensor& axes, const OfAxes& numbers, int most_steps);

/// Axes, as columns, in which |off C| is a minimum, from many places. M: C in Mandel's form.
std::vector<Tensor> best_axes(const Stiffness& M, const Projector& off);

}  // namespace assay::check
