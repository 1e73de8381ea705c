// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/kinds/twisting_ring.hpp"

#include <algorithm>
#include <cmath>

#include "harness/motion/registry.hpp"

namespace assay {

AmplitudeValue TwistingRing::widening(double t) const {
  const AmplitudeValue s = Amplitude{Amplitude::Type::sine, 1, period()}.at(t);
  return {expansion * s.value, expansion * s.rate, expansion * s.acceleration};
}

RingRadial TwistingRing::radial(double R) const {
  const double ri = twist.inner, ro = twist.outer, d = ro * ro * (ro - 3 * ri);
  const double c1 = -6 * ri * ro / d, c2 = 3 * (ri + ro) / d, c3 = -2 / d;
  return {R * (c1 + R * (c2 + R * c3)), c1 + R * (2 * c2 + 3 * R * c3)};
}

RingKinematics TwistingRing::ring(double R, double t) const {
  RingKinematics k = twist.ring(R, t);
  k.widen(radial(R), widening(t));
  return k;
}

ExactState TwistingRing::at(const Vector3& X, double t) const { return ring(std::hypot(X.x(), X.y()), t).state(X); }

Path TwistingRing::baseline() const {
  Path path;
  path.name = "twisting_ring";
  path.parameter = {inner(), outer()};
  path.parameter_is_place = true;
  path.curved = [m = *this](double R, double t) {
    const RingKinematics k = m.ring(R, t);
    return PathPoint{k.baseline(R), k.baseline_rate(R)};
  };
  path.reversals = [m = *this](double end) {
    std::vector<double> times = m.twist.amplitude.reversals(end);
    for (const double t : Amplitude{Amplitude::Type::sine, 1, m.period()}.reversals(end)) times.push_back(t);
    std::sort(times.begin(), times.end());
    const auto same = [&](double a, double b) { return b - a <= 1e-12 * m.period(); };
    times.erase(std::unique(times.begin(), times.end(), same), times.end());
    return times;
  };
  path.recipe = recipe("twisting_ring", *this);
  return path;
}

namespace {

class TwistingRingKind final : public MotionOf<TwistingRingKind, TwistingRing>, public PolarMotion {
 public:
  using MotionOf::MotionOf;
  std::string_view type() const override { return "twisting_ring"; }
  double period() const override { return m.period(); }
  const Amplitude* amplitude() const override { return &m.twist.amplitude; }
  const PolarMotion* polar() const override { return this; }
  std::optional<Vector3> reference_of(const Vector3& x, double t) const override { return turned_back(x, t); }
  double length() const override { return m.twist.length(); }

  Annulus ring() const override { return {m.inner(), m.outer()}; }
  const Amplitude& turn() const override { return m.twist.amplitude; }
  RingProfile profile(double R) const override { return m.twist.profile(R); }
  bool widens() const override { return true; }
  RingRadial radial(double R) const override { return m.radial(R); }
  AmplitudeValue widening(double t) const override { return m.widening(t); }

  void keys(Keys& keys) override {
    ring_keys(keys, m.twist);
    keys("expansion", "e: radii change by e sin(pi t/T) U(R), with U = 1 at the outer radius", m.expansion,
         {.unit = "m", .required = true});
    m.twist.amplitude.keys(keys);
  }
  std::optional<MotionFault> fault(const MotionUse& use) const override {
    if (auto found = fault_of_radii(ring(), use)) return found;
    const double ri = m.inner(), ro = m.outer();
    if (std::abs(ro - 3 * ri) <= 1e-9 * ro)
      return MotionFault{"motion.outer", "must not be 3 times motion.inner: no cubic U then moves the outer face"};
    constexpr int looks = 200;
    for (int k = 0; k <= looks; ++k) {  // det F = rho' rho/R
      const double R = ri + (ro - ri) * k / looks;
      const RingRadial u = m.radial(R);
      const double most = std::abs(m.expansion) * std::max(std::abs(u.slope), std::abs(u.U) / R);
      if (most < 1) continue;
      return MotionFault{"motion.expansion", "det F <= 0 on the way, at R = " + use.text(R, "m") +
                                                 ": must be less in size than " +
                                                 use.text(std::abs(m.expansion) / most, "m", 4) + " there, found " +
                                                 use.text(m.expansion, "m")};
    }
    return std::nullopt;
  }
};

}  // namespace

std::unique_ptr<MotionKind> kind_of(const TwistingRing& motion) { return std::make_unique<TwistingRingKind>(motion); }

void register_twisting_ring(MotionRegistry& registry) {
  registry.motion(TwistingRing{}, 3);
  registry.path<TwistingRing>("twisting_ring");
}

}  // namespace assay
