// SPDX-License-Identifier: BSD-3-Clause
// A function of two variables, each from -1 to 1, as a sum of a few products of polynomials.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace assay::drivers {

/// P(s) Q(u), coefficients of the powers 0, 1, ...
struct ForceTerm {
  std::vector<double> P;  ///< [m/s^2]
  std::vector<double> Q;  ///< [1]
};

/// One component of b over one piece.
using ForceSeries = std::vector<ForceTerm>;

using ForceMatrix = Eigen::MatrixXd;  ///< rows: s; columns: u

/// Chebyshev coefficients of values at Lobatto nodes, in both directions.
ForceMatrix chebyshev_coefficients(ForceMatrix values);

/// How much of a function lies in the last coefficients of each direction: s, u.
std::array<double, 2> tails(const ForceMatrix& coefficients);

/// The terms of the largest singular values, in powers, as they are written. least: what may be left out, in the unit
/// of the values.
ForceSeries separated(const ForceMatrix& coefficients, double least);

/// By Horner's rule.
double value_of(const ForceSeries& series, double s, double u);

/// A coefficient as it is written: it reads back to the same number everywhere.
std::string coefficient_text(double value);

}  // namespace assay::drivers
