// SPDX-License-Identifier: BSD-3-Clause
// The exact solution of the motions in the unit box.
#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <stdexcept>

#include "harness/exact/box_points.hpp"
#include "harness/exact/box_stress.hpp"

namespace assay {

namespace {

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
      : ExactSolution(motion, density), model_{motion, density, std::move(material), options} {}

  /// Where histories stand behind the stress, all times of a place one after another.
  void evaluate(std::span<const PlaceAndTime> points, const FieldViews& out, const Between& between) const override {
    if (model_.material->is_function_of_F()) return ExactSolution::evaluate(points, out, between);
    std::map<std::array<double, 3>, std::multimap<double, std::size_t>> by_place;  // then by time
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto& [X, t] = points[i];
      by_place[{X.x(), X.y(), X.z()}].emplace(t, i);
    }
    double done = 0;
    for (const auto& [place, by_time] : by_place) {
      if (between) between(done++ / static_cast<double>(by_place.size()), "histories");
      const auto here = places({{place[0], place[1], place[2]}});
      for (const auto& [t, i] : by_time) here->evaluate(*slice(t), 0, 1, out.from(i));
    }
  }

  std::unique_ptr<const ExactSlice> slice(double t) const override { return slice_of_box(model_, t); }
  std::unique_ptr<const ExactPlaces> places(std::vector<Vector3> X) const override {
    return places_of_box(model_, std::move(X));
  }
  std::unique_ptr<ExactInstant> instant(const ExactPoints& points, const Asked& asked) const override {
    return std::make_unique<BoxInstant>(model_.motion, density_, series(), points, asked);
  }
  std::optional<StressSource> source() const override {
    if (model_.motion.in_space) return std::nullopt;  // the series is plane
    return series()->source();
  }

 private:
  std::shared_ptr<BoxSeriesInTime> series() const {
    if (model_.motion.s().z() != 0) throw std::logic_error("the series of the box is plane");
    std::call_once(
        once_, [this] { series_ = std::make_shared<BoxSeriesInTime>(model_.material, model_.motion, model_.options); });
    return series_;
  }

  BoxModel model_;
  mutable std::once_flag once_;
  mutable std::shared_ptr<BoxSeriesInTime> series_;
};

}  // namespace

ExactSolutionPtr exact_box(const AxisAligned& motion, double density, std::shared_ptr<const Material> material,
                           const BoxOptions& options) {
  return std::make_shared<const BoxSolution>(motion, density, std::move(material), options);
}

}  // namespace assay
