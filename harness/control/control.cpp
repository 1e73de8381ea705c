// SPDX-License-Identifier: BSD-3-Clause
#include "harness/control/control.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

namespace assay {

namespace {

using Row = Eigen::Matrix<double, 1, 9>;

Row row_of(const Tensor& A) {
  Row row;
  for (int c = 0; c < 9; ++c) row(c) = component(A, c);
  return row;
}

Tensor exponential_of_symmetric(const Tensor& e) {
  const Eigen::SelfAdjointEigenSolver<Tensor> spectrum(0.5 * (e + e.transpose()));
  const Tensor& N = spectrum.eigenvectors();
  return N * spectrum.eigenvalues().array().exp().matrix().asDiagonal() * N.transpose();
}

}  // namespace

Tensor deformation_at_rest(Deformation deformation) {
  return deformation == Deformation::gradient ? Tensor(Tensor::Identity()) : Tensor(Tensor::Zero());
}

Tensor gradient_of(Deformation deformation, const Tensor& F0, const Tensor& q0, const Tensor& q1) {
  if (deformation == Deformation::gradient) return q1;
  if (deformation == Deformation::logarithmic_strain) return exponential_of_symmetric(q1);
  return Tensor(q1 - q0).exp() * F0;
}

Tensor stress_in(StressMeasure measure, const Tensor& cauchy, const Tensor& F) {
  if (measure == StressMeasure::cauchy) return cauchy;
  if (measure == StressMeasure::kirchhoff) return F.determinant() * cauchy;
  return first_piola_kirchhoff(cauchy, F);
}

Tensor cauchy_of(StressMeasure measure, const Tensor& s, const Tensor& F) {
  if (measure == StressMeasure::cauchy) return s;
  if (measure == StressMeasure::kirchhoff) return s / F.determinant();
  return cauchy_stress(s, F);
}

double value_of(const ControlQuantity& quantity, const ControlledPoint& point) {
  const double sum = quantity.deformation.cwiseProduct(point.q).sum() + quantity.stress.cwiseProduct(point.s).sum();
  if (quantity.ln_J == 0 && quantity.J == 0) return sum;
  const double J = point.F.determinant();
  return sum + quantity.ln_J * std::log(J) + quantity.J * J;
}

/// Gauss-Jordan elimination. A row of one component alone prescribes that component to the bit, and a relation is
/// solved for its largest component.
FreeDeformation::FreeDeformation(const Control& control) {
  constexpr double dependent = 1e-10;  // of the largest coefficient of a row
  struct Equation {
    Row left;
    Eigen::VectorXd right;  ///< in the values of the prescribing rows
    int row, pivot = -1;
    double size;
  };
  std::vector<Equation> equations;
  Eigen::Index values = 0;
  for (const ControlRow& row : control.rows) values += row.is_linear_in_q() ? 1 : 0;
  const auto add = [&](const Tensor& left, Eigen::Index value, int row) {
    Equation equation{row_of(left), Eigen::VectorXd::Zero(values), row, -1, left.cwiseAbs().maxCoeff()};
    if (value >= 0) equation.right(value) = 1;
    equations.push_back(equation);
  };
  if (control.deformation == Deformation::logarithmic_strain) {
    for (const auto& [i, j] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
      Tensor skew = Tensor::Zero();
      skew(j, i) = 1, skew(i, j) = -1;
      add(skew, -1, -1);
    }
  }
  Eigen::Index value = 0;
  for (std::size_t k = 0; k < control.rows.size(); ++k) {
    if (control.rows[k].is_linear_in_q()) add(control.rows[k].deformation, value++, static_cast<int>(k));
  }
  std::array<bool, 9> taken{};
  for (Equation& equation : equations) {
    for (const Equation& other : equations) {
      if (other.pivot < 0) continue;
      const double factor = equation.left(other.pivot);
      equation.left -= factor * other.left, equation.right -= factor * other.right;
    }
    // A skew row is solved for its lower component: the upper one is the unknown.
    if (equation.left.cwiseAbs().maxCoeff(&equation.pivot) <= dependent * equation.size) {
      throw ControlError("is prescribed already by the others", equation.row);
    }
    if (equation.row < 0) {
      for (const int lower : {3, 6, 7}) equation.pivot = equation.left(lower) == 1 ? lower : equation.pivot;
    }
    const double pivot = equation.left(equation.pivot);
    equation.left /= pivot, equation.right /= pivot;
    for (Equation& other : equations) {
      if (&other == &equation || other.pivot < 0) continue;
      const double factor = other.left(equation.pivot);
      other.left -= factor * equation.left, other.right -= factor * equation.right;
    }
    taken[static_cast<std::size_t>(equation.pivot)] = true;
  }
  by_value_.assign(static_cast<std::size_t>(values), Tensor::Zero());
  for (const Equation& equation : equations) {
    for (Eigen::Index v = 0; v < values; ++v)
      component(by_value_[static_cast<std::size_t>(v)], equation.pivot) = equation.right(v);
  }
  for (int c = 0; c < 9; ++c) {
    if (taken[static_cast<std::size_t>(c)]) continue;
    free_.push_back(c);
    Tensor& direction = directions_.emplace_back(Tensor::Zero());
    component(direction, c) = 1;
    for (const Equation& equation : equations) component(direction, equation.pivot) = -equation.left(c);
  }
}

Tensor FreeDeformation::particular(const std::vector<double>& values) const {
  Tensor q = Tensor::Zero();
  for (std::size_t v = 0; v < values.size(); ++v) q += values[v] * by_value_[v];
  return q;
}

}  // namespace assay
