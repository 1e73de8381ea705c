// SPDX-License-Identifier: BSD-3-Clause
// Homogeneous deformation by a table: F(t) through given values, x = F X.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/motion/motion_kind.hpp"
#include "harness/numeric/interpolant.hpp"

namespace assay {

/// F(t) through the rows of a table, each component by itself. b = F'' X is continuous where it is a spline, jumps at
/// the rows where it is monotone, and has no meaning at the rows where it is linear.
class DeformationTable {
 public:
  /// F = I at all times until 1 s: what stands for a table that was not read yet.
  explicit DeformationTable(std::string source);
  /// Two rows at least; times ascending from 0 [s], the first F is the identity. `source` names the table.
  DeformationTable(std::string source, std::span<const double> times, std::span<const Tensor> F,
                   Interpolation interpolation);

  /// The same rows with another function between them.
  DeformationTable interpolated(Interpolation interpolation) const;
  Interpolation interpolation() const { return interpolation_; }

  /// x = F X, v = F' X, a = F'' X; at a row F' and F'' are those behind it.
  ExactState at(const Vector3& X, double t) const;

  /// The scene's own path is xi = 1. F = I + xi (F(t) - I) for xi in [lower, 1], where lower is the smallest of
  /// 0, 1/2, 3/4, 7/8 .. from which det F stays well above 0.
  Path baseline() const;

  /// Times between the rows, each with its det F, to look for one that is not positive: 32 an interval.
  struct Determinant {
    double t = 0, value = 1;
    std::size_t row = 0;  ///< the interval begins with it
  };
  Determinant smallest_determinant() const;

  /// Where a component of F goes the farthest beyond the two rows around it, if that is more than rounding.
  struct Departure : Interpolant::Departure {
    int component = 0;  ///< 0 .. 8, row-major
  };
  std::optional<Departure> farthest_departure() const;

  /// Whether components 13, 23, 31, 32 are 0 and 33 is 1 at all times.
  bool plane() const;

  const std::string& source() const { return source_; }
  double last() const { return times_.back(); }  ///< time of the last row [s]
  const std::vector<double>& times() const { return times_; }
  std::vector<Tensor> rows() const;  ///< F at the times, as given

 private:
  Tensor value(double t, int derivative) const;
  double lowest_parameter() const;
  std::string source_;
  std::vector<double> times_;
  Interpolation interpolation_;
  std::vector<Interpolant> components_;  // nine, row-major
};

std::unique_ptr<MotionKind> kind_of(const DeformationTable& motion);

}  // namespace assay
