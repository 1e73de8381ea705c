// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/kinds/axis_aligned.hpp"

#include <cmath>
#include <numbers>

#include "harness/motion/registry.hpp"
#include "harness/numeric/number_text.hpp"
#include "harness/numeric/rising_root.hpp"

namespace assay {

namespace {

using std::numbers::pi;

/// g = pi A sin(c pi t), (d u_i / d X_i) / s_i where cos(pi X_i) = 1 [1].
AmplitudeValue strain(const Amplitude& amplitude, double t) {
  AmplitudeValue g = amplitude.at(t);
  g.value *= pi, g.rate *= pi, g.acceleration *= pi;
  return g;
}

struct Section {
  AxisAligned motion;
  double cosine_of_Y = 1, cosine_of_Z = 1;
  Path baseline() const { return motion.section(cosine_of_Y, cosine_of_Z); }
};

void fields(auto& archive, Section& s) { archive(s.motion, s.cosine_of_Y, s.cosine_of_Z); }

}  // namespace

Vector3 AxisAligned::s() const {
  if (one_dimensional) return Vector3::UnitX();
  return factors.value_or(Vector3(1, -1, in_space ? 0.5 : 0));
}

ExactState AxisAligned::at(const Vector3& X, double t) const {
  const AmplitudeValue g = strain(amplitude, t);
  ExactState state;
  state.x = X;
  const Vector3 factor = s();
  for (int d = 0; d < 3; ++d) {
    if (factor(d) == 0) continue;
    const double sine = factor(d) * std::sin(pi * X(d)) / pi, cosine = factor(d) * std::cos(pi * X(d));
    state.x(d) += g.value * sine;
    state.v(d) = g.rate * sine;
    state.a(d) = g.acceleration * sine;
    state.F(d, d) += g.value * cosine;
    state.F_rate(d, d) = g.rate * cosine;
  }
  return state;
}

Vector3 AxisAligned::reference_of(const Vector3& x, double t) const {
  const Vector3 slope = strain(amplitude, t).value * s();
  Vector3 X = x;
  for (int d = 0; d < 3; ++d) {
    const double farthest = std::abs(slope(d)) / pi;
    X(d) = rising_root(x(d) - farthest, x(d) + farthest, x(d), [&](double at) {
      return std::pair{at - x(d) + slope(d) * std::sin(pi * at) / pi, 1 + slope(d) * std::cos(pi * at)};
    });
  }
  return X;
}

Tensor AxisAligned::acceleration_gradient(const Vector3& X, double t) const {
  const double g = strain(amplitude, t).acceleration;
  Tensor gradient = Tensor::Zero();
  const Vector3 factor = s();
  for (int d = 0; d < 3; ++d) {
    if (factor(d) != 0) gradient(d, d) = factor(d) * g * std::cos(pi * X(d));
  }
  return gradient;
}

Path AxisAligned::section(double cosine_of_Y, double cosine_of_Z) const {
  Path path;
  path.parameter = {-1, 1};
  path.reversals = [g = amplitude](double end) { return g.reversals(end); };
  path.recipe = recipe("axis_aligned", Section{*this, cosine_of_Y, cosine_of_Z});
  if (!one_dimensional) {
    path.name = "axis_aligned";
    path.parameter_is_place = true;
    path.curved = [g = amplitude, s = s(), cosine_of_Y, cosine_of_Z](double xi, double t) {
      const AmplitudeValue now = strain(g, t);
      const Vector3 shape = s.cwiseProduct(Vector3(xi, cosine_of_Y, cosine_of_Z));
      PathPoint point;
      point.F.diagonal() += now.value * shape;
      point.F_rate.diagonal() = now.rate * shape;
      return point;
    };
    return path;
  }
  path.name = "uniaxial_strain";
  path.direction(0, 0) = 1;
  path.amplitude = [g = amplitude](double t) { return strain(g, t).value; };
  path.amplitude_rate = [g = amplitude](double t) { return strain(g, t).rate; };
  path.amplitude_range = [g = amplitude](double end) {
    const auto [lower, upper] = g.range(end);
    return Interval{pi * lower, pi * upper};
  };
  return path;
}

namespace {

constexpr double usual_peak = 0.1;  ///< A unless the scene says otherwise [m]

class AxisAlignedKind final : public MotionOf<AxisAlignedKind, AxisAligned> {
 public:
  using MotionOf::MotionOf;
  std::string_view type() const override { return m.one_dimensional ? "bar_1d" : "axis_aligned"; }
  double period() const override { return m.amplitude.period; }
  bool is_homogeneous() const override { return false; }
  std::optional<Vector3> reference_of(const Vector3& x, double t) const override { return m.reference_of(x, t); }
  double length() const override { return 0.5; }  // from a symmetry plane to where cos(pi X) = 0
  const Amplitude* amplitude() const override { return &m.amplitude; }
  bool is_plane() const override { return m.s().z() == 0; }
  std::array<double, 3> usual_lower() const override { return {0, 0, 0}; }
  std::array<double, 3> usual_upper() const override { return {1, 1, 1}; }
  bool is_symmetry_plane(std::size_t d, double at) const override { return is_whole(at) || stands_still(d); }
  bool may_repeat() const override { return true; }
  std::string fault_of_period(std::size_t d, double width) const override {
    if (stands_still(d) || is_whole(width / 2)) return {};
    return "the motion repeats after 2 m, and the body is " + rounded_text(width, 6) + " m wide";
  }

  void keys(Keys& keys) override {
    m.amplitude.keys(keys, "m");
    std::optional<double> speed = m.given_speed ? std::optional(m.wave_speed()) : std::nullopt;
    if (keys("wave_speed", "c, which sets T = 1/c; auto: c = sqrt(E/rho0) with the material's parameter E", speed,
             {.unit = "m/s",
              .range = {.lower = AxisAligned::least_wave_speed, .upper = AxisAligned::most_wave_speed},
              .automatic = true}) &&
        speed)
      m.amplitude.period = 1 / *speed;
    m.given_speed = speed.has_value();
    if (m.one_dimensional) return;
    Vector3 s = m.s();
    const bool is_told = m.in_space || s != AxisAligned{}.s();
    if (keys("factors", "s of u_i = A s_i sin(pi X_i) sin(c pi t); in the plane the third is 0", s,
             {.unit = "1", .derived = "[1, -1, 0]; with dimension: 3 [1, -1, 0.5]", .shown = is_told}))
      m.factors = s;
  }
  void set_dimension(int dimension) override { m.in_space = dimension == 3; }
  std::optional<MotionFault> fault(const MotionUse& use) const override {
    if (m.amplitude.type != Amplitude::Type::sine)
      return MotionFault{"motion.amplitude.type", "must be sine for this motion, whose period T is 1/c"};
    if (use.dimension == 2 && m.s().z() != 0)
      return MotionFault{"motion.factors", "the third must be 0 in the plane, found " + number_text(m.s().z()) +
                                               ": with dimension: 3 it may be any number"};
    const double largest = m.s().cwiseAbs().maxCoeff();
    const std::string peak = use.text(m.amplitude.peak, "m"), bound = use.in_units ? "1/pi m" : "1/pi";
    if (std::abs(m.amplitude.peak) * largest < 1 / pi) return std::nullopt;
    if (largest > 1 && use.gives && use.gives("motion.factors"))
      return MotionFault{"motion.factors", "the largest in size, " + number_text(largest) +
                                               ", times motion.amplitude.peak, " + peak + ", must be less than " +
                                               bound + " in size, for det F > 0"};
    const std::string times = largest == 1 ? "" : "times the largest of motion.factors, " + number_text(largest) + ", ";
    return MotionFault{"motion.amplitude.peak",
                       times + "must be less than " + bound + " in size, for det F > 0, found " + peak};
  }

 private:
  bool stands_still(std::size_t d) const { return m.s()(static_cast<int>(d)) == 0; }
  static bool is_whole(double x) {
    constexpr double whole_multiples = 1e-9;  // a number this close to a whole one is that one
    return std::abs(x - std::round(x)) <= whole_multiples;
  }
};

}  // namespace

std::unique_ptr<MotionKind> kind_of(const AxisAligned& motion) { return std::make_unique<AxisAlignedKind>(motion); }

void register_axis_aligned(MotionRegistry& registry) {
  const Amplitude amplitude{Amplitude::Type::sine, usual_peak, 1};
  registry.motion(AxisAligned{amplitude, false, false}, 4);
  registry.motion(AxisAligned{amplitude, true, false}, 5);
  registry.path<Section>("axis_aligned");
}

}  // namespace assay
