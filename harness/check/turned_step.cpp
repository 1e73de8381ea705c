// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/turned_step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "harness/check/judge.hpp"
#include "harness/check/share_along.hpp"
#include "harness/check/state_place.hpp"
#include "harness/check/turned_reading.hpp"

namespace assay::check {

namespace {

constexpr double small_turn = 0.02;         ///< [rad]
constexpr double alike = 0.2 * small_turn;  ///< of the largest component: a step may be second order in the turn
constexpr double trifle = 1e-10;
constexpr double rounding = 1e-9;  ///< of the largest component

/// A tensor without its sphere, which does not turn.
Variable without_sphere(const Variable& v) {
  if (!v.is_tensor()) return v;
  return v.with(v.value() - v.value().trace() / 3 * Tensor::Identity());
}

/// An assumption about what became of a variable in a turn of the body.
struct Fate {
  Turned how;
  double times;
  Variable expected;
  ShearOrder order = {0, 1, 2};
};

std::vector<Fate> fates_of(const Space& space, const Variable& before) {
  const Tensor Q = space.turn(small_turn);
  const Variable right = before.turned(Q);
  std::vector<Fate> fates{{Turned::rightly, 1, right}, {Turned::not_at_all, 0, before}};
  if (before.is_tensor() && !space.is_plane()) {
    for (const ShearOrder& order : other_orders) {
      for (const Variable& each : {right, before}) {
        fates.push_back({Turned::in_another_order, 1, each.with(in_order(order, each.value())), order});
      }
      const Variable meant = before.with(in_order(reversed(order), before.value())).turned(Q);
      fates.push_back({Turned::in_another_order, 1, meant.with(in_order(order, meant.value())), order});
    }
  }
  if (before.is_tensor()) {
    for (const double factor : {2.0, 0.5}) {
      const Variable meant = before.with(sheared(before.value(), factor)).turned(Q);
      fates.push_back({Turned::with_shear_factor, 1, meant.with(sheared(meant.value(), 1 / factor))});
    }
  }
  constexpr double range = 2.5, step = 0.01, no_turn = 0.1;
  for (double times = -range; times <= range; times += step) {
    if (std::abs(times) < no_turn || std::abs(times - 1) < no_turn) continue;
    fates.push_back({Turned::by_another_angle, times, before.turned(space.turn(times * small_turn))});
  }
  return fates;
}

/// How `found` has come out of `before` in a turn of the body, and by how much that misses it, relative.
std::pair<TurnedVariable, double> carried(const Space& space, const Variable& before, const Variable& found) {
  std::pair<TurnedVariable, double> best{{}, alike};
  best.first.how = Turned::otherwise;
  for (const Fate& fate : fates_of(space, before)) {
    const double miss = found.distance(fate.expected) / before.largest();
    if (!(miss < 0.5 * best.second)) continue;  // the first are the likelier ones
    best.first.how = fate.how;
    best.first.times = fate.times;
    best.first.order = fate.order;
    best.first.exactly = miss < rounding;
    best.second = miss;
  }
  return best;
}

bool proportional(const Tensor& a, const Tensor& b) {
  const double share = share_along(a, b);
  return std::isfinite(share) && distance(a, share * b) < 1e-3 * a.cwiseAbs().maxCoeff();
}

Loaded loaded(const Specimen& specimen, double s) {
  const double a = specimen.amplitude;
  const Loading loading{[&](double t) { return specimen.space.stretch(a, s * t); }, 1};
  const March found = march(*specimen.material, loading, {.steps = specimen.steps(), .state = specimen.rest_state()});
  const double length = 1.0 / specimen.steps();
  return {loading.F(1), found.marks[0], length, specimen.rate_dependent() ? 1e-9 : length};
}

/// Whether the stress of a loading depends on a variable at all: a model may keep what only its output shows.
bool is_read(const Specimen& specimen, const Loaded& from, double s, const StatePlace& place) {
  constexpr double further = 0.02, significant = 1e-9;
  const Tensor F1 = specimen.space.stretch(specimen.amplitude, s + further);
  std::vector<double> other = from.point.state;
  place.in(other).turned(specimen.space.turn(turning_angle)).write(&other[place.at]);
  const auto stress = [&](const std::vector<double>& state) {
    return stepped(*specimen.material, 1, from.length, from.F, F1, state).cauchy;
  };
  try {
    const Tensor usual = stress(from.point.state);
    return distance(stress(other), usual) > significant * usual.cwiseAbs().maxCoeff();
  } catch (const MaterialFailure&) {
    return true;
  }
}

/// In a turn of a loaded body, and of one that has been unloaded a little, so that the turn makes nothing flow: what
/// fits best.
std::vector<TurnedVariable> carried_variables(const Specimen& specimen, const Loaded& from, double s) {
  const Material& material = *specimen.material;
  const Tensor Q = specimen.space.turn(small_turn);
  const std::vector<StatePlace> places = places_of(material);
  std::vector<TurnedVariable> all;
  std::vector<double> misses;
  std::vector<bool> seen_at_all(places.size(), false);
  for (const StatePlace& place : places) {
    all.push_back({.name = place.name, .how = Turned::otherwise, .is_own = place.is_own});
    misses.push_back(INFINITY);
  }
  for (const double back : {0.0, 2e-3, 1e-2, 3e-2}) {
    const Tensor F = specimen.space.stretch(specimen.amplitude, s - back);
    const std::vector<double> state = stepped(material, 1, from.instant, from.F, F, from.point.state).state;
    const Point held = stepped(material, 1, from.instant, F, F, state);
    const Point seen = stepped(material, 1, from.instant, F, Q * F, state);
    for (std::size_t v = 0; v < places.size(); ++v) {
      const Variable whole = places[v].in(held.state), before = without_sphere(whole);
      if (!(whole.largest() > trifle) || before.largest() < 1e-6 * whole.largest()) continue;
      seen_at_all[v] = true;
      const auto [found, miss] = carried(specimen.space, before, without_sphere(places[v].in(seen.state)));
      if (!(miss < 0.5 * misses[v])) continue;
      misses[v] = miss;
      all[v].how = found.how;
      all[v].times = found.times;
      all[v].order = found.order;
      all[v].exactly = found.exactly;
      all[v].is_stress = before.is_tensor() && proportional(whole.value(), held.cauchy);
    }
  }
  for (std::size_t v = 0; v < places.size(); ++v) {
    const bool judged = seen_at_all[v] && is_read(specimen, from, s, places[v]);
    if (!judged) all[v].how = Turned::rightly;
  }
  return all;
}

}  // namespace

std::optional<TurnedStep> turned_step(const Specimen& specimen) {
  constexpr double s = 0.2;  // of the loading, on its way out
  try {
    const Loaded from = loaded(specimen, s);
    TurnedStep found;
    found.carried = carried_variables(specimen, from, s);
    read_back(specimen, from, s, found);
    return found;
  } catch (const MaterialFailure&) {
    return std::nullopt;
  }
}

}  // namespace assay::check
