// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/judge/exact_particles.hpp"

#include <algorithm>

#include "drivers/judge/judged_run.hpp"
#include "harness/motion/kinds/vortex3d.hpp"

namespace assay::drivers {

const ExactPlaces& ExactParticles::places(const std::vector<Vector3>& X) {
  if (!places_ || X != X_) X_ = X, places_ = solution_->places(X), stress_.reset(), moving_.clear();
  return *places_;
}

/// The stress that a run measures its own by.
void ExactParticles::set_plane_stress(double t) {
  if (!stress_) {
    std::vector<double> along_X, along_Y;
    for (const Vector3& X : X_) along_X.push_back(X.x()), along_Y.push_back(X.y());
    stress_ = solution_->instant({along_X, along_Y}, {.stress = true});
  }
  stress_->set_time(t);
}

void ExactParticles::take_plane_stress(std::size_t first, std::span<PointFields> fields) const {
  for (std::size_t p = 0; p < fields.size(); ++p) {
    const auto& s = stress_->state(first + p).sigma;
    fields[p].sigma = {s[0], s[3], s[4], s[1], 0, 0};
  }
}

namespace {

FieldViews views_of(std::vector<PointFields>& fields, bool stress) {
  FieldViews views = PointFields::views(fields.data());
  views.a = views.P = views.b = views.static_force = {};
  if (!stress) views.sigma = {};
  return views;
}

FieldViews views_of_velocities(std::vector<PointFields>& fields) {
  const FieldViews all = PointFields::views(fields.data());
  FieldViews views{};
  views.dimension = all.dimension, views.v = all.v, views.a = all.a;
  return views;
}

}  // namespace

const std::vector<PointFields>& ExactParticles::at(const std::vector<Vector3>& X, double t, bool stress) {
  now_.assign(X.size(), {});
  const bool in_plane = stress && dimension_ == 2;
  places(X).evaluate(*solution_->slice(t), 0, X.size(), views_of(now_, stress && !in_plane));
  if (in_plane) set_plane_stress(t), take_plane_stress(0, now_);
  return now_;
}

void ExactParticles::in_stretches(const std::vector<Vector3>& X, double t, double t_velocity, bool stress,
                                  const TakeStretch& take) {
  constexpr std::size_t most = 4096;
  const ExactPlaces& all = places(X);
  const bool in_plane = stress && dimension_ == 2, apart = t_velocity != t;
  const auto slice = solution_->slice(t), later = apart ? solution_->slice(t_velocity) : nullptr;
  if (in_plane) set_plane_stress(t);
  const std::size_t room = std::clamp<std::size_t>(X.size(), 1, most);  // views point to something
  std::vector<PointFields> now(room), velocities(apart ? room : 1);
  const FieldViews views = views_of(now, stress && !in_plane), of_velocities = views_of_velocities(velocities);
  for (std::size_t first = 0; first < X.size(); first += most) {
    const std::size_t count = std::min(most, X.size() - first);
    all.evaluate(*slice, first, count, views);
    if (in_plane) take_plane_stress(first, {now.data(), count});
    if (apart) all.evaluate(*later, first, count, of_velocities);
    take(first, {now.data(), count}, {apart ? velocities.data() : now.data(), count});
  }
}

const std::vector<PointFields>& ExactParticles::velocities(const std::vector<Vector3>& X, double t) {
  of_velocity_.assign(X.size(), {});
  places(X).evaluate(*solution_->slice(t), 0, X.size(), views_of_velocities(of_velocity_));
  return of_velocity_;
}

const std::vector<char>& ExactParticles::moving(const std::vector<Vector3>& X) {
  places(X);
  if (!moving_.empty()) return moving_;
  const auto slice = solution_->slice(0);
  std::vector<char>& moving = moving_;
  moving.assign(X.size(), 1);
  if (const auto* turning = solution_->motion().as<Vortex3d>()) {
    const VortexFinder find(*turning);
    for (std::size_t p = 0; p < X.size(); ++p) moving[p] = find.place(X[p]).has_value();
    return moving;
  }
  constexpr auto motion = ExactSlice::Smooth::motion;
  if (!slice->has_parts(motion)) return moving;
  for (std::size_t p = 0; p < X.size(); ++p) moving[p] = slice->part(X[p], motion) != 0;
  return moving;
}

Vector3 ExactParticles::reference_of(const Vector3& x, double t) const {
  const auto X = solution_->reference_of(x, t);
  return X ? *X : Vector3::Constant(not_written);
}

}  // namespace assay::drivers
