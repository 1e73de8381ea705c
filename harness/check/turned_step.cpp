// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/turned_step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "harness/check/diagnosis.hpp"

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
std::pair<Fate, double> carried(const Space& space, const Variable& before, const Variable& found) {
  std::pair<Fate, double> best{{Turned::otherwise, 1, before}, alike};
  for (const Fate& fate : fates_of(space, before)) {
    const double miss = found.distance(fate.expected) / before.largest();
    if (miss < 0.5 * best.second) best = {fate, miss};  // the first are the likelier ones
  }
  return best;
}

bool proportional(const Tensor& a, const Tensor& b) {
  const double share = share_along(a, b);
  return std::isfinite(share) && distance(a, share * b) < 1e-3 * size_of(a);
}

Loaded loaded(const Specimen& specimen, double s) {
  const Loading loading = stretch_to(specimen, s);
  const double length = 1.0 / specimen.steps();
  return {loading.F(1), from_rest(specimen, loading).marks[0], length, specimen.rate_dependent() ? 1e-9 : length};
}

/// Whether the stress of a loading depends on a variable at all: a model may keep what only its output shows.
bool is_read(const Specimen& specimen, const Loaded& from, double s, const StatePlace& place) {
  constexpr double significant = 1e-9;
  std::vector<double> other = from.point.state;
  place.in(other).turned(specimen.space.turn(turning_angle)).write(&other[place.first]);
  const auto stress = [&](const std::vector<double>& state) {
    return stepped(specimen, 1, from.length, from.F, further_on(specimen, s), state).cauchy;
  };
  const auto differs = [&] {
    const Tensor usual = stress(from.point.state);
    return distance(stress(other), usual) > significant * size_of(usual);
  };
  return if_taken(differs, true);
}

/// In a turn of a loaded body, and of one that has been unloaded a little, so that the turn makes nothing flow: what
/// fits best.
std::vector<TurnedVariable> carried_variables(const Specimen& specimen, const Loaded& from, double s) {
  const Tensor Q = specimen.space.turn(small_turn);
  const std::vector<StatePlace> places = places_of(specimen);
  std::vector<TurnedVariable> all;
  std::vector<double> misses;
  std::vector<bool> seen_at_all(places.size(), false);
  for (const StatePlace& place : places) {
    all.push_back({.name = place.name, .how = Turned::otherwise, .is_own = place.turns_itself()});
    misses.push_back(INFINITY);
  }
  for (const double back : {0.0, 2e-3, 1e-2, 3e-2}) {
    const Tensor F = specimen.stretch(s - back);
    const std::vector<double> state = stepped(specimen, 1, from.instant, from.F, F, from.point.state).state;
    const Point held = stepped(specimen, 1, from.instant, F, F, state);
    const Point seen = stepped(specimen, 1, from.instant, F, Q * F, state);
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
      all[v].exactly = miss < rounding;
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
  const auto found = [&]() -> std::optional<TurnedStep> {
    const Loaded from = loaded(specimen, s);
    TurnedStep step;
    step.carried = carried_variables(specimen, from, s);
    read_back(specimen, from, s, step);
    return step;
  };
  return if_taken(found, std::nullopt);
}

namespace {

Suspicion of_variable(const TurnedVariable& variable, Turned how) {
  const std::string name = variable.is_stress ? "the stress" : "'" + variable.name + "' of the state";
  switch (how) {
    case Turned::in_another_order:
      return {cause_of(variable.order), "when the body turns, " + misplaced(variable.order, name)};
    case Turned::with_shear_factor:
      return {causes::shear_factor, "the shear components of " + name + " are doubled or halved when it is turned"};
    case Turned::not_at_all:
      return {variable.is_stress ? causes::rotation_missing : causes::state_not_rotated,
              name + " does not rotate with the body, although the next step uses it as a tensor"};
    default:
      return {causes::wrong_spin,
              name + " rotates by " + rounded(variable.times) + " times the angle of the body's rotation"};
  }
}

/// Beside a stress that turns rightly, something that turns in no way that has a name.
std::optional<Suspicion> what_is_left(const TurnedStep& step) {
  bool stress_is_right = false;
  const TurnedVariable* other = nullptr;
  for (const TurnedVariable& variable : step.carried) {
    if (variable.is_stress && variable.how == Turned::rightly) stress_is_right = true;
    if (!variable.is_stress && variable.how == Turned::otherwise) other = &variable;
  }
  if (!stress_is_right || !other) return std::nullopt;
  return Suspicion{causes::state_not_rotated,
                   "the stress turns with the body, but '" + other->name + "' of the state does not"};
}

/// How a variable is treated that is wrong, its order told; nothing of one that is right, or turns in a way that has no
/// name.
std::optional<Turned> wrong_way(const Facts& f, const TurnedStep& step, TurnedVariable& variable) {
  const auto same = [&](const TurnedVariable& other) { return other.name == variable.name; };
  const auto taken = std::find_if(step.taken.begin(), step.taken.end(), same);
  const Turned declared = variable.is_own ? Turned::not_at_all : Turned::rightly;
  const Turned as = taken == step.taken.end() ? declared : taken->how;
  const bool own_frame = as == Turned::not_at_all, misread = as != Turned::rightly && !own_frame;
  const Turned how = misread ? as : variable.how;
  if (misread) variable.order = step.order;
  const bool of_spin = !f.failed(ids::constant_rotation) || f.evidence.right_without_spin;
  if (how == Turned::by_another_angle && !of_spin && !variable.exactly) return std::nullopt;
  if (how == Turned::rightly || how == Turned::otherwise || (own_frame && how == Turned::not_at_all)) {
    return std::nullopt;
  }
  return how;
}

bool any_turn_fails(const Facts& f) {
  return f.any_failure([](const TestResult& test) {
    const bool of_rotation = test.id.starts_with("rotation.") && test.id != ids::rotation_of_state;
    return of_rotation || test.id == ids::basis || test.id == ids::turning_stretches;
  });
}

}  // namespace

std::optional<Suspicion> said_by_turned_step(const Facts& f) {
  if (!any_turn_fails(f) || !f.evidence.turned) return std::nullopt;
  const TurnedStep& step = *f.evidence.turned;
  if (step.stress != Turned::rightly) return of_variable({.is_stress = true, .order = step.order}, step.stress);
  std::optional<Suspicion> found;
  double farthest = -1;
  for (TurnedVariable variable : step.carried) {
    const std::optional<Turned> how = wrong_way(f, step, variable);
    const double far = variable.is_stress ? INFINITY : std::abs(variable.times - 1);
    if (!how || far <= farthest) continue;
    farthest = far;
    found = of_variable(variable, *how);
  }
  // A state that stays behind does not show in a frame that is turned once for all, nor less in smaller steps.
  const bool other = f.failed(ids::constant_rotation) || f.evidence.fixed.result.order;
  return found || other ? found : what_is_left(step);
}

}  // namespace assay::check
