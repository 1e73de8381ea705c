// SPDX-License-Identifier: BSD-3-Clause
#include "harness/control/controlled_step.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace assay {

namespace {

constexpr int most_iterations = 40;
constexpr double exact = 3e-17;              ///< a residual in strains that cannot become smaller
constexpr double rounding_of_F = 2e-15;      ///< one that stands still below this is rounding of F
constexpr double good_progress = 0.1;        ///< of a residual by one iteration: the matrix is kept
constexpr double standstill = 0.5;           ///< of a residual: no progress
constexpr int most_halvings = 12;            ///< of an iteration that would make the residual larger
constexpr double sufficient = 1e-4;          ///< share of the decrease that a linear function would have
constexpr double largest_difference = 1e-7;  ///< of q
constexpr double difference_share = 1e-2;    ///< of the change of q over the step
constexpr double longest_iteration = 0.3;    ///< largest change of q by one iteration

}  // namespace

/// Ends of steps to some q, by one call of the material.
std::optional<ControlledSteps::Tried> ControlledSteps::ends(const ControlledPoint& begin, double dt,
                                                            const std::vector<Tensor>& q) {
  const std::size_t n = q.size(), states = begin.state.size();
  std::vector<double> F0(9 * n), F1(9 * n), state0(states * n), state1(states * n), cauchy(9 * n);
  std::vector<Tensor> F(n);
  folds_ = false;
  for (std::size_t p = 0; p < n; ++p) {
    F[p] = gradient_of(control_.deformation, begin.F, begin.q, q[p]);
    if (!F[p].allFinite() || !(F[p].determinant() > 0)) {
      failure_.reset();
      folds_ = true;
      return std::nullopt;
    }
    put_tensor(begin.F, F0.data(), n, p);
    put_tensor(F[p], F1.data(), n, p);
    put_point(begin.state, state0.data(), n, p);
  }
  calls_ += static_cast<std::int64_t>(n);
  const UpdateReport report =
      material_.update(begin.t, dt, n, F0.data(), F1.data(), state0.data(), state1.data(), cauchy.data());
  dt_factor_ = report.dt_factor;
  if (report.worst == ASSAY_FAILED) {
    failure_.emplace(report.message, 1.0, begin.t + dt,
                     failed_step(material_, begin.t, dt, n, report.worst_point, F0.data(), F1.data(), state0.data()));
    failure_->not_finite = report.not_finite;
    failure_->final = report.dt_factor == 0;
    return std::nullopt;
  }
  failure_.reset();
  Tried tried;
  tried.dt_factor = report.dt_factor;
  const Tensor P0 = first_piola_kirchhoff(cauchy_of(control_.stress, begin.s, begin.F), begin.F);
  for (std::size_t p = 0; p < n; ++p) {
    ControlledPoint& point = tried.points.emplace_back();
    const Tensor sigma = tensor_at(cauchy.data(), n, p);
    point.t = begin.t + dt;
    point.q = q[p];
    point.F = F[p];
    point.s = stress_in(control_.stress, sigma, F[p]);
    point.state = point_of(state1.data(), n, p, states);
    point.work = begin.work + 0.5 * (P0 + first_piola_kirchhoff(sigma, F[p])).cwiseProduct(F[p] - begin.F).sum();
  }
  return tried;
}

std::optional<ControlledPoint> ControlledSteps::end(const ControlledPoint& begin, double dt, const Tensor& q) {
  auto tried = ends(begin, dt, {q});
  return tried ? std::optional(std::move(tried->points[0])) : std::nullopt;
}

Eigen::VectorXd ControlledSteps::residuals(const ControlledPoint& point, const std::vector<double>& values) const {
  Vector residual(static_cast<Eigen::Index>(control_.rows.size()));
  for (std::size_t k = 0; k < control_.rows.size(); ++k) {
    const ControlRow& row = control_.rows[k];
    const double scale = row.has_stress() ? modulus_ * row.stress.cwiseAbs().maxCoeff() : 1;
    residual(static_cast<Eigen::Index>(k)) = (value_of(row, point) - values[k]) / scale;
  }
  return residual;
}

Eigen::VectorXd ControlledSteps::free_residuals(const ControlledPoint& point, const std::vector<double>& values) const {
  const Vector all = residuals(point, values);
  Vector chosen(static_cast<Eigen::Index>(solved_rows_.size()));
  for (std::size_t k = 0; k < solved_rows_.size(); ++k)
    chosen(static_cast<Eigen::Index>(k)) = all(static_cast<Eigen::Index>(solved_rows_[k]));
  return chosen;
}

/// Small against the step, so that the differences stay on the branch that the step is on, and along it.
double ControlledSteps::difference(const ControlledPoint& begin, const Tensor& q, int k) const {
  const double change = free_.coordinate(q, k) - free_.coordinate(begin.q, k);
  const double step = (q - begin.q).cwiseAbs().maxCoeff();
  const double size =
      std::clamp(difference_share * step, least_difference_, std::max(largest_difference, least_difference_));
  return change < 0 ? -size : size;
}

bool ControlledSteps::find_matrix(const ControlledPoint& begin, double dt, const ControlledPoint& at,
                                  const std::vector<double>& values, const Vector& residual) {
  std::vector<Tensor> q;
  std::vector<double> sizes;
  for (int k = 0; k < free_.count(); ++k) {
    sizes.push_back(difference(begin, at.q, k));
    q.push_back(at.q + sizes.back() * free_.direction(k));
  }
  const auto tried = ends(begin, dt, q);
  if (!tried) return false;
  matrix_.resize(residual.size(), residual.size());
  for (int k = 0; k < free_.count(); ++k) {
    const auto at_k = static_cast<std::size_t>(k);
    matrix_.col(k) = (free_residuals(tried->points[at_k], values) - residual) / sizes[at_k];
  }
  return has_matrix_ = matrix_.allFinite();
}

SolvedStep ControlledSteps::solve(const ControlledPoint& begin, double dt, const std::vector<double>& values,
                                  const Tensor& guess) {
  SolvedStep solved;
  std::vector<double> prescribed;
  for (std::size_t k = 0; k < control_.rows.size(); ++k) {
    if (control_.rows[k].is_linear_in_q()) prescribed.push_back(values[k]);
  }
  const auto q_of = [&](const Vector& z) {
    Tensor q = free_.particular(prescribed);
    for (int k = 0; k < free_.count(); ++k) q += z(k) * free_.direction(k);
    return q;
  };
  const auto refused = [&] {
    solved.outcome = failure_ ? SolvedStep::Outcome::material_failed : SolvedStep::Outcome::no_convergence;
    return solved;
  };
  Vector z(free_.count());
  for (int k = 0; k < free_.count(); ++k) z(k) = free_.coordinate(guess, k);
  auto now = end(begin, dt, q_of(z));
  if (!now) {
    for (int k = 0; k < free_.count(); ++k) z(k) = free_.coordinate(begin.q, k);
    now = end(begin, dt, q_of(z));
    if (!now) return refused();
  }
  Vector residual = free_residuals(*now, values);
  double size = residual.size() > 0 ? residual.cwiseAbs().maxCoeff() : 0;
  bool fresh = false;
  for (int i = 0; size > exact; ++i) {
    if (i == most_iterations) {
      solved.end = *now;
      return solved;
    }
    if (!has_matrix_ && !fresh) {
      if (!find_matrix(begin, dt, *now, values, residual)) {
        if (!failure_) solved.end = *now;
        return refused();
      }
      fresh = true;
    }
    Vector change = -matrix_.fullPivLu().solve(residual);
    if (!change.allFinite()) {
      solved.end = *now;
      return solved;
    }
    const double longest = change.cwiseAbs().maxCoeff();
    if (longest > longest_iteration) change *= longest_iteration / longest;
    double share = 1, next_size = 0;
    std::optional<ControlledPoint> next;
    Vector next_residual;
    for (int h = 0; h < most_halvings; ++h, share *= 0.5) {
      next = end(begin, dt, q_of(z + share * change));
      if (!next) continue;
      next_residual = free_residuals(*next, values);
      next_size = next_residual.cwiseAbs().maxCoeff();
      if (next_size <= (1 - sufficient * share) * size || (size < rounding_ && share == 1)) break;
      if (!fresh) break;  // an old matrix: a new one is better than a part of its step
    }
    if (!next && !fresh) {
      has_matrix_ = false;
      continue;
    }
    if (!next) return refused();
    const bool smaller = next_size < size;
    if (!smaller && size < rounding_of_F) break;
    if (smaller || fresh) {
      const bool stands = next_size > standstill * size;
      if (!smaller && size < rounding_) break;  // as good as it gets
      if (!smaller) {
        solved.end = *now;
        return solved;
      }
      z += share * change;
      now = next;
      // Broyden's update: what the step has shown of the matrix.
      if (share == 1 && !fresh) {
        matrix_ += (next_residual - residual - matrix_ * change) * change.transpose() / change.squaredNorm();
      }
      const bool progress = next_size <= good_progress * size;
      residual = next_residual;
      if (stands && fresh && next_size < rounding_) {
        size = next_size;
        break;
      }
      size = next_size;
      if (!progress) has_matrix_ = false;
      fresh = false;
    } else {
      has_matrix_ = false;
    }
  }
  solved.end = std::move(*now);
  solved.residual = size;
  solved.shorter = dt_factor_;
  solved.outcome = dt_factor_ < 1 && dt_factor_ > 0 ? SolvedStep::Outcome::shorter : SolvedStep::Outcome::solved;
  return solved;
}

ControlMatrix ControlledSteps::matrix_at(const ControlledPoint& begin, double dt, const ControlledPoint& end) {
  ControlMatrix found;
  if (free_.count() == 0) return found;
  const std::vector<double> none(control_.rows.size(), 0.0);
  if (!find_matrix(begin, dt, end, none, free_residuals(end, none))) return found;
  found.matrix = matrix_;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix_, Eigen::ComputeFullV);
  found.largest = svd.singularValues()(0);
  found.smallest = svd.singularValues()(matrix_.rows() - 1);
  found.determinant = matrix_.determinant();
  for (int k = 0; k < free_.count(); ++k) found.direction += svd.matrixV()(k, matrix_.rows() - 1) * free_.direction(k);
  return found;
}

}  // namespace assay
