// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/exact_rows.hpp"

#include <algorithm>

#include "drivers/system/interrupt.hpp"
#include "drivers/text/words.hpp"
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

/// What is wanted of points, the first of which is there.
FieldViews ExactRows::wanted_of(PointFields* first) const {
  FieldViews out = PointFields::views(first);
  const auto leave_out = [&](FieldView& view, std::initializer_list<Quantity> of, bool absent = false) {
    if (absent || !has_one_of(columns_, of)) view = {};
  };
  leave_out(out.x, {Quantity::position});
  leave_out(out.v, {Quantity::velocity});
  leave_out(out.a, {Quantity::acceleration});
  leave_out(out.F, {Quantity::gradient});
  leave_out(out.P, {Quantity::piola, Quantity::traction});
  leave_out(out.sigma, {Quantity::cauchy});
  leave_out(out.b, {Quantity::force}, choice_.boxes || choice_.is_static);
  leave_out(out.static_force, {Quantity::force}, choice_.boxes || !choice_.is_static);
  return out;
}

/// All points of a time in one call.
void ExactRows::evaluate_at(double t, const std::vector<Vector3>& X, const FieldViews& out) {
  const ExactSlice& now = *latest(
                               slices_, [&](const Slice& each) { return each.t == t; },
                               [&] {
                                 return Slice{t, solution_->slice(t)};
                               })
                               .slice;
  const ExactPlaces& here = *latest(
                                 places_, [&](const Places& each) { return each.X == X; },
                                 [&] {
                                   return Places{X, solution_->places(X)};
                                 })
                                 .places;
  here.evaluate(now, 0, here.size(), out);
}

void ExactRows::exact_values(const std::vector<ReferencePoint>& block, const ExactSolution::Between& between) {
  fields_.resize(block.size());
  if (!needs_.motion && !needs_.stress) return;
  const FieldViews out = wanted_of(fields_.data());
  const auto place = [](const ReferencePoint& point) { return Vector3(point.X, point.Y, point.Z); };
  const auto same = [&](const ReferencePoint& point) { return point.t == block.front().t; };
  const bool follows_histories = needs_.stress && !solution_->response();  // best all times of a place together
  if (!follows_histories && std::ranges::all_of(block, same))
    return evaluate_at(block.front().t, mapped(block, place), out);
  std::vector<PlaceAndTime> places;
  for (const ReferencePoint& point : block) places.push_back({place(point), point.t});
  solution_->evaluate(places, out, between);
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
