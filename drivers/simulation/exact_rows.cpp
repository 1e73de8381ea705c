// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/exact_rows.hpp"

#include <algorithm>
#include <map>

#include "drivers/system/interrupt.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::drivers {

namespace {

bool has_one_of(const std::vector<PointColumn>& columns, std::initializer_list<Quantity> some) {
  return std::ranges::any_of(columns, [&](const PointColumn& column) {
    return std::find(some.begin(), some.end(), column.quantity) != some.end();
  });
}

/// Of the Cauchy stress: 11, 22, 33, 12, 13, 23 in the place of nine components.
constexpr std::array<std::size_t, 9> place_in_six{0, 3, 4, 3, 1, 5, 4, 5, 2};

/// Of a short list the one that fits, else a new one. It comes first, and the last one goes.
template <class Kept>
const Kept& latest(std::list<Kept>& kept, const auto& fits, const auto& made) {
  constexpr std::size_t most = 8;
  const auto found = std::ranges::find_if(kept, fits);
  if (found != kept.end()) {
    kept.splice(kept.begin(), kept, found);
  } else {
    kept.push_front(made());
    if (kept.size() > most) kept.pop_back();
  }
  return kept.front();
}

}  // namespace

RowNeeds::RowNeeds(const std::vector<PointColumn>& columns, bool boxes)
    : motion(has_one_of(columns, {Quantity::position, Quantity::velocity, Quantity::acceleration, Quantity::gradient})),
      stress(has_one_of(columns, {Quantity::piola, Quantity::cauchy, Quantity::traction}) ||
             (!boxes && has_one_of(columns, {Quantity::force}))),
      box(boxes && has_one_of(columns, {Quantity::force, Quantity::volume, Quantity::moment})) {}

ExactRows::ExactRows(ExactSolutionPtr solution, std::vector<PointColumn> columns, const Choice& choice)
    : solution_(std::move(solution)), columns_(std::move(columns)), choice_(choice), needs_(columns_, choice.boxes) {}

const ExactSlice& ExactRows::slice_at(double t) {
  const auto is_there = [&](const Slice& each) { return each.t == t; };
  return *latest(slices_, is_there, [&] { return Slice{t, solution_->slice(t)}; }).slice;
}

const ExactPlaces& ExactRows::places_at(const std::vector<Vector3>& X) {
  const auto is_there = [&](const Places& each) { return each.X == X; };
  return *latest(places_, is_there, [&] { return Places{X, std::make_unique<const ExactPlaces>(X)}; }).places;
}

/// All points of a time in one call.
void ExactRows::evaluate_at(double t, const ExactPlaces& places, PointFields* into) {
  FieldViews out = PointFields::views(into);
  const auto leave_out = [&](FieldView& view, std::initializer_list<Quantity> of) {
    if (!has_one_of(columns_, of)) view = {};
  };
  leave_out(out.x, {Quantity::position});
  leave_out(out.v, {Quantity::velocity});
  leave_out(out.a, {Quantity::acceleration});
  leave_out(out.F, {Quantity::gradient});
  leave_out(out.P, {Quantity::piola, Quantity::traction});
  leave_out(out.sigma, {Quantity::cauchy});
  if (choice_.boxes || choice_.is_static) out.b = {};
  leave_out(out.b, {Quantity::force});
  if (choice_.boxes || !choice_.is_static) out.static_force = {};
  leave_out(out.static_force, {Quantity::force});
  places.evaluate(slice_at(t), 0, places.size(), out);
}

void ExactRows::exact_values(const std::vector<ReferencePoint>& block, const ExactSolution::Between& between) {
  const std::size_t n = block.size();
  fields_.resize(n);
  const auto place = [&](std::size_t i) { return Vector3(block[i].X, block[i].Y, block[i].Z); };
  const auto put = [&](std::size_t i, const ExactPoint& point) { PointFields::views(&fields_[i]).put(0, point); };
  if (!needs_.stress) {
    for (std::size_t i = 0; needs_.motion && i < n; ++i) put(i, {solution_->state(place(i), block[i].t), {}});
    return;
  }
  if (!solution_->response()) {  // histories, which the solution puts in an order
    std::vector<PlaceAndTime> places;
    for (std::size_t i = 0; i < n; ++i) places.push_back({place(i), block[i].t});
    const std::vector<ExactPoint> found = solution_->at(places, between);
    for (std::size_t i = 0; i < n; ++i) put(i, found[i]);
    return;
  }
  std::map<double, std::vector<std::size_t>> by_time;
  for (std::size_t i = 0; i < n; ++i) by_time[block[i].t].push_back(i);
  std::vector<Vector3> X;
  std::vector<PointFields> of_time;
  std::size_t done = 0;
  for (const auto& [t, some] : by_time) {
    if (between) between(static_cast<double>(done) / static_cast<double>(n), "points");
    X.clear();
    for (const std::size_t i : some) X.push_back(place(i));
    if (some.size() == n) return evaluate_at(t, places_at(X), fields_.data());
    of_time.resize(some.size());
    evaluate_at(t, ExactPlaces(X), of_time.data());
    for (std::size_t k = 0; k < some.size(); ++k) fields_[some[k]] = of_time[k];
    done += some.size();
  }
}

double ExactRows::value(const PointColumn& column, const ReferencePoint& point, std::size_t i) const {
  const auto c = static_cast<std::size_t>(column.component);
  const PointFields& at = fields_[i];
  switch (column.quantity) {
    case Quantity::reference:
      return c == 0 ? point.X : c == 1 ? point.Y : point.Z;
    case Quantity::time:
      return point.t;
    case Quantity::position:
      return at.x[c];
    case Quantity::velocity:
      return at.v[c];
    case Quantity::acceleration:
      return at.a[c];
    case Quantity::gradient:
      return at.F[c];
    case Quantity::piola:
      return at.P[c];
    case Quantity::cauchy:
      return at.sigma[place_in_six[c]];
    case Quantity::force:
      if (choice_.boxes) return over_boxes_[i].acts.b(column.component);
      return choice_.is_static ? at.static_force[c] : at.b[c];
    case Quantity::volume:
      return over_boxes_[i].volume;
    case Quantity::moment:
      return over_boxes_[i].acts.moment(column.component);
    case Quantity::traction:  // per reference area [Pa]
      return (tensor_of(at.P.data()) * unit_along({point.NX, point.NY, point.NZ}))(column.component);
  }
  return 0;
}

void ExactRows::evaluate(const std::vector<ReferencePoint>& block, std::vector<double>& values,
                         const ExactSolution::Between& between) {
  stop_if_interrupted();
  exact_values(block, between);
  if (needs_.box) over_boxes_ = box_forces(*solution_, choice_.density, block, choice_.three, choice_.is_static);
  values.resize(block.size() * columns_.size());
  auto into = values.begin();
  for (std::size_t i = 0; i < block.size(); ++i) {
    for (const PointColumn& column : columns_) *into++ = value(column, block[i], i);
  }
}

}  // namespace assay::drivers
