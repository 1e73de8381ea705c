// SPDX-License-Identifier: BSD-3-Clause
#include "harness/perturbed/perturbed_motion.hpp"

#include <algorithm>
#include <cmath>

#include "harness/exact/places.hpp"

namespace assay {

namespace {

constexpr double courant = 0.35;       ///< waves are faster where a mistake stretches the body
constexpr int least_times = 160;       ///< of the table of forces: cubic in between
constexpr double least_volume = 0.05;  ///< J of an element that is given up
constexpr double largest_steps = 4e5;

/// Of the four times around a time, by Lagrange.
std::array<double, 4> cubic_shares(double s) {
  return {-s * (s - 1) * (s - 2) / 6, (s + 1) * (s - 1) * (s - 2) / 2, -(s + 1) * s * (s - 2) / 2,
          (s + 1) * s * (s - 1) / 6};
}

}  // namespace

/// Of the samples of the body over time; tractions' P too.
class PerturbedMotion::Table final : public ExactForce {
 public:
  Table(const PerturbedProblem& problem, const PerturbedBody& body) : body_(body), known_(problem.known) {
    const double period = problem.exact->motion()->period();
    times_ = std::max(least_times, static_cast<int>(std::min(1e4, least_times * problem.known / period)));
    step_ = problem.known / (times_ - 1);
    std::vector<Vector3> X = body.samples;
    for (const MeshPoint& face : body.surface) X.push_back(face.X);
    const auto places = problem.exact->places(X);
    std::vector<PointFields> now(X.size());
    FieldViews views = PointFields::views(now.data());
    views.v = views.F = views.sigma = views.b = {};
    for (int k = 0; k < times_; ++k) {
      const auto slice = problem.exact->slice(std::min(k * step_, known_));
      places->evaluate(*slice, 0, X.size(), views);
      for (std::size_t p = 0; p < body.samples.size(); ++p) {
        const PointFields& f = now[p];
        parts_.push_back({Eigen::Map<const Vector3>(f.x.data()), Eigen::Map<const Vector3>(f.a.data()),
                          Eigen::Map<const Vector3>(f.static_force.data())});
      }
      for (std::size_t s = 0; s < body.surface.size(); ++s)
        tractions_.push_back(tensor_of(now[body.samples.size() + s].P.data()) * body.surface[s].normal);
    }
  }

  ForceParts at(const Vector3& X, double t) const override {
    const auto around = body_.around(X);
    const auto [first, shares] = times_around(t);
    ForceParts sum;
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t n = 0; n < 4; ++n) {
        const double share = shares[k] * around.share[n];
        if (share == 0) continue;
        const ForceParts& one = parts_[(first + k) * body_.samples.size() + around.sample[n]];
        sum.x += share * one.x, sum.a += share * one.a, sum.static_force += share * one.static_force;
      }
    }
    if (around.turn != 0) {
      const Tensor turn = rotation_about_z(around.turn);
      sum.x = turn * sum.x, sum.a = turn * sum.a, sum.static_force = turn * sum.static_force;
    }
    return sum;
  }

  Vector3 traction(std::size_t face, double t) const {
    const auto [first, shares] = times_around(t);
    Vector3 sum = Vector3::Zero();
    for (std::size_t k = 0; k < 4; ++k) sum += shares[k] * tractions_[(first + k) * body_.surface.size() + face];
    return sum;
  }

 private:
  std::pair<std::size_t, std::array<double, 4>> times_around(double t) const {
    const double s = std::clamp(t, 0.0, known_) / step_;
    const double first = std::clamp(std::floor(s) - 1, 0.0, static_cast<double>(times_ - 4));
    return {static_cast<std::size_t>(first), cubic_shares(s - first - 1)};
  }

  const PerturbedBody& body_;
  double known_, step_ = 0;
  int times_ = 0;
  std::vector<ForceParts> parts_;
  std::vector<Vector3> tractions_;
};

struct PerturbedMotion::State {
  std::vector<Vector3> x, force;
  std::vector<Tensor> F, P;
};

PerturbedMotion::PerturbedMotion(PerturbedProblem problem, std::unique_ptr<PerturbedBody> body,
                                 std::vector<double> times)
    : problem_(std::move(problem)), body_(std::move(body)), times_(std::move(times)) {
  mass_.assign(body_->nodes.size(), 0);
  for (const MeshPoint& point : body_->loads) {
    for (std::size_t k = 0; k < 4; ++k) mass_[point.node[k]] += point.share[k] * point.weight;
  }
  table_ = std::make_unique<const Table>(problem_, *body_);
  step_ = courant * body_->edge / problem_.wave_speed;
}

PerturbedMotion::~PerturbedMotion() = default;

void PerturbedMotion::add_forces(const Mistake& mistake, double t, State& now) const {
  body_->add_stress(now.x, now.P, now.force);
  const double of_load = std::max(0.0, mistake.load_time(t));
  const double density = problem_.density * mistake.mass();
  for (const MeshPoint& point : body_->loads) {
    const Vector3 x = body_->position(now.x, point);
    const auto there = problem_.force_at_current_position
                           ? problem_.exact->reference_of(x, std::min(of_load, problem_.known))
                           : std::optional(point.X);
    const Vector3 b = mistake.body_force(*table_, there.value_or(point.X), x, of_load);
    body_->add_load(now.x, point, density * point.weight * b, now.force);
  }
  for (std::size_t s = 0; s < body_->surface.size(); ++s) {
    const MeshPoint& face = body_->surface[s];
    const Vector3 T = mistake.traction(table_->traction(s, of_load), face.normal);
    body_->add_load(now.x, face, face.weight * T, now.force);
  }
}

namespace {

/// The material at so many points, as the ABI takes them.
class StressPoints {
 public:
  StressPoints(const PerturbedProblem& problem, std::size_t points) : material_(*problem.material) {
    for (std::size_t first = 0; first < points; first += ASSAY_BATCH_MAX) {
      Batch& batch = batches_.emplace_back();
      batch.n = std::min<std::size_t>(points - first, ASSAY_BATCH_MAX);
      std::vector<double> direction(3 * batch.n);
      batch.F0.resize(9 * batch.n), batch.F1 = batch.cauchy = batch.F0;
      for (std::size_t p = 0; p < batch.n; ++p) {
        put_point({problem.direction.data(), 3}, direction.data(), batch.n, p);
        put_tensor(Tensor::Identity(), batch.F0.data(), batch.n, p);
      }
      batch.state = batch.next = material_.initial_state(batch.n, {}, direction);
    }
  }

  /// To F at t + dt; false where the material fails, or an element is nearly without volume.
  bool update(double t, double dt, const std::vector<Tensor>& F, std::vector<Tensor>& P) {
    std::size_t first = 0;
    for (Batch& batch : batches_) {
      for (std::size_t p = 0; p < batch.n; ++p) {
        if (!(F[first + p].determinant() > least_volume)) return false;
        put_tensor(F[first + p], batch.F1.data(), batch.n, p);
      }
      const UpdateReport report =
          material_.update(t, dt, batch.n, batch.F0.data(), batch.F1.data(), batch.state.data(),
                           batch.next.empty() ? nullptr : batch.next.data(), batch.cauchy.data());
      if (report.worst == ASSAY_FAILED) return false;
      for (std::size_t p = 0; p < batch.n; ++p)
        P[first + p] = first_piola_kirchhoff(tensor_at(batch.cauchy.data(), batch.n, p), F[first + p]);
      std::swap(batch.state, batch.next), std::swap(batch.F0, batch.F1);
      first += batch.n;
    }
    return true;
  }

 private:
  struct Batch {
    std::size_t n = 0;
    std::vector<double> F0, F1, state, next, cauchy;
  };
  const Material& material_;
  std::vector<Batch> batches_;
};

}  // namespace

PerturbedHistory PerturbedMotion::run(const Mistake& mistake) const {
  PerturbedHistory history;
  const PerturbedBody& body = *body_;
  const double end = times_.back(), count = std::ceil(end / step_ / std::sqrt(std::min(1.0, mistake.mass())));
  if (!(count < largest_steps)) return history;
  const auto steps = std::max<std::int64_t>(static_cast<std::int64_t>(count), 1);
  const double dt = end / static_cast<double>(steps);
  State now;
  now.x = body.nodes;
  now.P.assign(body.weights.size(), Tensor::Zero());
  StressPoints material(problem_, body.weights.size());
  const double kept = std::exp(-mistake.damping() * dt);  // of the velocity in a step
  std::vector<Vector3> v;
  for (const Vector3& X : body.nodes) v.push_back(mistake.initial_velocity(problem_.exact->state(X, 0).v));
  std::size_t output = 0;
  for (std::int64_t k = 0; k < steps; ++k) {
    const double t = dt * static_cast<double>(k);
    now.force.assign(body.nodes.size(), Vector3::Zero());
    add_forces(mistake, t, now);
    for (std::size_t i = 0; i < body.nodes.size(); ++i) {
      const Vector3 a = now.force[i] / (problem_.density * mistake.mass() * mass_[i]);
      for (std::size_t d = 0; d < 2; ++d) {
        double& along = v[i][static_cast<int>(d)];
        along = body.held[i][d] ? 0 : kept * along + (k > 0 ? dt : 0.5 * dt) * a[static_cast<int>(d)];
      }
    }
    const bool last = k + 1 == steps;
    for (; output < times_.size() && (last || times_[output] <= t + dt); ++output) {
      history.x.push_back(now.x);
      for (std::size_t i = 0; i < v.size(); ++i) history.x.back()[i] += (times_[output] - t) * v[i];
    }
    for (std::size_t i = 0; i < body.nodes.size(); ++i) now.x[i] += dt * v[i];
    body.deformation(now.x, now.F);
    if (!material.update(t, dt, now.F, now.P)) return history;
    for (std::size_t p = 0; p < now.P.size(); ++p) now.P[p] = mistake.stress(now.P[p], now.F[p]);
  }
  return history;
}

std::vector<Vector3> PerturbedMotion::difference(const PerturbedHistory& mistaken, const PerturbedHistory& right,
                                                 std::size_t k, const std::vector<Vector3>& X) const {
  std::vector<Vector3> nodal(body_->nodes.size()), values;
  for (std::size_t i = 0; i < nodal.size(); ++i) {
    nodal[i] = mistaken.x[k][i] - right.x[k][i];
    if (!problem_.exact->motion()->polar()) continue;
    const Vector3 x = problem_.exact->state(body_->nodes[i], times_[k]).x;
    nodal[i] = rotation_about_z(-std::atan2(x.y(), x.x())) * nodal[i];
  }
  for (const Vector3& place : X) values.push_back(body_->value_at(nodal, place));
  return values;
}

}  // namespace assay
