// SPDX-License-Identifier: BSD-3-Clause
// Chebyshev interpolation on an interval: Lobatto nodes, coefficients, values and derivatives.
#pragma once

#include <span>
#include <vector>

#include "harness/numeric/range.hpp"

namespace assay::chebyshev {

/// n >= 2 Lobatto nodes in ascending order, both ends of the interval among them.
std::vector<double> nodes(const Interval& interval, int n);

/// Coefficients c_k of sum c_k T_k from values at `nodes`.
std::vector<double> coefficients(std::span<const double> values);

/// T_k(x) and T_k'(x) (per unit of x) for k = 0 .. n-1.
void basis(double x, std::span<double> T, std::span<double> T_prime);

/// n Gauss nodes in (0, 1), ascending: none on the ends.
std::vector<double> gauss_nodes(int n);

/// From values at the n Gauss nodes to the coefficients of sum c_k T_k(2 s - 1) on [0, 1], for any number of lines.
class GaussTransform {
 public:
  explicit GaussTransform(int n);

  /// `values` becomes the coefficients, in place; each is `stride` from the next.
  void operator()(double* values, std::size_t stride = 1) const;

 private:
  std::size_t n_;
  std::vector<double> matrix_;
};

}  // namespace assay::chebyshev
