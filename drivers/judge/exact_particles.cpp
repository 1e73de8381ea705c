// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/judge/exact_particles.hpp"

#include "drivers/judge/judged_run.hpp"
#include "harness/motion/kinds/vortex3d.hpp"

namespace assay::drivers {

const ExactPlaces& ExactParticles::places(const std::vector<Vector3>& X) {
  if (!places_ || X != X_) X_ = X, places_ = solution_->places(X), stress_.reset();
  return *places_;
}

/// The stress that a run measures its own by.
void ExactParticles::take_plane_stress(double t) {
  if (!stress_) {
    std::vector<double> along_X, along_Y;
    for (const Vector3& X : X_) along_X.push_back(X.x()), along_Y.push_back(X.y());
    stress_ = solution_->instant({along_X, along_Y}, {.stress = true});
  }
  stress_->set_time(t);
  for (std::size_t p = 0; p < X_.size(); ++p) {
    const auto& s = stress_->state(p).sigma;
    now_[p].sigma = {s[0], s[3], s[4], s[1], 0, 0};
  }
}

const std::vector<PointFields>& ExactParticles::at(const std::vector<Vector3>& X, double t, bool stress) {
  now_.assign(X.size(), {});
  FieldViews views = PointFields::views(now_.data());
  views.a = views.P = views.b = views.static_force = {};
  if (!stress || dimension_ == 2) views.sigma = {};
  places(X).evaluate(*solution_->slice(t), 0, X.size(), views);
  if (stress && dimension_ == 2) take_plane_stress(t);
  return now_;
}

const std::vector<PointFields>& ExactParticles::velocities(const std::vector<Vector3>& X, double t) {
  of_velocity_.assign(X.size(), {});
  const FieldViews all = PointFields::views(of_velocity_.data());
  FieldViews views{};
  views.dimension = all.dimension, views.v = all.v, views.a = all.a;
  places(X).evaluate(*solution_->slice(t), 0, X.size(), views);
  return of_velocity_;
}

std::vector<char> ExactParticles::moving(const std::vector<Vector3>& X) const {
  const auto slice = solution_->slice(0);
  std::vector<char> moving(X.size(), 1);
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
