// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/places.hpp"

#include <map>

namespace assay {

namespace {

constexpr std::array<int, 6> symmetric_components{0, 4, 8, 1, 2, 5};  // 11, 22, 33, 12, 13, 23 of nine

void put_vector(const FieldView& view, std::size_t point, std::size_t dimension, const Vector3& value) {
  if (!view) return;
  for (std::size_t c = 0; c < dimension; ++c) view.at(point, c) = value(static_cast<int>(c));
}

void put_nine(const FieldView& view, std::size_t point, const Tensor& value) {
  if (!view) return;
  for (int c = 0; c < 9; ++c) view.at(point, static_cast<std::size_t>(c)) = component(value, c);
}

}  // namespace

FieldViews FieldViews::from(std::size_t point) const {
  return {dimension,     x.from(point),     v.from(point), a.from(point),           F.from(point),
          P.from(point), sigma.from(point), b.from(point), static_force.from(point)};
}

void FieldViews::put(std::size_t point, const ExactPoint& values) const {
  const auto& [state, stress] = values;
  put_vector(x, point, dimension, state.x);
  put_vector(v, point, dimension, state.v);
  put_vector(a, point, dimension, state.a);
  put_nine(F, point, state.F);
  put_nine(P, point, stress.first_piola_kirchhoff);
  put_vector(b, point, dimension, stress.body_force);
  put_vector(static_force, point, dimension, stress.static_force);
  for (std::size_t c = 0; sigma && c < 6; ++c) sigma.at(point, c) = component(stress.cauchy, symmetric_components[c]);
}

FieldViews PointFields::views(PointFields* first) {
  constexpr std::ptrdiff_t point = sizeof(PointFields) / sizeof(double);
  const auto view = [](auto& values) { return FieldView{values.data(), point, 1}; };
  return {3,
          view(first->x),
          view(first->v),
          view(first->a),
          view(first->F),
          view(first->P),
          view(first->sigma),
          view(first->b),
          view(first->static_force)};
}

ExactPoint PointFields::point() const {
  const auto vector = [](const std::array<double, 3>& c) { return Vector3(c[0], c[1], c[2]); };
  ExactPoint p;
  p.state.x = vector(x), p.state.v = vector(v), p.state.a = vector(a);
  p.state.F = tensor_of(F.data());
  p.stress.first_piola_kirchhoff = tensor_of(P.data());
  p.stress.cauchy << sigma[0], sigma[3], sigma[4], sigma[3], sigma[1], sigma[5], sigma[4], sigma[5], sigma[2];
  p.stress.body_force = vector(b), p.stress.static_force = vector(static_force);
  return p;
}

void ExactPlaces::evaluate(const ExactSlice& now, std::size_t first, std::size_t count, const FieldViews& out) const {
  for (std::size_t p = 0; p < count; ++p) out.put(p, now.at(X_[first + p]));
}

}  // namespace assay
