// SPDX-License-Identifier: BSD-3-Clause
// The exact solution of the motions in the unit box.
#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <stdexcept>

#include "harness/exact/box_stress.hpp"
#include "harness/history/point_driver.hpp"

namespace assay {

namespace {

constexpr double difference_step = 2e-3;     ///< of the cosines: the fourth power of it is rounding
constexpr double history_tolerance = 1e-13;  ///< of a step
constexpr std::array<double, 5> difference_places{-2, -1, 0, 1, 2};

/// tau of one history at all times [Pa].
std::vector<Tensor> history_of(const Material& material, const Path& path, double xi, std::span<const double> times) {
  const Histories found = integrate_histories(material, path, std::array{xi}, times, {.tolerance = history_tolerance});
  std::vector<Tensor> tau(times.size());
  for (std::size_t k = 0; k < times.size(); ++k) tau[k] = tensor_of(found.tau[k].data());
  return tau;
}

/// Of f at -2, -1, 1 and 2 steps.
Tensor difference(const std::array<Tensor, 5>& f) {
  return (f[0] - 8 * f[1] + 8 * f[3] - f[4]) / (12 * difference_step);
}

/// Stress and b = a - DIV(P)/rho0 at one point at ascending times > 0. The gradient of P is taken by differences of
/// fourth order between the histories of neighbouring cos(pi X_i): some 10 digits, fewer where a front runs between
/// them.
std::vector<ExactStress> stress_of_point(const Material& material, const AxisAligned& motion, double density,
                                         const Vector3& X, std::span<const double> times,
                                         const std::array<double, 3>& material_direction) {
  using std::numbers::pi;
  const Vector3 factor = motion.s(), cosine = (pi * X).array().cos();
  const auto tau_at = [&](const Vector3& of) {
    Path path = motion.section(of.y(), of.z());
    path.material_direction = material_direction;
    path.parameter.lower = std::min(path.parameter.lower, of.x()), path.parameter.upper = std::max(1.0, of.x());
    return history_of(material, path, of.x(), times);
  };
  const std::vector<Tensor> tau = tau_at(cosine);
  std::vector<ExactStress> stress(times.size());
  for (std::size_t k = 0; k < times.size(); ++k) {
    const ExactState state = motion.at(X, times[k]);
    stress[k] = {tau[k], cauchy_stress(tau[k], state.F), state.a};
  }
  for (int d = 0; d < 3; ++d) {
    const double slope = -pi * std::sin(pi * X(d));  // of the cosine [1/m]
    if (factor(d) == 0 || std::abs(slope) < 1e-12) continue;
    std::array<std::vector<Tensor>, 5> near;
    for (std::size_t i = 0; i < difference_places.size(); ++i) {
      const Vector3 at = cosine + difference_places[i] * difference_step * Vector3::Unit(d);
      if (difference_places[i] != 0) near[i] = tau_at(at);
    }
    for (std::size_t k = 0; k < times.size(); ++k) {
      const Tensor dtau = slope * difference({near[0][k], near[1][k], tau[k], near[3][k], near[4][k]});
      stress[k].static_force -= dtau.col(d) / density;  // (DIV P)_i = d P_iJ / d X_J
      stress[k].body_force -= dtau.col(d) / density;
    }
  }
  return stress;
}

/// The series at any time, for any thread.
class BoxSeriesInTime {
 public:
  BoxSeriesInTime(std::shared_ptr<const Material> material, const AxisAligned& motion, const BoxOptions& options)
      : stress_(std::move(material), motion, options) {}

  std::shared_ptr<const BoxSeries> at(double t) {
    const std::lock_guard lock(mutex_);
    if (last_ && t == t_) return last_;
    if (stress_.is_history() && t < t_) stress_.begin_again();
    stress_.set_time(t);
    t_ = t;
    return last_ = std::make_shared<const BoxSeries>(stress_.series());
  }

  int modes(std::size_t d) const { return stress_.series().modes(d); }

  StressSource source() {
    const std::lock_guard lock(mutex_);
    const int along_X = modes(0), along_Y = modes(1);
    return {along_X * along_Y, stress_.error(),
            "a cosine series of " + std::to_string(along_X) + " x " + std::to_string(along_Y) + " modes",
            stress_.is_history() ? "a history" : "an update", stress_.material_calls()};
  }

 private:
  std::mutex mutex_;
  BoxStress stress_;
  double t_ = 0;
  std::shared_ptr<const BoxSeries> last_;
};

std::vector<Interval> sides_of(std::span<const double> X, double half) {
  std::vector<Interval> sides;
  for (const double x : X) sides.push_back({x - half, x + half});
  return sides;
}

/// Of a cosine series b is exact at points and on the mean over rectangles.
class BoxInstant final : public ExactInstant {
 public:
  BoxInstant(const AxisAligned& motion, double density, std::shared_ptr<BoxSeriesInTime> stress,
             const ExactPoints& points, const Asked& asked)
      : ExactInstant(points.X, points.Y),
        motion_(motion),
        density_(density),
        stress_(std::move(stress)),
        asked_(asked),
        points_{CosineRows(stress_->modes(0), sides_of(points.X, 0)),
                CosineRows(stress_->modes(1), sides_of(points.Y, 0))},
        sides_{CosineRows(stress_->modes(0), sides_of(points.X, points.half[0])),
               CosineRows(stress_->modes(1), sides_of(points.Y, points.half[1]))} {}

  void set_time(double t) override {
    t_ = t;
    if (!asked_.stress) return;
    const auto series = stress_->at(t);
    const auto modes = static_cast<std::size_t>(series->modes(1));
    for (std::size_t c = 0; c < P_.size(); ++c) {
      P_[c].resize(points_[0].rows() * modes);
      for (std::size_t row = 0; row < points_[0].rows(); ++row) {
        series->contract(c, 0, points_[0].mean(row), std::span(P_[c]).subspan(row * modes, modes));
      }
    }
  }

  PlaneState state(std::size_t p) const override {
    const ExactState now = motion_.at(X(p), t_);
    const double F11 = now.F(0, 0), F22 = now.F(1, 1);
    PlaneState s{in_plane(now.x), in_plane(now.v), {F11, 0, 0, F22}};
    if (asked_.stress) s.sigma = {piola(0, p) / F22, 0, 0, piola(1, p) / F11, piola(2, p) / (F11 * F22)};  // P F^T / J
    return s;
  }
  Point velocity(std::size_t p) const override { return in_plane(motion_.at(X(p), t_).v); }
  Plane F_rate(std::size_t p) const override { return in_plane(motion_.at(X(p), t_).F_rate); }
  Plane first_piola_kirchhoff(std::size_t p) const override { return {piola(0, p), 0, 0, piola(1, p)}; }

  PlaneInertia inertia(std::size_t p) const override {
    return {in_plane(motion_.at(X(p), t_).a), in_plane(motion_.acceleration_gradient(X(p), t_))};
  }

  void body_force(std::span<double> b_x, std::span<double> b_y, const InPieces&) override {
    const auto series = stress_->at(t_);
    const Vector3 inertia = motion_.amplitude.at(t_).acceleration * motion_.s();  // where sin(pi X_i) = 1 [m/s^2]
    const std::array<std::span<double>, 2> b{b_x, b_y};
    for (std::size_t d = 0; d < 2; ++d) {
      const auto modes = static_cast<std::size_t>(series->modes(1 - d));
      slopes_.resize(sides_[d].rows() * modes);
      const auto slope = [&](std::size_t row) { return std::span(slopes_).subspan(row * modes, modes); };
      for (std::size_t row = 0; row < sides_[d].rows(); ++row) series->contract(d, d, sides_[d].slope(row), slope(row));
      for (std::size_t p = 0; p < b[d].size(); ++p) {
        const std::uint32_t row = sides_[d].row_of(p), across = sides_[1 - d].row_of(p);
        const double divergence = sum_of_modes(sides_[1 - d].mean(across), slope(row));  // d P_dd / d X_d
        b[d][p] = inertia(static_cast<int>(d)) * sides_[d].mean_sine(row) - divergence / density_;
      }
    }
  }

  PlaneMean mean(std::size_t p) const override {
    const AmplitudeValue g = motion_.amplitude.at(t_);
    const Vector3 s = motion_.s();
    const Point sine{s.x() * sides_[0].mean_sine(sides_[0].row_of(p)),
                     s.y() * sides_[1].mean_sine(sides_[1].row_of(p))};
    return {{X_[p] + g.value * sine[0], Y_[p] + g.value * sine[1]}, {g.rate * sine[0], g.rate * sine[1]}};
  }

 private:
  Vector3 X(std::size_t p) const { return {X_[p], Y_[p], 0}; }
  double piola(std::size_t component, std::size_t p) const {
    const std::span<const double> mode = points_[1].mean(points_[1].row_of(p));
    return sum_of_modes(mode, std::span(P_[component]).subspan(points_[0].row_of(p) * mode.size(), mode.size()));
  }

  AxisAligned motion_;
  double density_;
  std::shared_ptr<BoxSeriesInTime> stress_;
  Asked asked_;
  double t_ = 0;
  std::array<CosineRows, 2> points_, sides_;                  ///< along X and Y, of points and of their rectangles
  std::array<std::vector<double>, BoxSeries::components> P_;  ///< of each mode in Y, at each distinct X [Pa]
  std::vector<double> slopes_;  ///< of d P_dd / d X_d at each row, for each mode of the other axis [Pa/m]
};

class BoxSolution final : public ExactSolution {
 public:
  BoxSolution(const AxisAligned& motion, double density, std::shared_ptr<const Material> material,
              const BoxOptions& options)
      : ExactSolution(motion, density), box_(motion), material_(std::move(material)), options_(options) {}

  /// The stress of points at rest is that of t = 0, where nothing is deformed.
  std::vector<ExactPoint> at(std::span<const PlaceAndTime> points, const Between& between) const override {
    std::vector<ExactPoint> found(points.size());
    std::map<std::array<double, 3>, std::map<double, std::vector<std::size_t>>> by_place;  // then by time
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto& [X, t] = points[i];
      found[i].state = box_.at(X, t);
      if (t > 0) by_place[{X.x(), X.y(), X.z()}][t].push_back(i);
    }
    double places = 0;
    for (const auto& [place, by_time] : by_place) {
      if (between) between(places++ / static_cast<double>(by_place.size()), "histories");
      std::vector<double> times;
      for (const auto& [t, which] : by_time) times.push_back(t);
      const auto stress =
          stress_of_point(*material_, box_, density_, {place[0], place[1], place[2]}, times, options_.direction);
      std::size_t k = 0;
      for (const auto& [t, which] : by_time) {
        for (const std::size_t i : which) found[i].stress = stress[k];
        ++k;
      }
    }
    return found;
  }

  std::unique_ptr<ExactInstant> instant(const ExactPoints& points, const Asked& asked) const override {
    return std::make_unique<BoxInstant>(box_, density_, series(), points, asked);
  }
  std::optional<StressSource> source() const override { return series()->source(); }

 private:
  std::shared_ptr<BoxSeriesInTime> series() const {
    if (box_.s().z() != 0) throw std::logic_error("the series of the box is plane");
    std::call_once(once_, [this] { series_ = std::make_shared<BoxSeriesInTime>(material_, box_, options_); });
    return series_;
  }

  AxisAligned box_;
  std::shared_ptr<const Material> material_;
  BoxOptions options_;
  mutable std::once_flag once_;
  mutable std::shared_ptr<BoxSeriesInTime> series_;
};

}  // namespace

ExactSolutionPtr exact_box(const AxisAligned& motion, double density, std::shared_ptr<const Material> material,
                           const BoxOptions& options) {
  return std::make_shared<const BoxSolution>(motion, density, std::move(material), options);
}

}  // namespace assay
