// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/kinds/rotating_stretch.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/motion/amplitude.hpp"
#include "harness/motion/registry.hpp"
#include "harness/numeric/norms.hpp"

namespace assay {

namespace {

using std::numbers::pi;

/// A function of time with its first two rates [1], [1/s], [1/s^2].
struct Smooth {
  double value = 0, rate = 0, acceleration = 0;
};

/// q(u) = u^3 (10 - 15 u + 6 u^2), 0 before u = 0 and 1 after u = 1, where q' = q'' = 0; u' constant [1/s].
Smooth smooth_ramp(double u, double u_rate) {
  if (u <= 0) return {};
  if (u >= 1) return {1, 0, 0};
  return {u * u * u * (10 - 15 * u + 6 * u * u), 30 * u * u * (1 - u) * (1 - u) * u_rate,
          60 * u * (1 - u) * (1 - 2 * u) * u_rate * u_rate};
}

/// sin^2(pi t/T).
Smooth sine_squared(double t, double T) {
  const double phase = pi / T * std::fmod(t, T), s = std::sin(phase);
  return {s * s, pi / T * std::sin(2 * phase), 2 * pi * pi / (T * T) * std::cos(2 * phase)};
}

/// (Lambda - 1)/a.
Smooth stretching(const RotatingStretch& m, double t) {
  return m.rotate == RotatingStretch::Rotate::after ? smooth_ramp(2 * t / m.period, 2 / m.period)
                                                    : sine_squared(t, m.period);
}

/// angle/beta.
Smooth turning(const RotatingStretch& m, double t) {
  switch (m.rotate) {
    case RotatingStretch::Rotate::none:
      return {};
    case RotatingStretch::Rotate::simultaneous:
      return smooth_ramp(t / m.period, 1 / m.period);
    case RotatingStretch::Rotate::after:
      return smooth_ramp(2 * t / m.period - 1, 2 / m.period);
  }
  return {};
}

/// F and its first two rates [1], [1/s], [1/s^2].
struct Deformation {
  Tensor F, rate, acceleration;
};

Deformation deformation(const RotatingStretch& m, double xi, double t) {
  const Smooth s = stretching(m, t), angle = turning(m, t);
  Tensor D = Tensor::Zero();
  D(0, 0) = xi * m.stretch;
  D(0, 1) = xi * m.shear;
  const Vector3 n = unit_along(m.axis);
  Tensor W;  // W v = n x v
  W << 0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0;
  const Tensor Q = Eigen::AngleAxisd(m.rotation * angle.value, n).toRotationMatrix();
  const double omega = m.rotation * angle.rate;
  const Tensor Q_rate = omega * W * Q,
               Q_acceleration = (m.rotation * angle.acceleration * W + omega * omega * W * W) * Q;
  const Tensor U = Tensor::Identity() + s.value * D;
  return {Q * U, Q_rate * U + s.rate * Q * D, Q_acceleration * U + 2 * s.rate * Q_rate * D + s.acceleration * Q * D};
}

}  // namespace

ExactState RotatingStretch::at(const Vector3& X, double t) const {
  const Deformation d = deformation(*this, 1, t);
  return {d.F * X, d.rate * X, d.acceleration * X, d.F, d.rate};
}

Path RotatingStretch::baseline() const {
  Path path;
  path.name = "rotating_stretch";
  path.parameter = {0, 1};
  path.curved = [m = *this](double xi, double t) {
    const Deformation d = deformation(m, xi, t);
    return PathPoint{d.F, d.rate};
  };
  // Lambda' = 0 at the multiples of T/2; the ramps begin and end there
  path.reversals = [m = *this](double end) {
    const double last = m.rotate == Rotate::after ? 1.25 * m.period : HUGE_VAL;  // after T nothing moves
    return times_before(std::min(end, last), [&](double k) { return 0.5 * m.period * (k + 1); });
  };
  path.recipe = recipe("rotating_stretch", *this);
  return path;
}

namespace {

class RotatingStretchKind final : public MotionOf<RotatingStretchKind, RotatingStretch> {
 public:
  using MotionOf::MotionOf;
  std::string_view type() const override { return "rotating_stretch"; }
  double period() const override { return m.period; }
  bool is_plane() const override {
    return m.rotate == RotatingStretch::Rotate::none || m.rotation == 0 || (m.axis.x() == 0 && m.axis.y() == 0);
  }
  bool is_spatial() const override { return true; }
  void keys(Keys& keys) override {
    period_key(keys, m.period);
    keys("stretch", "a: the stretch along E1 is 1 + a sin^2(pi t/T), or 1 + a q(2 t/T) with rotate: after", m.stretch,
         {.unit = "1", .range = {.lower = -1, .lower_open = true}, .required = true});
    keys("shear", "k of the shear U12 = k (U11 - 1)/a", m.shear, {.unit = "1"});
    keys("rotation", "total angle of rotation beta", m.rotation, {.unit = "rad"});
    axis_key(keys, m.axis);
    keys("rotate", "when the body rotates: never (none), while it stretches (simultaneous) or afterwards (after)",
         m.rotate);
  }
  std::optional<MotionFault> fault(const MotionUse&) const override { return fault_of_axis(m.axis); }
};

}  // namespace

std::unique_ptr<MotionKind> kind_of(const RotatingStretch& motion) {
  return std::make_unique<RotatingStretchKind>(motion);
}

void register_rotating_stretch(MotionRegistry& registry) {
  registry.motion(RotatingStretch{}, 6);
  registry.path<RotatingStretch>("rotating_stretch");
}

}  // namespace assay
