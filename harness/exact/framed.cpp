// SPDX-License-Identifier: BSD-3-Clause
// Any exact solution as a frame sees it.
#include <algorithm>
#include <cmath>

#include "harness/exact/places.hpp"

namespace assay {

namespace {

/// a + 2 w x v + w x (w x x).
Point apparent(const Point& a, const Point& v, const Point& x, double spin) {
  const double twice = 2 * spin, square = spin * spin;
  return {a[0] - twice * v[1] - square * x[0], a[1] + twice * v[0] - square * x[1]};
}

/// R(angle + spin t).
Plane rotation_of(const Frame& frame, double t) {
  const double angle = frame.angle + frame.spin * t;
  return rotation(std::cos(angle), std::sin(angle));
}

ExactPoint seen_from(const Frame& frame, const ExactPoint& own, double t) {
  return {frame.seen(own.state, t), frame.seen(own.stress, own.state, t)};
}

class FramedInstant final : public ExactInstant {
 public:
  FramedInstant(const Frame& frame, std::unique_ptr<ExactInstant> own, const ExactPoints& points)
      : ExactInstant(points.X, points.Y), frame_(frame), own_(std::move(own)), first_(rotation_of(frame, 0)) {}

  void set_time(double t) override {
    t_ = t;
    now_ = rotation_of(frame_, t);
    own_->set_time(t);
  }

  PlaneState state(std::size_t p) const override {
    const PlaneState own = own_->state(p);
    const PlaneMean seen = moved({own.x, own.v});
    PlaneState s{seen.x, seen.v, turned(own.F), own.sigma};
    const Plane sigma = product(product(now_, {s.sigma[0], s.sigma[1], s.sigma[2], s.sigma[3]}), transposed(now_));
    std::copy(sigma.begin(), sigma.end(), s.sigma.begin());
    return s;
  }
  Point velocity(std::size_t p) const override { return state(p).v; }
  Plane F_rate(std::size_t p) const override {
    const Plane F = own_->state(p).F, rate = own_->F_rate(p);
    const Point first = carried({rate[0], rate[2]}, {F[0], F[2]}), second = carried({rate[1], rate[3]}, {F[1], F[3]});
    return turned({first[0], second[0], first[1], second[1]});
  }
  Plane first_piola_kirchhoff(std::size_t p) const override { return turned(own_->first_piola_kirchhoff(p)); }

  PlaneInertia inertia(std::size_t p) const override {
    const PlaneInertia own = own_->inertia(p);
    const PlaneState s = own_->state(p);
    const Plane rate = own_->F_rate(p), &G = own.gradient;
    Plane gradient;  // column by column, each as a itself
    for (std::size_t j = 0; j < 2; ++j) {
      const Point column = apparent({G[j], G[2 + j]}, {rate[j], rate[2 + j]}, {s.F[j], s.F[2 + j]}, frame_.spin);
      gradient[j] = column[0], gradient[2 + j] = column[1];
    }
    return {times(now_, apparent(own.a, s.v, s.x, frame_.spin)), turned(gradient)};
  }

  void body_force(std::span<double> b_x, std::span<double> b_y, const InPieces& pieces) override {
    own_->body_force(b_x, b_y, pieces);
    see_body_force(frame_, *own_, t_, b_x, b_y);
  }

  PlaneMean mean(std::size_t p) const override { return moved(own_->mean(p)); }
  Point displacement(std::size_t p) const override { return own_->displacement(p); }
  bool moves(std::size_t p) const override { return own_->moves(p); }
  double measure(std::size_t p, const Plane& F) const override {
    return own_->measure(p, product(product(transposed(now_), F), first_));
  }

 private:
  Point carried(const Point& v, const Point& x) const { return {v[0] - frame_.spin * x[1], v[1] + frame_.spin * x[0]}; }
  /// x' = R x + c t, v' = R (v + w x x) + c.
  PlaneMean moved(const PlaneMean& own) const {
    PlaneMean seen{times(now_, own.x), times(now_, carried(own.v, own.x))};
    for (std::size_t d = 0; d < 2; ++d) {
      const double c = frame_.velocity[static_cast<int>(d)];
      seen.x[d] += c * t_, seen.v[d] += c;
    }
    return seen;
  }
  /// R(t) A R(0)^T.
  Plane turned(const Plane& A) const { return product(product(now_, A), transposed(first_)); }

  Frame frame_;
  std::unique_ptr<ExactInstant> own_;
  double t_ = 0;
  Plane first_, now_{1, 0, 0, 1};  ///< R(0), R(t)
};

class FramedSlice final : public ExactSlice {
 public:
  FramedSlice(const Frame& frame, std::unique_ptr<const ExactSlice> own, double t)
      : frame_(frame), own_(std::move(own)), t_(t) {}
  ExactPoint at(const Vector3& X) const override {
    ExactPoint own = own_->at(frame_.body_point(X));
    const Tensor sigma = own.stress.cauchy;  // of which places have six components
    own.stress.cauchy = sigma.selfadjointView<Eigen::Upper>();
    return seen_from(frame_, own, t_);
  }
  ExactState state(const Vector3& X) const override { return frame_.seen(own_->state(frame_.body_point(X)), t_); }
  /// Column by column of d a / d X as a itself.
  Tensor acceleration_gradient(const Vector3& X) const override {
    const Vector3 own = frame_.body_point(X);
    const ExactState s = own_->state(own);
    Tensor gradient = own_->acceleration_gradient(own);
    for (int j = 0; j < 3; ++j) {
      ExactState column;
      column.x = s.F.col(j), column.v = s.F_rate.col(j);
      gradient.col(j) += frame_.coriolis_and_centrifugal(column);
    }
    return frame_.rotation(t_) * gradient * frame_.rotation(0).transpose();
  }
  bool moves(const Vector3& X) const override { return own_->moves(frame_.body_point(X)); }
  Vector3 displacement(const Vector3& X) const override { return own_->displacement(frame_.body_point(X)); }
  double measure(const Vector3& X, const Tensor& F) const override {
    return own_->measure(frame_.body_point(X), frame_.rotation(t_).transpose() * F * frame_.rotation(0));
  }
  bool has_parts(Smooth of) const override { return own_->has_parts(of); }
  std::size_t part(const Vector3& X, Smooth of) const override { return own_->part(frame_.body_point(X), of); }

  const Frame& frame() const { return frame_; }
  const ExactSlice& own() const { return *own_; }
  double t() const { return t_; }

 private:
  Frame frame_;
  std::unique_ptr<const ExactSlice> own_;
  double t_;
};

class FramedPlaces final : public ExactPlaces {
 public:
  FramedPlaces(std::vector<Vector3> X, std::unique_ptr<const ExactPlaces> own)
      : ExactPlaces(std::move(X)), own_(std::move(own)) {}

  void evaluate(const ExactSlice& slice, std::size_t first, std::size_t count, const FieldViews& out) const override {
    const auto& now = static_cast<const FramedSlice&>(slice);
    constexpr std::size_t at_once = 256;
    std::vector<PointFields> fields(std::min(count, at_once));
    FieldViews asked = PointFields::views(fields.data());
    if (!out.F) asked.F = {};
    if (!out.P) asked.P = {};
    if (!out.sigma) asked.sigma = {};
    if (!out.a) asked.a = {};
    if (!out.b) asked.b = {};
    if (!out.static_force) asked.static_force = {};
    if (!out.x && !out.v && !out.a && !out.b) asked.x = asked.v = {};
    for (std::size_t begin = 0; begin < count; begin += at_once) {
      const std::size_t some = std::min(at_once, count - begin);
      own_->evaluate(now.own(), first + begin, some, asked);
      for (std::size_t p = 0; p < some; ++p) out.put(begin + p, seen_from(now.frame(), fields[p].point(), now.t()));
    }
  }
  bool moves(const ExactSlice& now, std::size_t point) const override {
    return own_->moves(static_cast<const FramedSlice&>(now).own(), point);
  }
  Vector3 displacement(const ExactSlice& now, std::size_t point) const override {
    return own_->displacement(static_cast<const FramedSlice&>(now).own(), point);
  }

 private:
  std::unique_ptr<const ExactPlaces> own_;
};

class FramedSolution final : public ExactSolution {
 public:
  FramedSolution(const Frame& frame, ExactSolutionPtr own)
      : ExactSolution(own->motion(), 0), frame_(frame), own_(std::move(own)) {}

  void evaluate(std::span<const PlaceAndTime> points, const FieldViews& out, const Between& between) const override {
    std::vector<PlaceAndTime> of_body(points.begin(), points.end());
    for (PlaceAndTime& point : of_body) point.X = frame_.body_point(point.X);
    std::vector<PointFields> fields(points.size());
    own_->evaluate(of_body, PointFields::views(fields.data()), between);
    for (std::size_t i = 0; i < points.size(); ++i) out.put(i, seen_from(frame_, fields[i].point(), points[i].t));
  }

  std::unique_ptr<const ExactSlice> slice(double t) const override {
    return std::make_unique<FramedSlice>(frame_, own_->slice(t), t);
  }
  std::unique_ptr<const ExactPlaces> places(std::vector<Vector3> X) const override {
    std::vector<Vector3> of_body;
    for (const Vector3& at : X) of_body.push_back(frame_.body_point(at));
    return std::make_unique<FramedPlaces>(std::move(X), own_->places(std::move(of_body)));
  }
  ExactState state(const Vector3& X, double t) const override {
    return frame_.seen(own_->state(frame_.body_point(X), t), t);
  }
  std::optional<Vector3> reference_of(const Vector3& x, double t) const override {
    const auto own = own_->reference_of(frame_.body_position(x, t), t);
    return own ? std::optional<Vector3>(frame_.rotation(0) * *own) : std::nullopt;
  }

  std::unique_ptr<ExactInstant> instant(const ExactPoints& points, const Asked& asked) const override {
    Frame frame = frame_;
    Asked of_own = asked;
    of_own.motion = true;
    if (own_->is_axisymmetric()) {  // turned by an angle it is itself
      frame.angle = 0;
      if (!frame.moves()) return own_->instant(points, asked);
      return std::make_unique<FramedInstant>(frame, own_->instant(points, of_own), points);
    }
    std::vector<double> X, Y;
    for (std::size_t p = 0; p < points.X.size(); ++p) {
      const Point of_body = times(transposed(rotation_of(frame, 0)), {points.X[p], points.Y[p]});
      X.push_back(of_body[0]), Y.push_back(of_body[1]);
    }
    return std::make_unique<FramedInstant>(frame, own_->instant({X, Y, points.half, points.domains}, of_own), points);
  }

  bool is_axisymmetric() const override { return own_->is_axisymmetric(); }
  const Response* response() const override { return own_->response(); }
  std::optional<StressSource> source() const override { return own_->source(); }

 private:
  Frame frame_;
  ExactSolutionPtr own_;
};

}  // namespace

ExactSolutionPtr seen_from(const Frame& frame, ExactSolutionPtr own) {
  return std::make_shared<const FramedSolution>(frame, std::move(own));
}

void see_body_force(const Frame& frame, const ExactInstant& own, double t, std::span<double> b_x,
                    std::span<double> b_y) {
  const Plane R = rotation_of(frame, t);
  for (std::size_t p = 0; p < b_x.size(); ++p) {
    const PlaneMean mean = own.mean(p);
    const Point b = times(R, apparent({b_x[p], b_y[p]}, mean.v, mean.x, frame.spin));
    b_x[p] = b[0], b_y[p] = b[1];
  }
}

}  // namespace assay
