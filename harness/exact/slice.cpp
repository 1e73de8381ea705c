// SPDX-License-Identifier: BSD-3-Clause
// Slices of solutions that are asked for each point alone.
#include <algorithm>
#include <cmath>
#include <map>

#include "harness/exact/places.hpp"
#include "harness/numeric/central_difference.hpp"

namespace assay {

namespace {

class SliceOfPoints final : public ExactSlice {
 public:
  SliceOfPoints(const ExactSolution& solution, double t) : solution_(solution), t_(t) {}
  ExactPoint at(const Vector3& X) const override { return solution_.at(X, t_); }
  ExactState state(const Vector3& X) const override { return solution_.state(X, t_); }
  double length() const override { return solution_.motion()->length(); }

 private:
  const ExactSolution& solution_;
  double t_;
};

}  // namespace

Tensor ExactSlice::acceleration_gradient(const Vector3& X) const {
  constexpr double share = 0.01;  // of the length: what eighth order leaves is rounding
  const double step = share * std::min(1.0, length());
  Tensor gradient;
  for (int d = 0; d < 3; ++d) {
    const auto a = [&](int k) -> Vector3 { return state(X + k * step * Vector3::Unit(d)).a; };
    gradient.col(d) = central_difference(a, step);
  }
  return gradient;
}

std::unique_ptr<const ExactSlice> ExactSolution::slice(double t) const {
  return std::make_unique<SliceOfPoints>(*this, t);
}

std::unique_ptr<const ExactPlaces> ExactSolution::places(std::vector<Vector3> X) const {
  return std::make_unique<ExactPlaces>(std::move(X));
}

void ExactSolution::evaluate(std::span<const PlaceAndTime> points, const FieldViews& out,
                             const Between& between) const {
  constexpr std::size_t at_once = 4096;
  std::map<double, std::vector<std::size_t>> by_time;
  for (std::size_t i = 0; i < points.size(); ++i) by_time[points[i].t].push_back(i);
  std::size_t done = 0;
  for (const auto& [t, which] : by_time) {
    const auto now = slice(t);
    for (std::size_t first = 0; first < which.size(); first += at_once) {
      if (between) between(static_cast<double>(done) / static_cast<double>(points.size()), "points");
      const std::span some = std::span(which).subspan(first, std::min(at_once, which.size() - first));
      std::vector<Vector3> X;
      for (const std::size_t i : some) X.push_back(points[i].X);
      const auto here = places(std::move(X));
      const bool in_order = some.back() - some.front() + 1 == some.size();
      if (in_order) here->evaluate(*now, 0, some.size(), out.from(some.front()));
      for (std::size_t k = 0; !in_order && k < some.size(); ++k) here->evaluate(*now, k, 1, out.from(some[k]));
      done += some.size();
    }
  }
}

std::vector<ExactPoint> ExactSolution::at(std::span<const PlaceAndTime> points, const Between& between) const {
  std::vector<PointFields> fields(points.size());
  evaluate(points, PointFields::views(fields.data()), between);
  std::vector<ExactPoint> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    found.push_back(fields[i].point());
    found.back().state.F_rate = state(points[i].X, points[i].t).F_rate;
  }
  return found;
}

}  // namespace assay
