// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/turned_step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "harness/check/judge.hpp"
#include "harness/check/share_along.hpp"
#include "harness/check/state_variable.hpp"

namespace assay::check {

namespace {

constexpr double large_turn = turning_angle, small_turn = 0.02;  ///< [rad]
constexpr double alike = 0.2 * small_turn;  ///< of the largest component: a step may be second order in the turn
constexpr double explained = 1e-3;          ///< of an error that an assumption leaves
constexpr double trifle = 1e-10;
constexpr double rounding = 1e-9;  ///< of the largest component

/// A tensor or vector of the state that has to turn, or a tensor that is declared to turn by itself.
struct StatePlace {
  std::string name;
  std::int32_t kind;
  std::size_t at;
  bool is_own;  ///< declared to turn by itself

  Variable in(const std::vector<double>& state) const { return {kind, &state[at]}; }
};

std::vector<StatePlace> places_of(const Material& material) {
  const assay_material& table = material.table();
  std::vector<StatePlace> places;
  std::size_t at = 0;
  for (std::uint32_t v = 0; v < table.state_count; ++v) {
    const assay_state_variable& variable = table.state[v];
    const bool is_tensor = variable.kind == ASSAY_TENSOR || variable.kind == ASSAY_SYMMETRIC_TENSOR;
    const bool is_own = variable.role == ASSAY_ROLE_ROTATES_ITSELF && is_tensor;
    if (is_own || (variable.kind != ASSAY_SCALAR && variable.role == ASSAY_ROLE_PLAIN)) {
      places.push_back({variable.name, variable.kind, at, is_own});
    }
    at += static_cast<std::size_t>(components_of_kind(variable.kind));
  }
  return places;
}

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
};

std::vector<Fate> fates_of(const Space& space, const Variable& before) {
  const Tensor Q = space.turn(small_turn);
  const Variable right = before.turned(Q);
  std::vector<Fate> fates{{Turned::rightly, 1, right}, {Turned::not_at_all, 0, before}};
  if (before.is_tensor() && !space.is_plane()) {
    for (const Variable& each : {right, before}) {
      fates.push_back({Turned::with_13_and_23_exchanged, 1, each.with(exchanged(each.value()))});
    }
    const Variable misread = before.with(exchanged(before.value())).turned(Q);
    fates.push_back({Turned::with_13_and_23_exchanged, 1, misread.with(exchanged(misread.value()))});
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
    best.first.exactly = miss < rounding;
    best.second = miss;
  }
  return best;
}

bool proportional(const Tensor& a, const Tensor& b) {
  const double share = share_along(a, b);
  return std::isfinite(share) && distance(a, share * b) < 1e-3 * a.cwiseAbs().maxCoeff();
}

/// A loaded point, and the lengths of its steps [s].
struct Loaded {
  Tensor F;
  Point point;
  double length, instant;
};

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
  place.in(other).turned(specimen.space.turn(large_turn)).write(&other[place.at]);
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

/// What components of the state or of the stress are taken for; the first two are no defect. `exchanged` is nothing in
/// the plane.
enum class As { tensor, own_frame, exchanged, half_shear, double_shear, count };

Tensor read_as(As as, const Tensor& A) {
  return as == As::exchanged      ? exchanged(A)
         : as == As::half_shear   ? sheared(A, 0.5)
         : as == As::double_shear ? sheared(A, 2)
                                  : A;
}

Tensor written_as(As as, const Tensor& A) {
  return as == As::exchanged      ? exchanged(A)
         : as == As::half_shear   ? sheared(A, 2)
         : as == As::double_shear ? sheared(A, 0.5)
                                  : A;
}

Turned defect_of(As as) {
  return as == As::tensor      ? Turned::rightly
         : as == As::own_frame ? Turned::not_at_all
         : as == As::exchanged ? Turned::with_13_and_23_exchanged
                               : Turned::with_shear_factor;
}

/// One loading step from a state and from the same state turned.
class Assumptions {
 public:
  Assumptions(const Specimen& specimen, const Loaded& from, double s)
      : material_(*specimen.material), space_(specimen.space), from_(from), places_(places_of(material_)) {
    constexpr double further = 0.02;
    F1_ = space_.stretch(specimen.amplitude, s + further);
    expected_ = step(from.F, F1_, from.point.state).cauchy;
    scale_ = std::max(expected_.cwiseAbs().maxCoeff(), specimen.least_stress());
    places_.resize(std::min(places_.size(), most_));
  }

  bool can_be(As as) const { return as != As::exchanged || !space_.is_plane(); }

  /// Of the stress, if each variable is what it is assumed to be, and so is the stress.
  double error(const std::vector<As>& variables, As output) const {
    const Tensor Q = space_.turn(large_turn);
    std::vector<double> state = from_.point.state;
    for (std::size_t v = 0; v < places_.size(); ++v) {
      if (variables[v] == As::own_frame) continue;
      const Variable stored = places_[v].in(state);
      const Variable meant = stored.is_tensor() ? stored.with(read_as(variables[v], stored.value())) : stored;
      const Variable turned = meant.turned(Q);
      (stored.is_tensor() ? turned.with(written_as(variables[v], turned.value())) : turned)
          .write(&state[places_[v].at]);
    }
    const Tensor seen = step(Q * from_.F, Q * F1_, state).cauchy;
    return distance(rotated(Q.transpose(), read_as(output, seen)), read_as(output, expected_)) / scale_;
  }

  const std::vector<StatePlace>& places() const { return places_; }

  /// What the variables are declared to be.
  std::vector<As> declared() const {
    std::vector<As> all;
    for (const StatePlace& place : places_) all.push_back(place.is_own ? As::own_frame : As::tensor);
    return all;
  }

 private:
  static constexpr std::size_t most_ = 4;  ///< variables, each with five assumptions

  Point step(const Tensor& F0, const Tensor& F1, const std::vector<double>& state) const {
    return stepped(material_, 1, from_.length, F0, F1, state);
  }

  const Material& material_;
  Space space_;
  const Loaded& from_;
  std::vector<StatePlace> places_;
  Tensor F1_, expected_;
  double scale_;
};

/// The least unlikely assumptions that explain the error.
void explain(const Assumptions& assumptions, TurnedStep& found) {
  const std::vector<As> declared = assumptions.declared();
  const std::size_t count = declared.size();
  const auto kinds = static_cast<std::size_t>(As::count);
  std::size_t all = 1;
  for (std::size_t v = 0; v < count; ++v) all *= kinds;
  double least_cost = INFINITY;
  for (std::size_t code = 0; code < all; ++code) {
    std::vector<As> variables(count);
    double cost = 0;
    for (std::size_t v = 0, rest = code; v < count; ++v, rest /= kinds) {
      variables[v] = static_cast<As>(rest % kinds);
      const bool likely = variables[v] == As::tensor || variables[v] == As::own_frame;
      const double of_this = variables[v] == declared[v] ? 0 : likely ? 1 : 2;
      cost += assumptions.can_be(variables[v]) ? of_this : INFINITY;
    }
    for (const As output : {As::tensor, As::exchanged, As::half_shear, As::double_shear}) {
      const double with_output = cost + (output == As::tensor ? 0 : 1.5);
      if (!assumptions.can_be(output) || with_output >= least_cost ||
          assumptions.error(variables, output) > explained * found.error)
        continue;
      least_cost = with_output;
      found.stress = defect_of(output);
      found.taken.clear();
      for (std::size_t v = 0; v < count; ++v) {
        found.taken.push_back({.name = assumptions.places()[v].name, .how = defect_of(variables[v])});
      }
    }
  }
}

}  // namespace

std::optional<TurnedStep> turned_step(const Specimen& specimen) {
  constexpr double s = 0.2;  // of the loading, on its way out
  try {
    const Loaded from = loaded(specimen, s);
    TurnedStep found;
    found.carried = carried_variables(specimen, from, s);
    const Assumptions assumptions(specimen, from, s);
    const std::vector<As> declared = assumptions.declared();
    found.error = assumptions.error(declared, As::tensor);
    for (std::size_t v = 0; v < declared.size(); ++v) {
      found.taken.push_back({.name = assumptions.places()[v].name, .how = defect_of(declared[v])});
    }
    if (found.error > own_precision) explain(assumptions, found);
    return found;
  } catch (const MaterialFailure&) {
    return std::nullopt;
  }
}

}  // namespace assay::check
