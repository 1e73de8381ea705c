// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/kinds/rigid.hpp"

#include <Eigen/Geometry>

#include "harness/motion/registry.hpp"
#include "harness/numeric/norms.hpp"

namespace assay {

namespace {

/// W v = n x v.
Tensor cross_product(const Vector3& n) {
  Tensor W;
  W << 0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0;
  return W;
}

}  // namespace

ExactState Rigid::at(const Vector3& X, double t) const {
  const Vector3 n = unit_along(axis);
  const Tensor W = spin * cross_product(n);
  ExactState state;
  state.F = Eigen::AngleAxisd(spin * t, n).toRotationMatrix();
  state.F_rate = W * state.F;
  state.x = state.F * X + t * velocity;
  state.v = state.F_rate * X + velocity;
  state.a = W * (state.F_rate * X);
  return state;
}

Path Rigid::baseline() const {
  Path path;
  path.name = "rigid";
  path.parameter = {0, 1};
  path.curved = [m = *this](double, double t) {
    const ExactState state = m.at(Vector3::Zero(), t);
    return PathPoint{state.F, state.F_rate};
  };
  path.reversals = [](double) { return std::vector<double>(); };
  path.recipe = recipe("rigid", *this);
  return path;
}

namespace {

class RigidKind final : public MotionOf<RigidKind, Rigid> {
 public:
  using MotionOf::MotionOf;
  std::string_view type() const override { return "rigid"; }
  double period() const override { return m.period; }
  bool accelerates() const override { return m.spin != 0; }
  bool is_plane() const override {
    return m.velocity.z() == 0 && (m.spin == 0 || (m.axis.x() == 0 && m.axis.y() == 0));
  }
  bool is_spatial() const override { return true; }
  bool bears_tractions() const override { return false; }
  bool may_repeat() const override { return true; }
  std::string fault_of_period(std::size_t, double) const override {
    return m.spin != 0 ? "a body that spins does not repeat" : "";
  }
  void keys(Keys& keys) override {
    period_key(keys, m.period);
    keys("velocity", "velocity of the whole body", m.velocity, {.unit = "m/s"});
    keys("spin", "angular velocity of the whole body about the axis through the origin", m.spin, {.unit = "rad/s"});
    axis_key(keys, m.axis);
  }
  std::optional<MotionFault> fault(const MotionUse&) const override { return fault_of_axis(m.axis); }
};

}  // namespace

std::unique_ptr<MotionKind> kind_of(const Rigid& motion) { return std::make_unique<RigidKind>(motion); }

void register_rigid(MotionRegistry& registry) {
  registry.motion(Rigid{}, 7);
  registry.path<Rigid>("rigid");
}

}  // namespace assay
