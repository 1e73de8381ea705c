// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/kinds/homogeneous.hpp"

#include <algorithm>

#include "harness/motion/registry.hpp"

namespace assay {

namespace {

bool is_uniaxial_strain(const Tensor& final) {
  Tensor rest = final;
  rest(0, 0) = 1;
  return rest == Tensor::Identity() && final(0, 0) != 1;
}

}  // namespace

ExactState Homogeneous::at(const Vector3& X, double t) const {
  const Tensor rate = (final - Tensor::Identity()) / period;
  ExactState state;
  state.F = Tensor::Identity() + t * rate;
  state.x = state.F * X;  // (37)
  state.v = rate * X;
  state.F_rate = rate;
  return state;
}

double Homogeneous::own_parameter() const { return is_uniaxial_strain(final) ? final(0, 0) - 1 : 1; }

Path Homogeneous::baseline() const {
  Path path;
  const double own = own_parameter();
  path.name = is_uniaxial_strain(final) ? "uniaxial_strain" : "straight";
  path.direction = (final - Tensor::Identity()) / own;
  path.amplitude = [T = period](double t) { return t / T; };
  path.amplitude_rate = [T = period](double) { return 1 / T; };
  path.parameter = {std::min(0.0, own), std::max(0.0, own)};
  path.reversals = [](double) { return std::vector<double>(); };
  path.amplitude_range = [T = period](double end) { return Interval{0, end / T}; };
  path.recipe = recipe("homogeneous", *this);
  return path;
}

namespace {

class HomogeneousKind final : public MotionOf<HomogeneousKind, Homogeneous> {
 public:
  using MotionOf::MotionOf;
  std::string_view type() const override { return "homogeneous"; }
  double period() const override { return m.period; }
  double own_parameter() const override { return m.own_parameter(); }
  bool accelerates() const override { return false; }
  bool is_plane() const override {
    const Tensor& F = m.final;
    return F(0, 2) == 0 && F(1, 2) == 0 && F(2, 0) == 0 && F(2, 1) == 0 && F(2, 2) == 1;
  }
  void keys(Keys& keys) override {
    keys("final", "deformation gradient at t = motion.period, det F > 0", m.final,
         {.unit = "1", .derived = "none: required unless path is given"});
    period_key(keys, m.period);
  }

  /// det F > 0 all along the straight path: checked at many times, to the scene's end.
  std::optional<MotionFault> fault(const MotionUse& use) const override {
    if (use.gives("motion.interpolation"))
      return MotionFault{"motion.interpolation", "sets F between the rows of a table, so it needs motion.path"};
    if (!use.gives("motion.final")) return MotionFault{"motion.final", "required and not given"};
    const double last = std::max(1.0, use.end / m.period);
    for (int i = 0; i <= 1000; ++i) {
      const double s = last * i / 1000;
      const Tensor F = Tensor::Identity() * (1 - s) + m.final * s;
      if (F.determinant() > 0) continue;
      return MotionFault{"motion.final", "det F <= 0 on the way, at t = " + use.text(s * m.period, "s")};
    }
    if (use.by_method && use.dimension == 2 && !is_plane())
      return MotionFault{"motion.final",
                         "the method is plane strain: components 13, 23, 31, 32 must be 0 and 33 must be 1"};
    return std::nullopt;
  }
};

}  // namespace

std::unique_ptr<MotionKind> kind_of(const Homogeneous& motion) { return std::make_unique<HomogeneousKind>(motion); }

void register_homogeneous(MotionRegistry& registry) {
  registry.motion(Homogeneous{}, 2);
  registry.path<Homogeneous>("homogeneous");
}

}  // namespace assay
