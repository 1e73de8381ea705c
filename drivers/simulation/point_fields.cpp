// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/point_fields.hpp"

#include <algorithm>
#include <map>

#include "drivers/system/interrupt.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::drivers {

namespace {

bool needs_one_of(const std::vector<PointColumn>& columns, std::initializer_list<Quantity> some) {
  return std::ranges::any_of(columns, [&](const PointColumn& column) {
    return std::find(some.begin(), some.end(), column.quantity) != some.end();
  });
}

}  // namespace

PointNeeds::PointNeeds(const std::vector<PointColumn>& columns, bool boxes)
    : motion(
          needs_one_of(columns, {Quantity::position, Quantity::velocity, Quantity::acceleration, Quantity::gradient})),
      stress(needs_one_of(columns, {Quantity::piola, Quantity::cauchy, Quantity::traction}) ||
             (!boxes && needs_one_of(columns, {Quantity::force}))),
      box(boxes && needs_one_of(columns, {Quantity::force, Quantity::volume, Quantity::moment})) {}

PointFields::PointFields(ExactSolutionPtr solution, std::vector<PointColumn> columns, const Choice& choice)
    : solution_(std::move(solution)), columns_(std::move(columns)), choice_(choice), needs_(columns_, choice.boxes) {}

const ExactSlice& PointFields::slice_at(double t) {
  constexpr std::size_t most = 8;
  const auto found = std::ranges::find_if(slices_, [&](const Slice& each) { return each.t == t; });
  if (found != slices_.end()) {
    slices_.splice(slices_.begin(), slices_, found);
  } else {
    slices_.push_front({t, solution_->slice(t)});
    if (slices_.size() > most) slices_.pop_back();
  }
  return *slices_.front().slice;
}

void PointFields::exact_values(const std::vector<ReferencePoint>& block, const ExactSolution::Between& between) {
  const std::size_t n = block.size();
  exact_.assign(n, {});
  const auto place = [&](std::size_t i) { return Vector3(block[i].X, block[i].Y, block[i].Z); };
  if (!needs_.stress) {
    for (std::size_t i = 0; needs_.motion && i < n; ++i) exact_[i].state = solution_->state(place(i), block[i].t);
    return;
  }
  if (!solution_->response()) {  // histories, which the solution puts in an order
    std::vector<PlaceAndTime> places;
    for (std::size_t i = 0; i < n; ++i) places.push_back({place(i), block[i].t});
    exact_ = solution_->at(places, between);
    return;
  }
  std::map<double, std::vector<std::size_t>> by_time;
  for (std::size_t i = 0; i < n; ++i) by_time[block[i].t].push_back(i);
  std::size_t done = 0;
  for (const auto& [t, some] : by_time) {
    if (between) between(static_cast<double>(done) / static_cast<double>(n), "points");
    const ExactSlice& slice = slice_at(t);
    for (const std::size_t i : some) exact_[i] = slice.at(place(i));
    done += some.size();
  }
}

double PointFields::value(const PointColumn& column, const ReferencePoint& point, std::size_t i) const {
  const int c = column.component;
  const ExactState& state = exact_[i].state;
  const ExactStress& stress = exact_[i].stress;
  switch (column.quantity) {
    case Quantity::reference:
      return c == 0 ? point.X : c == 1 ? point.Y : point.Z;
    case Quantity::time:
      return point.t;
    case Quantity::position:
      return state.x(c);
    case Quantity::velocity:
      return state.v(c);
    case Quantity::acceleration:
      return state.a(c);
    case Quantity::gradient:
      return component(state.F, c);
    case Quantity::piola:
      return component(stress.first_piola_kirchhoff, c);
    case Quantity::cauchy:
      return component(stress.cauchy, c);
    case Quantity::force:
      if (choice_.boxes) return over_boxes_[i].acts.b(c);
      return stress.body_force(c) - (choice_.without_inertia ? state.a(c) : 0);
    case Quantity::volume:
      return over_boxes_[i].volume;
    case Quantity::moment:
      return over_boxes_[i].acts.moment(c);
    case Quantity::traction:
      return (stress.first_piola_kirchhoff * unit_along({point.NX, point.NY, point.NZ}))(c);  // per reference area [Pa]
  }
  return 0;
}

void PointFields::evaluate(const std::vector<ReferencePoint>& block, std::vector<double>& values,
                           const ExactSolution::Between& between) {
  stop_if_interrupted();
  exact_values(block, between);
  if (needs_.box) over_boxes_ = box_forces(*solution_, choice_.density, block, choice_.three);
  values.resize(block.size() * columns_.size());
  auto into = values.begin();
  for (std::size_t i = 0; i < block.size(); ++i) {
    for (const PointColumn& column : columns_) *into++ = value(column, block[i], i);
  }
}

}  // namespace assay::drivers
