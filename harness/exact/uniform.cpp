// SPDX-License-Identifier: BSD-3-Clause
// The exact solution of a motion whose F is the same everywhere: P depends on time alone, and b = a.
#include <map>
#include <mutex>

#include "harness/exact/exact_fields.hpp"
#include "harness/history/timed_history.hpp"
#include "harness/history/troop.hpp"
#include "harness/material/checked_update.hpp"

namespace assay {

namespace {

/// P of a material along a path, at any time: of a stress that is a function of F by one update, to rounding; else by
/// a history with error control, which a run takes along as time goes on. For slices it is a function of t alone.
class UniformStress {
 public:
  UniformStress(std::shared_ptr<const Material> material, const Path& path, double own, double period, double end,
                double tolerance)
      : material_(std::move(material)), path_(path), own_(own), panel_(period / panels_a_period) {
    if (material_->is_function_of_F()) {
      state_ = state_at_rest(*material_, path_);
    } else {
      course_.emplace(*material_, path_, end);
      options_ = {.tolerance = tolerance, .watch = material_->has(ASSAY_NON_SMOOTH)};
      begin();
    }
  }

  Tensor at(double t) {
    const std::lock_guard lock(mutex_);
    if (t == t_) return P_;
    P_ = history_ ? by_history(t) : by_update(t);
    t_ = t;
    return P_;
  }

  /// Whatever was asked before.
  Tensor of_time(double t) {
    const std::lock_guard lock(mutex_);
    if (!course_) return by_update(t);
    if (!timed_) timed_.emplace(*course_, own_, options_, panel_, true);
    return timed_->tau(t);
  }

  std::optional<StressSource> source() const {
    const std::lock_guard lock(mutex_);
    if (!history_) return std::nullopt;
    return StressSource{1, history_->error(), "one history", "", earlier_calls_ + history_->calls()};
  }

 private:
  void begin() {
    if (history_) earlier_calls_ += history_->calls();
    history_.emplace(*course_, std::vector{own_}, options_);
  }

  Tensor by_history(double t) {
    if (t < t_) begin();
    history_->advance(t);
    return history_->tau(0);
  }

  Tensor by_update(double t) const {
    const Tensor F = path_.deformation_gradient(own_, t), I = Tensor::Identity();
    return first_piola_kirchhoff(stepped(*material_, 0, t > 0 ? t : 1, I, F, state_, own_).cauchy, F);
  }

  static constexpr double panels_a_period = 64;

  std::shared_ptr<const Material> material_;
  Path path_;
  double own_;    ///< parameter of the path
  double panel_;  ///< [s]
  HistoryOptions options_;
  std::optional<Course> course_;
  std::optional<Troop> history_;  ///< of one
  std::optional<TimedHistory> timed_;
  std::vector<double> state_;  ///< at rest
  std::int64_t earlier_calls_ = 0;
  mutable std::mutex mutex_;
  double t_ = -1;  ///< of P_ [s]
  Tensor P_ = Tensor::Zero();
};

class UniformInstant final : public ExactInstant {
 public:
  UniformInstant(const Motion& motion, std::function<Tensor(double)> P, const ExactPoints& points, const Asked& asked)
      : ExactInstant(points.X, points.Y), motion_(motion), P_of_(std::move(P)), asked_(asked) {}

  void set_time(double t) override {
    origin_ = motion_->at(Vector3::Zero(), t);
    a_.a = in_plane(origin_.a);
    for (std::size_t d = 0; d < 2; ++d) {
      const Vector3 along = motion_->at(Vector3::Unit(static_cast<int>(d)), t).a - origin_.a;
      a_.gradient[d] = along.x(), a_.gradient[2 + d] = along.y();
    }
    if (!asked_.stress || X_.empty()) return;
    const Tensor P = P_of_(t);
    P_ = in_plane(P);
    sigma_ = plane_stress(cauchy_stress(P, origin_.F));
  }

  PlaneState state(std::size_t p) const override {
    return {in_plane(Vector3(origin_.x + origin_.F * X(p))), velocity(p), in_plane(origin_.F), sigma_};
  }
  Point velocity(std::size_t p) const override { return in_plane(Vector3(origin_.v + origin_.F_rate * X(p))); }
  Plane F_rate(std::size_t) const override { return in_plane(origin_.F_rate); }
  Plane first_piola_kirchhoff(std::size_t) const override { return P_; }

  PlaneInertia inertia(std::size_t p) const override {
    PlaneInertia at = a_;
    for (std::size_t d = 0; d < 2; ++d) at.a[d] += at.gradient[2 * d] * X_[p] + at.gradient[2 * d + 1] * Y_[p];
    return at;
  }

  void body_force(std::span<double> b_x, std::span<double> b_y, const InPieces&) override {
    for (std::size_t p = 0; p < b_x.size(); ++p) {
      const Point b = inertia(p).a;
      b_x[p] = b[0], b_y[p] = b[1];
    }
  }

 private:
  Vector3 X(std::size_t p) const { return {X_[p], Y_[p], 0}; }

  Motion motion_;
  std::function<Tensor(double)> P_of_;
  Asked asked_;
  ExactState origin_;
  PlaneInertia a_;  ///< of the origin
  Plane P_{};
  std::array<double, 5> sigma_{};
};

class UniformSlice final : public ExactSlice {
 public:
  UniformSlice(const Motion& motion, const Tensor& P, double t) : motion_(motion), P_(P), t_(t) {}
  ExactPoint at(const Vector3& X) const override {
    const ExactState now = state(X);
    return {now, {P_, cauchy_stress(P_, now.F), now.a}};
  }
  ExactState state(const Vector3& X) const override { return motion_->at(X, t_); }
  /// a is linear in X.
  Tensor acceleration_gradient(const Vector3&) const override {
    const Vector3 origin = state(Vector3::Zero()).a;
    Tensor gradient;
    for (int d = 0; d < 3; ++d) gradient.col(d) = state(Vector3::Unit(d)).a - origin;
    return gradient;
  }

 private:
  Motion motion_;
  Tensor P_;
  double t_;
};

class UniformSolution final : public ExactSolution {
 public:
  using Source = std::function<std::optional<StressSource>()>;
  using PofTime = std::function<Tensor(double)>;
  /// P: for times that ascend; of_time: of t alone.
  UniformSolution(const Motion& motion, double density, PofTime P, PofTime of_time, Source source = {})
      : ExactSolution(motion, density), P_(std::move(P)), of_time_(std::move(of_time)), source_(std::move(source)) {}

  std::vector<ExactPoint> at(std::span<const PlaceAndTime> points, const Between& between) const override {
    std::vector<ExactPoint> found(points.size());
    std::multimap<double, std::size_t> by_time;
    for (std::size_t i = 0; i < points.size(); ++i) by_time.emplace(points[i].t, i);
    double done = 0;
    for (const auto& [t, i] : by_time) {
      if (between) between(done++ / static_cast<double>(points.size()), "points");
      const ExactState state = motion_->at(points[i].X, t);
      const Tensor P = P_(t);
      found[i] = {state, {P, cauchy_stress(P, state.F), state.a}};
    }
    return found;
  }

  std::unique_ptr<const ExactSlice> slice(double t) const override {
    return std::make_unique<UniformSlice>(motion_, of_time_(t), t);
  }
  std::unique_ptr<ExactInstant> instant(const ExactPoints& points, const Asked& asked) const override {
    return std::make_unique<UniformInstant>(motion_, P_, points, asked);
  }
  std::optional<StressSource> source() const override { return source_ ? source_() : std::nullopt; }

 private:
  PofTime P_, of_time_;
  Source source_;
};

}  // namespace

ExactSolutionPtr exact_uniform(const Motion& motion, double density, const std::function<Tensor(double)>& P) {
  return std::make_shared<const UniformSolution>(motion, density, P, P);
}

ExactSolutionPtr exact_uniform(const Motion& motion, double density, std::shared_ptr<const Material> material,
                               const Path& path, double end, double tolerance) {
  auto stress = std::make_shared<UniformStress>(std::move(material), path, motion->own_parameter(), motion->period(),
                                                end, tolerance);
  return std::make_shared<const UniformSolution>(
      motion, density, [stress](double t) { return stress->at(t); }, [stress](double t) { return stress->of_time(t); },
      [stress] { return stress->source(); });
}

}  // namespace assay
