// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/kinds/axis_aligned.hpp"

#include <cmath>
#include <numbers>

#include "harness/motion/registry.hpp"
#include "harness/numeric/number_text.hpp"

namespace assay {

namespace {

using std::numbers::pi;

/// g = pi A sin(c pi t), d u_x / d X where cos(pi X) = 1 [1].
AmplitudeValue strain(const Amplitude& amplitude, double t) {
  AmplitudeValue g = amplitude.at(t);
  g.value *= pi, g.rate *= pi, g.acceleration *= pi;
  return g;
}

struct Section {
  AxisAligned motion;
  double cosine_of_Y = 1;
  Path baseline() const { return motion.section(cosine_of_Y); }
};

void fields(auto& archive, Section& s) { archive(s.motion, s.cosine_of_Y); }

}  // namespace

ExactState AxisAligned::at(const Vector3& X, double t) const {
  const AmplitudeValue g = strain(amplitude, t);
  ExactState state;
  state.x = X;
  for (int d = 0; d < (one_dimensional ? 1 : 2); ++d) {
    const double sign = d == 0 ? 1 : -1, sine = sign * std::sin(pi * X(d)) / pi, cosine = sign * std::cos(pi * X(d));
    state.x(d) += g.value * sine;
    state.v(d) = g.rate * sine;
    state.a(d) = g.acceleration * sine;
    state.F(d, d) += g.value * cosine;
    state.F_rate(d, d) = g.rate * cosine;
  }
  return state;
}

Tensor AxisAligned::acceleration_gradient(const Vector3& X, double t) const {
  const double g = strain(amplitude, t).acceleration;
  Tensor gradient = Tensor::Zero();
  gradient(0, 0) = g * std::cos(pi * X.x());
  if (!one_dimensional) gradient(1, 1) = -g * std::cos(pi * X.y());
  return gradient;
}

Path AxisAligned::section(double s) const {
  Path path;
  path.parameter = {-1, 1};
  path.reversals = [g = amplitude](double end) { return g.reversals(end); };
  path.recipe = recipe("axis_aligned", Section{*this, s});
  if (!one_dimensional) {
    path.name = "axis_aligned";
    path.parameter_is_place = true;
    path.curved = [g = amplitude, s](double xi, double t) {
      const AmplitudeValue now = strain(g, t);
      PathPoint point;
      point.F.diagonal() += now.value * Vector3(xi, -s, 0);
      point.F_rate.diagonal() = now.rate * Vector3(xi, -s, 0);
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
  const Amplitude* amplitude() const override { return &m.amplitude; }
  std::array<double, 2> usual_lower() const override { return {0, 0}; }
  std::array<double, 2> usual_upper() const override { return {1, 1}; }
  bool is_symmetry_plane(std::size_t d, double at) const override {
    return is_whole(at) || (m.one_dimensional && d == 1);
  }
  bool may_repeat() const override { return true; }
  std::string fault_of_period(std::size_t d, double width) const override {
    if ((m.one_dimensional && d == 1) || is_whole(width / 2)) return {};
    return "the motion repeats after 2 m, and the body is " + rounded_text(width, 6) + " m wide";
  }

  void keys(Keys& keys) override {
    m.amplitude.keys(keys);
    std::optional<double> speed = m.given_speed ? std::optional(m.wave_speed()) : std::nullopt;
    if (keys("wave_speed", "c, which sets T = 1/c [m/s]; auto: c = sqrt(E/rho0) with the material's parameter E", speed,
             {.range = {.lower = AxisAligned::least_wave_speed, .upper = AxisAligned::most_wave_speed},
              .automatic = true}) &&
        speed)
      m.amplitude.period = 1 / *speed;
    m.given_speed = speed.has_value();
  }
  std::optional<MotionFault> fault(const MotionUse&) const override {
    if (m.amplitude.type != Amplitude::Type::sine)
      return MotionFault{"motion.amplitude.type", "must be sine for this motion, whose period T is 1/c"};
    if (std::abs(m.amplitude.peak) < 1 / pi) return std::nullopt;
    return MotionFault{"motion.amplitude.peak",
                       "must be less than 1/pi in size, for det F > 0, found " + number_text(m.amplitude.peak)};
  }

 private:
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
