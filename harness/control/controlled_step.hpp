// SPDX-License-Identifier: BSD-3-Clause
// One step of a point under control: the deformation at its end that meets the rows, by Newton's method. Derivatives
// are differences of `update`: never a foreign tangent.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>

#include "harness/control/control.hpp"
#include "harness/material/material.hpp"
#include "harness/material/material_failure.hpp"

namespace assay {

/// How a step ended.
struct SolvedStep {
  enum class Outcome {
    solved,
    no_convergence,   ///< Newton's method found no point that meets the rows
    material_failed,  ///< `update` refused
    shorter,          ///< solved, and the material asks for a shorter step
  };
  Outcome outcome = Outcome::no_convergence;
  ControlledPoint end = {};
  double residual = 0;  ///< of the rows, in strains: stresses over the material's modulus [1]
  double shorter = 1;   ///< the factor that the material asks for
};

/// The matrix d (rows) / d (free components), rows of stress over the modulus: what tells whether rows determine the
/// deformation.
struct ControlMatrix {
  Eigen::MatrixXd matrix;
  double smallest = 1, largest = 1;   ///< singular values
  Tensor direction = Tensor::Zero();  ///< of q, in which the rows change least
  double determinant = 1;

  /// Of one number, that itself: nothing else tells whether it is none.
  double condition() const { return matrix.size() == 1 ? smallest : smallest / largest; }
};

/// The point at rest under the initial stress, or where the control begins. Throws CannotBegin.
ControlledPoint point_at_rest(const Material& material, const Control& control);

class ControlledSteps {
 public:
  /// Throws ControlError where rows and unknowns do not match, or need a component that the material does not take;
  /// MaterialFailure where the material fails at rest.
  ControlledSteps(const Material& material, const Control& control);

  ControlledPoint at_rest() const { return point_at_rest(material_, control_); }

  /// From `begin` over dt, to the values of the rows; `guess`: of q at the end.
  SolvedStep solve(const ControlledPoint& begin, double dt, const std::vector<double>& values, const Tensor& guess);

  /// From `begin` over dt without deformation: a material may relax. Nothing where it refuses.
  std::optional<ControlledPoint> held(const ControlledPoint& begin, double dt) { return end(begin, dt, begin.q); }

  /// About the end of a step that was solved, or the last that was tried.
  ControlMatrix matrix_at(const ControlledPoint& begin, double dt, const ControlledPoint& end);

  double modulus() const { return modulus_; }  ///< by which rows of stress are divided [Pa]
  /// Change of each component of the state with strain, at rest.
  const std::vector<double>& state_moduli() const { return state_moduli_; }
  std::int64_t calls() const { return calls_; }
  double least_difference() const { return least_difference_; }  ///< of q, that the material answers
  int count() const { return free_.count(); }
  /// Whether its last call would have turned the body inside out: det F <= 0.
  bool folds() const { return folds_; }
  /// Why the material refused its last step; none where it did not.
  const std::optional<MaterialFailure>& failure() const { return failure_; }
  /// Residual of each row at a point, in strains.
  Eigen::VectorXd residuals(const ControlledPoint& point, const std::vector<double>& values) const;

 private:
  using Vector = Eigen::VectorXd;
  struct Tried {
    std::vector<ControlledPoint> points;
    double dt_factor = 1;
  };
  std::optional<Tried> ends(const ControlledPoint& begin, double dt, const std::vector<Tensor>& q);
  std::optional<ControlledPoint> end(const ControlledPoint& begin, double dt, const Tensor& q);
  Vector free_residuals(const ControlledPoint& point, const std::vector<double>& values) const;
  bool find_matrix(const ControlledPoint& begin, double dt, const ControlledPoint& at,
                   const std::vector<double>& values, const Vector& residual);
  double difference(const ControlledPoint& begin, const Tensor& q, int k) const;
  void find_grain(const ControlledPoint& rest, double dt);

  const Material& material_;
  const Control& control_;
  FreeDeformation free_;
  std::vector<std::size_t> solved_rows_;  ///< rows that Newton's method meets: of stress, and of J
  double modulus_ = 1;
  std::vector<double> state_moduli_;
  double least_difference_;  ///< of q, that the material answers
  double rounding_ = 0;      ///< of the material, in strains: a residual that stands still below it is solved
  double dt_factor_ = 1;     ///< of the last call
  std::int64_t calls_ = 0;
  bool folds_ = false;
  std::optional<MaterialFailure> failure_;
  Eigen::MatrixXd matrix_;  ///< kept from step to step
  bool has_matrix_ = false;
};

}  // namespace assay
