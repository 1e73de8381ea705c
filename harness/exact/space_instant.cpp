// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/space_instant.hpp"

namespace assay {

std::vector<Vector3> SpaceInstant::some(std::size_t begin, std::size_t end) const {
  std::vector<Vector3> X;
  X.reserve(end - begin);
  for (std::size_t p = begin; p < end; ++p) X.emplace_back(points_[0][p], points_[1][p], points_[2][p]);
  return X;
}

SpaceInstant::Window SpaceInstant::window(std::size_t begin, std::size_t end) const {
  return window_of(begin, solution_->places(some(begin, end)));
}

SpaceInstant::Window SpaceInstant::window(const Window& same) const { return window_of(same.begin_, same.places_); }

SpaceInstant::Window SpaceInstant::window_of(std::size_t begin, std::shared_ptr<const ExactPlaces> places) const {
  const std::size_t count = places->size();
  Window window;
  window.now_ = now_.get();
  window.places_ = std::move(places);
  window.begin_ = begin;
  window.fields_.resize(count);
  FieldViews views = PointFields::views(window.fields_.data());
  views.b = views.static_force = {};
  if (!asked_.stress) views.P = views.sigma = {};
  if (!asked_.inertia) views.a = {};
  if (!asked_.motion && !asked_.stress) views.x = views.v = views.F = {};
  window.places_->evaluate(*now_, 0, count, views);
  return window;
}

void SpaceInstant::body_force(std::size_t begin, std::size_t end, const std::array<double*, 3>& b) const {
  FieldViews views;
  views.b = {b[0] + begin, 1, b[1] - b[0]};
  solution_->places(some(begin, end))->evaluate(*now_, 0, end - begin, views);
}

SpaceState SpaceInstant::Window::state(std::size_t point) const {
  const PointFields& f = at(point);
  return {f.x, f.v, f.F, f.sigma};
}

SpaceInertia SpaceInstant::Window::inertia(std::size_t point) const {
  return {at(point).a, nine_of(now_->acceleration_gradient(X(point)))};
}

std::array<double, 3> SpaceInstant::Window::displacement(std::size_t point) const {
  const Vector3 u = places_->displacement(*now_, point - begin_);
  return {u.x(), u.y(), u.z()};
}

double SpaceInstant::Window::measure(std::size_t point, const std::array<double, 9>& F) const {
  return now_->measure(X(point), tensor_of(F.data()));
}

}  // namespace assay
