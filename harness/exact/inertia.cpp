// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/inertia.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"

#include <complex>

namespace assay {

InertiaField::InertiaField(const Motion& motion, double spin, std::span<const double> X, std::span<const double> Y)
    : motion_(motion), spin_(spin) {
  if (!ring_of(motion)) {
    in_box_ = is_box(motion);
    X_.assign(X.begin(), X.end()), Y_.assign(Y.begin(), Y.end());
    return;
  }
  points_ = RingPoints(X, Y);
  rings_ = RingsInMotion(motion, points_.radius);
  factor_.resize(points_.radius.size());
}

void InertiaField::set_uniform(double t) {
  const Vector3 a = state_at(motion_, Vector3::Zero(), t).a;
  of_origin_.a = {a.x(), a.y()};
  for (std::size_t d = 0; d < 2; ++d) {
    const Vector3 along = state_at(motion_, Vector3::Unit(static_cast<int>(d)), t).a - a;
    of_origin_.gradient[d] = along.x(), of_origin_.gradient[2 + d] = along.y();
  }
}

InertiaField::Factor InertiaField::factor(double R, RingKinematics ring, double t) const {
  using namespace std::complex_literals;
  ring.alpha += spin_ * t, ring.alpha_rate += spin_;
  const Polar a = ring.acceleration(), a_slope = ring.acceleration_slope();
  const std::complex<double> z = a.r + 1i * a.theta, z_slope = a_slope.r + 1i * a_slope.theta;
  const std::complex<double> turn = std::polar(1.0, ring.alpha), f = turn * (R > 0 ? z / R : z_slope);
  const std::complex<double> slope = turn * (z_slope + 1i * ring.alpha_slope * z) - f;
  return {{f.real(), f.imag()}, {slope.real(), slope.imag()}};
}

void InertiaField::set_time(double t) {
  t_ = t;
  if (in_box_) return;
  if (factor_.empty()) return set_uniform(t);
  rings_.set_time(t);
  for (std::size_t k = 0; k < factor_.size(); ++k) factor_[k] = factor(rings_.radius(k), rings_[k], t);
}

InertiaField::Inertia InertiaField::at(std::size_t point) const {
  if (in_box_) {
    const auto& motion = *motion_.as<AxisAligned>();
    const Vector3 X(X_[point], Y_[point], 0), a = motion.at(X, t_).a;
    const Tensor gradient = motion.acceleration_gradient(X, t_);
    return {{a.x(), a.y()}, {gradient(0, 0), 0, 0, gradient(1, 1)}};
  }
  if (factor_.empty()) {
    Inertia inertia = of_origin_;
    for (std::size_t d = 0; d < 2; ++d) {
      inertia.a[d] += inertia.gradient[2 * d] * X_[point] + inertia.gradient[2 * d + 1] * Y_[point];
    }
    return inertia;
  }
  const std::uint32_t ring = points_.ring[point];
  const auto& [f, slope] = factor_[ring];
  const double R = points_.radius[ring], c = points_.cos_theta[point], s = points_.sin_theta[point];
  const std::array<double, 2> across{slope[0] * c - slope[1] * s, slope[1] * c + slope[0] * s};  // X f' of (c, s)
  return {{R * (f[0] * c - f[1] * s), R * (f[1] * c + f[0] * s)},
          {f[0] + across[0] * c, -f[1] + across[0] * s, f[1] + across[1] * c, f[0] + across[1] * s}};
}

}  // namespace assay
