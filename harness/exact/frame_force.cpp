// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/frame_force.hpp"

#include <cmath>

namespace assay {

FrameForce::FrameForce(const Motion& motion, double spin, std::span<const double> X, std::span<const double> Y)
    : motion_(motion), spin_(spin), X_(X.begin(), X.end()), Y_(Y.begin(), Y.end()), points_(X, Y) {
  factor_.resize(points_.radius.size());
}

FrameForce::FrameForce(const Motion& motion, double spin, std::span<const double> X, std::span<const double> Y,
                       const ReferenceDomains& domains)
    : motion_(motion), spin_(spin), X_(X.begin(), X.end()), Y_(Y.begin(), Y.end()), places_(domains.places) {
  moments_.emplace(motion->polar()->ring(), domains);
  for (const double R : moments_->nodes()) node_h_.push_back(motion->polar()->profile(R).h);
  for (const auto& shape : domains.shapes) volume_.push_back(shape.volume);
  factor_.resize(node_h_.size());
  force_.resize(volume_.size());
}

/// exp(i alpha) (-2 omega w - w^2), as parts along X and E_z x X.
Point FrameForce::factor(const AmplitudeValue& g, double h) const {
  const double alpha = g.value * h, omega = g.rate * h;  // (5), (30)
  const double inward = -spin_ * (2 * omega + spin_);
  return {inward * std::cos(alpha), inward * std::sin(alpha)};
}

void FrameForce::add_at_points(const AmplitudeValue& g, std::span<double> b_x, std::span<double> b_y) {
  for (std::size_t k = 0; k < factor_.size(); ++k)
    factor_[k] = factor(g, motion_->polar()->profile(points_.radius[k]).h);
  for (std::size_t p = 0; p < X_.size(); ++p) {
    const Point& f = factor_[points_.ring[p]];
    b_x[p] += f[0] * X_[p] - f[1] * Y_[p];
    b_y[p] += f[1] * X_[p] + f[0] * Y_[p];
  }
}

/// -w^2 X everywhere, and what the ring's own motion adds to it: that vanishes outside the ring.
void FrameForce::add_means(const AmplitudeValue& g, std::span<double> b_x, std::span<double> b_y) {
  const double square = spin_ * spin_;
  for (std::size_t k = 0; k < factor_.size(); ++k) {
    factor_[k] = factor(g, node_h_[k]);
    factor_[k][0] += square;
  }
  moments_->integrals(factor_, 0, force_.size(), force_);
  for (std::size_t k = 0; k < force_.size(); ++k) {
    for (double& component : force_[k]) component /= volume_[k];
  }
  for (std::size_t p = 0; p < X_.size(); ++p) {
    const Point more = places_[p].turned(force_[places_[p].shape]);
    b_x[p] += more[0] - square * X_[p];
    b_y[p] += more[1] - square * Y_[p];
  }
}

void FrameForce::apply(double t, std::span<double> b_x, std::span<double> b_y) {
  const AmplitudeValue g = motion_->polar()->turn().at(t);
  if (moments_)
    add_means(g, b_x, b_y);
  else
    add_at_points(g, b_x, b_y);
  const double c = std::cos(spin_ * t), s = std::sin(spin_ * t);
  for (std::size_t p = 0; p < b_x.size(); ++p) {
    const double x = b_x[p], y = b_y[p];
    b_x[p] = c * x - s * y;
    b_y[p] = s * x + c * y;
  }
}

}  // namespace assay
