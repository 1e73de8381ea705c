// SPDX-License-Identifier: BSD-3-Clause
// The axes of a material: those in which some components of its stiffness are least, and those of a class, by its
// answers to strains that are not small. A stiffness at rest may have more symmetry, and then does not tell them.
#pragma once

#include <vector>

#include "harness/check/specimen.hpp"
#include "harness/check/symmetry_class.hpp"

namespace assay::check {

/// The components of a stiffness, column by column, and a linear map of them.
using Components = Eigen::Matrix<double, 36, 1>;
using Projector = Eigen::Matrix<double, 36, 36>;

/// A symmetric tensor on an orthonormal basis (Mandel: 11, 22, 33, and 12, 13, 23 times sqrt(2)).
using Mandel = Eigen::Matrix<double, 6, 1>;

/// A stiffness on that basis, and back.
Stiffness in_mandel(const Stiffness& C);
Stiffness without_mandel(const Stiffness& M);

/// The components of Q A Q^T from those of A, on that basis.
Stiffness rotation_in_mandel(const Tensor& Q);

/// Axes, as columns, in which |off C| is a minimum, from many places. M: C in Mandel's form.
std::vector<Tensor> best_axes(const Stiffness& M, const Projector& off);

/// How far a loading out and back is answered otherwise once body and frame are turned by the rotations of a class:
/// the largest component of Q^T sigma' Q - sigma, over the largest stress.
class TurnedLoading {
 public:
  /// In few steps, or in as many as the material takes. Throws MaterialFailure.
  explicit TurnedLoading(const Specimen& specimen);

  /// Of all marks, by the generators of the class about some axes. A failure is infinitely far.
  double miss(SymmetryClass symmetry, const Tensor& axes) const;

  /// Axes nearby about which the miss is least.
  Tensor refined(SymmetryClass symmetry, const Tensor& axes) const;

 private:
  Eigen::VectorXd differences(SymmetryClass symmetry, const Tensor& axes) const;
  std::vector<Tensor> stresses(const Tensor& Q) const;

  const Specimen* specimen_;
  int steps_ = 1;  ///< between two marks
  double scale_ = 0;
  std::vector<Tensor> still_;
};

/// Whether axes that suit a stiffness are some, not any: of infinitely many, those found are as many as the places that
/// the search began at.
inline bool tells_axes(const std::vector<ClassFit>& fits) { return fits.size() <= 9; }

/// The axes about which the loading is answered as the class says, as well as they can be found. `at_rest`: those of
/// the stiffness at rest; empty where it tells nothing.
ClassFit axes_of(const Specimen& specimen, const TurnedLoading& loading, SymmetryClass symmetry,
                 const std::vector<ClassFit>& at_rest);

}  // namespace assay::check
