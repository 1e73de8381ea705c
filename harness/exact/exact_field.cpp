// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/exact_field.hpp"

#include <algorithm>
#include <cmath>

namespace assay {

namespace {

using Matrix2 = std::array<double, 4>;

Matrix2 product(const Matrix2& a, const Matrix2& b) {
  return {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3]};
}
Matrix2 transposed(const Matrix2& a) { return {a[0], a[2], a[1], a[3]}; }
Matrix2 rotation(double c, double s) { return {c, -s, s, c}; }

std::array<double, 5> plane(const Tensor& s) { return {s(0, 0), s(0, 1), s(1, 0), s(1, 1), s(2, 2)}; }

}  // namespace

ExactField::ExactField(std::shared_ptr<const ExactSolution> solution, const Frame& frame, std::span<const double> X,
                       std::span<const double> Y)
    : solution_(std::move(solution)), frame_(frame), X_(X.begin(), X.end()), Y_(Y.begin(), Y.end()) {
  if (const auto* box = solution_->box()) box_.emplace(**box, X, Y);
  const auto ring = ring_of(solution_->motion());
  if (!ring) return;
  points_ = RingPoints(X, Y);
  rings_.resize(points_.radius.size());
  const bool all = solution_->motion()->polar()->widens();  // its faces move, too
  for (const double R : points_.radius) {
    moves_.push_back(all || (R > ring->inner && R < ring->outer));
    parameter_.push_back(ring_parameter(solution_->motion(), R).value);
  }
}

void ExactField::set_motion(double t, double velocity_time) {
  t_ = t, velocity_time_ = velocity_time;
  if (box_) return;
  if (!rings_.empty()) return turn_rings(t, velocity_time);
  now_ = solution_->state(Vector3::Zero(), t);
  then_ = solution_->state(Vector3::Zero(), velocity_time);
}

void ExactField::set_time(double t, double velocity_time) {
  set_motion(t, velocity_time);
  if (const auto* box = solution_->box()) {
    (*box)->set_time(t);
    return box_->update(**box);
  }
  if (!rings_.empty()) return stress_rings(t);
  if (X_.empty()) return;
  const ExactStress stress = solution_->stress(Vector3::Zero(), t);
  sigma_ = plane(stress.cauchy);
  std::copy_n(plane(stress.first_piola_kirchhoff).begin(), piola_.size(), piola_.begin());
}

/// To a frame that spins every ring turns by spin t more.
void ExactField::turn_rings(double t, double velocity_time) {
  for (std::size_t k = 0; k < rings_.size(); ++k) {
    const double R = points_.radius[k];
    const RingKinematics now = ring_kinematics(solution_->motion(), R, t);
    Ring& ring = rings_[k];
    const double alpha = now.alpha + frame_.spin * t;
    ring.cos_alpha = std::cos(alpha), ring.sin_alpha = std::sin(alpha);
    const Tensor B = now.baseline(R);
    ring.x = {B(1, 1) * ring.cos_alpha, B(1, 1) * ring.sin_alpha};
    ring.B = {B(0, 0), B(0, 1), B(1, 0), B(1, 1)};
    const RingKinematics then = ring_kinematics(solution_->motion(), R, velocity_time);
    const double beta = then.alpha + frame_.spin * velocity_time, c = std::cos(beta), s = std::sin(beta);
    const double along = R > 0 ? then.rho_rate / R : then.rho_slope_rate;
    const double across = then.baseline(R)(1, 1) * (then.alpha_rate + frame_.spin);
    ring.v = {c * along - s * across, s * along + c * across};
  }
}

void ExactField::stress_rings(double t) {
  (*solution_->response())->at_time(t, parameter_, [&](std::size_t k, const Tensor& tau, const Tensor&) {
    Tensor B = Tensor::Identity();
    B(0, 0) = rings_[k].B[0], B(1, 0) = rings_[k].B[2], B(1, 1) = rings_[k].B[3];
    rings_[k].sigma = plane(cauchy_stress(tau, B));
    std::copy_n(plane(tau).begin(), rings_[k].tau.size(), rings_[k].tau.begin());
  });
}

PlaneState ExactField::at_ring(std::size_t p) const {
  const Ring& ring = rings_[points_.ring[p]];
  const Matrix2 q = rotation(points_.cos_theta[p], points_.sin_theta[p]);
  const Matrix2 r = product(rotation(ring.cos_alpha, ring.sin_alpha), q);  // (17)
  const Matrix2 sigma =
      product(product(r, {ring.sigma[0], ring.sigma[1], ring.sigma[2], ring.sigma[3]}), transposed(r));
  const double X = X_[p], Y = Y_[p];
  PlaneState state;
  state.x = {ring.x[0] * X - ring.x[1] * Y + frame_.velocity.x() * t_,
             ring.x[1] * X + ring.x[0] * Y + frame_.velocity.y() * t_};
  state.v = {ring.v[0] * X - ring.v[1] * Y + frame_.velocity.x(), ring.v[1] * X + ring.v[0] * Y + frame_.velocity.y()};
  state.F = product(product(r, ring.B), transposed(q));
  state.sigma = {sigma[0], sigma[1], sigma[2], sigma[3], ring.sigma[4]};
  return state;
}

PlaneState ExactField::in_box(std::size_t p) const {
  const Vector3 X(X_[p], Y_[p], 0);
  const ExactState now = solution_->state(X, t_), then = solution_->state(X, velocity_time_);
  const auto P = box_->at(p);
  const double F11 = now.F(0, 0), F22 = now.F(1, 1);
  return {{now.x.x(), now.x.y()},
          {then.v.x(), then.v.y()},
          {F11, 0, 0, F22},
          {P[0] / F22, 0, 0, P[1] / F11, P[2] / (F11 * F22)}};  // sigma = P F^T / J
}

PlaneState ExactField::at(std::size_t p) const {
  if (box_) return in_box(p);
  if (!rings_.empty()) return at_ring(p);
  const Vector3 X(X_[p], Y_[p], 0);
  const Vector3 x = now_.x + now_.F * X, v = then_.v + then_.F_rate * X;
  return {{x.x(), x.y()}, {v.x(), v.y()}, {now_.F(0, 0), now_.F(0, 1), now_.F(1, 0), now_.F(1, 1)}, sigma_};
}

std::array<double, 4> ExactField::first_piola_kirchhoff(std::size_t p) const {
  if (box_) {
    const auto P = box_->at(p);
    return {P[0], 0, 0, P[1]};
  }
  if (rings_.empty()) return piola_;
  const Ring& ring = rings_[points_.ring[p]];
  const Matrix2 q = rotation(points_.cos_theta[p], points_.sin_theta[p]);
  const Matrix2 r = product(rotation(ring.cos_alpha, ring.sin_alpha), q);
  return product(product(r, ring.tau), transposed(q));  // (20)
}

double ExactField::measure(std::size_t p, const std::array<double, 4>& F) const {
  if (!is_vortex(solution_->motion())) return F[0] * F[3] - F[1] * F[2];
  const Ring& ring = rings_[points_.ring[p]];
  const Matrix2 q = rotation(points_.cos_theta[p], points_.sin_theta[p]);
  const Matrix2 r = product(rotation(ring.cos_alpha, ring.sin_alpha), q);
  return product(product(transposed(r), F), q)[2];
}

}  // namespace assay
