// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/kinds/vortex.hpp"

#include <algorithm>
#include <cmath>

#include "harness/motion/motion.hpp"
#include "harness/motion/registry.hpp"

namespace assay {

namespace {

/// Radii this close to ri or ro [relative] count as ri or ro: a point given on the edge must not fall outside by the
/// rounding of sqrt(X^2 + Y^2).
constexpr double edge_tolerance = 1e-14;

constexpr int samples = 512;  ///< of the ring: xi' is not looked at in between
constexpr int bisections = 60;

/// Where `holds` changes between low and high, by bisection.
double change_between(double low, double high, const auto& holds) {
  const bool at_low = holds(low);
  for (int k = 0; k < bisections; ++k) {
    const double middle = 0.5 * (low + high);
    (holds(middle) == at_low ? low : high) = middle;
  }
  return low;
}

}  // namespace

RingProfile Vortex::profile(double R) const {
  if (std::abs(R - inner) <= edge_tolerance * inner) R = inner;
  if (std::abs(R - outer) <= edge_tolerance * outer) R = outer;
  if (R < inner || R > outer) return {};
  const int m = profile_power;
  const double half_width = 0.5 * (outer - inner);
  const double s = (R - 0.5 * (inner + outer)) / half_width;
  const double q = (outer - R) * (R - inner) / (half_width * half_width);  // 1 - s^2, exactly 0 on the edges
  const double lower_power = std::pow(q, m - 2);                           // 1 for m = 2, on the edges too
  RingProfile p;
  p.h = lower_power * q * q;
  p.h_prime = -2 * m * lower_power * q * s / half_width;
  const double h_second = (4 * m * (m - 1) * lower_power * s * s - 2 * m * lower_power * q) / (half_width * half_width);
  p.xi = 0.5 * R * p.h_prime;  // (13)
  p.xi_prime = 0.5 * (p.h_prime + R * h_second);
  return p;
}

bool Vortex::moves(const Vector3& X) const {
  const double R = std::hypot(X.x(), X.y());
  return R > inner && R < outer;
}

ExactState Vortex::at(const Vector3& X, double t) const {
  const double R = std::hypot(X.x(), X.y());
  const RingProfile p = profile(R);
  const AmplitudeValue g = amplitude.at(t);
  const Tensor Q = rotation_about_z(g.value * p.h);  // (4), (5)
  ExactState state;
  state.x = Q * X;                                  // (3)
  const Vector3 A_x(-state.x.y(), state.x.x(), 0);  // A x = E_z x x (8)
  const Vector3 in_plane(state.x.x(), state.x.y(), 0);
  const double omega = g.rate * p.h;                                // (30) [rad/s]
  state.v = omega * A_x;                                            // (28)
  state.a = g.acceleration * p.h * A_x - omega * omega * in_plane;  // (29)
  Tensor shear = Tensor::Identity(), shear_rate = Tensor::Zero();
  if (R > 0) {
    const Vector3 E_R(X.x() / R, X.y() / R, 0), E_Theta(-X.y() / R, X.x() / R, 0);
    shear += R * g.value * p.h_prime * E_Theta * E_R.transpose();
    shear_rate = R * g.rate * p.h_prime * E_Theta * E_R.transpose();
  }
  state.F = Q * shear;        // (12)
  Tensor W = Tensor::Zero();  // A of (8)
  W(0, 1) = -1, W(1, 0) = 1;
  state.F_rate = omega * W * state.F + Q * shear_rate;
  return state;
}

std::vector<double> turning_radii(const Vortex& vortex) {
  const auto radius = [&](int i) { return vortex.inner + (vortex.outer - vortex.inner) * i / samples; };
  const auto rises = [&](double R) { return vortex.profile(R).xi_prime > 0; };
  std::vector<double> radii{vortex.inner};
  for (int i = 0; i < samples; ++i) {
    if (rises(radius(i)) != rises(radius(i + 1))) radii.push_back(change_between(radius(i), radius(i + 1), rises));
  }
  radii.push_back(vortex.outer);
  return radii;
}

std::vector<double> RadiiOfXi::operator()(double xi) const {
  const auto below = [&](double R) { return vortex_.profile(R).xi < xi; };
  std::vector<double> radii;
  for (std::size_t k = 0; k + 1 < turning_.size(); ++k) {
    const double low = turning_[k], high = turning_[k + 1];
    if (below(low) != below(high)) radii.push_back(change_between(low, high, below));
  }
  return radii;
}

Interval Vortex::xi_range() const {
  Interval range;
  for (const double R : turning_radii(*this)) {
    const double extreme = profile(R).xi;
    range.lower = std::min(range.lower, extreme);
    range.upper = std::max(range.upper, extreme);
  }
  return range;
}

Path Vortex::baseline() const {
  Path path;
  path.name = "simple_shear";
  path.direction(1, 0) = 2;  // (16): F = I + 2 eps E2 E1
  path.amplitude = [g = amplitude](double t) { return g.at(t).value; };
  path.amplitude_rate = [g = amplitude](double t) { return g.at(t).rate; };
  path.parameter = xi_range();
  path.reversals = [g = amplitude](double end) { return g.reversals(end); };
  path.amplitude_range = [g = amplitude](double end) {
    const auto [lower, upper] = g.range(end);
    return Interval{lower, upper};
  };
  path.recipe = recipe("vortex", *this);
  return path;
}

namespace {

class VortexKind final : public MotionOf<VortexKind, Vortex>, public PolarMotion {
 public:
  using MotionOf::MotionOf;
  std::string_view type() const override { return "vortex"; }
  double period() const override { return m.amplitude.period; }
  const Amplitude* amplitude() const override { return &m.amplitude; }
  bool bears_tractions() const override { return false; }
  double length() const override { return m.length(); }
  bool is_symmetry_plane(std::size_t d, double) const override { return d == 2; }
  const PolarMotion* polar() const override { return this; }
  std::optional<Vector3> reference_of(const Vector3& x, double t) const override { return turned_back(x, t); }

  Annulus ring() const override { return {m.inner, m.outer}; }
  const Amplitude& turn() const override { return m.amplitude; }
  RingProfile profile(double R) const override { return m.profile(R); }
  std::function<std::vector<double>(double)> radii_of_parameter() const override { return RadiiOfXi(m); }

  void keys(Keys& keys) override {
    ring_keys(keys, m);
    m.amplitude.keys(keys);
  }
  std::optional<MotionFault> fault(const MotionUse& use) const override { return fault_of_radii(ring(), use); }
};

}  // namespace

std::unique_ptr<MotionKind> kind_of(const Vortex& motion) { return std::make_unique<VortexKind>(motion); }

void ring_keys(Keys& keys, Vortex& m) {
  keys("inner", "inner radius ri of the ring", m.inner, {.unit = "m", .range = positive});
  keys("outer", "outer radius ro of the ring", m.outer, {.unit = "m", .range = positive});
  period_key(keys, m.amplitude.period);
  profile_power_key(keys, m.profile_power);
}

std::optional<MotionFault> fault_of_radii(const Annulus& ring, const MotionUse& use) {
  if (ring.inner < ring.outer) return std::nullopt;
  return MotionFault{"motion.inner", "must be less than motion.outer, found " + use.text(ring.inner, "m") + " and " +
                                         use.text(ring.outer, "m")};
}

void register_vortex(MotionRegistry& registry) {
  registry.motion(Vortex{}, 1);
  registry.path<Vortex>("vortex");
}

}  // namespace assay
