// SPDX-License-Identifier: BSD-3-Clause
// What a rotation does to a body at rest, to one under an initial stress, and to the state of one that is stretched.
#include <algorithm>
#include <cmath>

#include "harness/check/frame_twins.hpp"
#include "harness/check/stiffness.hpp"
#include "harness/check/tests.hpp"
#include "harness/material/state_variable.hpp"

namespace assay::check {

namespace {

/// A turn by a small angle, its square half a strain at which most materials are elastic.
Tensor little_turn(const Space& space, double t) { return space.turn(3e-3 * t); }
Tensor strain_of_little_turn(const Space& space, double t) {
  return 0.5 * (little_turn(space, t) + little_turn(space, t).transpose());
}

/// Above that of rest, at the end of a loading of so many seconds.
Tensor stress_after(const Specimen& specimen, Tensor (*F)(const Space&, double), double length) {
  const Loading loading{[&](double t) { return F(specimen.space, t); }, 1};
  const Tensor found = from_rest(specimen, loading, specimen.steps(), length).marks[0].cauchy;
  return found + specimen.rest_pressure() * Tensor::Identity();
}

/// The stress of a turn Q, as a multiple of that of the strain sym(Q - I). 0 where the stress is of another kind: a
/// body may swell in time.
double small_strain_share(const Specimen& specimen) {
  constexpr double alike = 0.2;
  const Tensor mistaken = stress_of(specimen.stiffness, little_turn(specimen.space, 1) - Tensor::Identity());
  const Tensor found = stress_after(specimen, little_turn, 1);
  const double share = share_along(found, mistaken);
  return distance(found, share * mistaken) < alike * size_of(found) ? share : 0;
}

/// The same after ages, when overstresses, which may know no mistake, are gone.
double relaxed_small_strain_share(const Specimen& specimen) {
  constexpr double ages = 1e6;  // [s]
  const auto share = [&] {
    return share_along(stress_after(specimen, little_turn, ages), stress_after(specimen, strain_of_little_turn, ages));
  };
  return if_taken(share, INFINITY);
}

/// The same of each part that relaxes, in one step: the nearest to 1. Viscous stress of sym(F1 - F0)/dt is such a part.
double relaxing_small_strain_share(const Specimen& specimen) {
  const Tensor Q = little_turn(specimen.space, 1);
  double nearest = 0;
  for (const RelaxingPart& part : specimen.parts) {
    if (std::isinf(part.longer)) continue;
    const Tensor found = stress_at_once(specimen, Q, part.brief) - stress_at_once(specimen, Q, part.longer);
    const Tensor mistaken = stress_of(part.stiffness, Q - Tensor::Identity());
    const double share = share_along(found, mistaken);
    const bool alike = distance(found, mistaken) < 0.1 * size_of(mistaken);
    if (alike && std::abs(share - 1) < std::abs(nearest - 1)) nearest = share;
  }
  return nearest;
}

}  // namespace

RotationFinding rotation_at_rest(const Specimen& specimen) {
  const Loading turning{turning_between(specimen.space, 0, 1), 1};
  double finest = 0;
  FailedStep last;
  const Errors errors = at_halved_steps(specimen.steps(), [&](int steps) {
    const March found = from_rest(specimen, turning, steps);
    last = found.last;
    finest = distance(found.marks[0].cauchy, -specimen.rest_pressure() * Tensor::Identity()) / specimen.modulus;
    return finest;
  });
  RotationFinding finding{judged(errors, "", specimen.steps())};
  finding.result.step = last;
  finding.result.sentence = "stress of a body that rotates without load, relative to the modulus: " + rounded(finest);
  finding.small_strain = small_strain_share(specimen);
  if (finding.result.verdict == Verdict::fail && specimen.rate_dependent()) {
    const double later = relaxed_small_strain_share(specimen);
    if (std::abs(later - 1) < std::abs(finding.small_strain - 1)) finding.small_strain = later;
  }
  finding.relaxing_small_strain = relaxing_small_strain_share(specimen);
  return finding;
}

namespace {

/// The order in which the shears of a tensor lie that turns with the body so alone.
std::optional<ShearOrder> order_in_turn(const Tensor& Q, const Variable& still, const Variable& seen, double within) {
  const auto fits = [&](const ShearOrder& order) {
    const Variable meant = still.with(in_order(reversed(order), still.value())).turned(Q);
    return seen.distance(meant.with(in_order(order, meant.value()))) < within;
  };
  const auto found = std::find_if(other_orders.begin(), other_orders.end(), fits);
  return still.is_tensor() && found != other_orders.end() ? std::optional(*found) : std::nullopt;
}

}  // namespace

RotationFinding rotation_of_state(const Specimen& specimen) {
  constexpr double same = 1e-3, faded = 1e-6, most = 1e-2;
  const Turn turn = turning_between(specimen.space, 1, 2);
  const Tensor Q = turn(2);
  const Twins twins = march_twins(specimen, stretched_and_held(specimen, 2), turn, specimen.steps());
  RotationFinding finding;
  double worst = 0;
  StatePlace which{};
  std::optional<ShearOrder> order;
  bool any = false;
  for (const StatePlace& place : state_of(specimen.material->table())) {
    const Variable loaded = place.in(twins.still.marks[0].state), still = place.in(twins.still.marks[1].state),
                   seen = place.in(twins.seen.marks[1].state), turned = still.turned(Q);
    const double scale = still.largest();
    if (place.size == 1 || !(scale > faded * loaded.largest())) continue;  // what has relaxed is rounding
    if (still.distance(turned) < same * scale) continue;                   // a sphere says nothing
    any = true;
    if (place.role != ASSAY_ROLE_PLAIN) continue;
    const double off = seen.distance(turned) / scale;
    if (!(off <= worst)) worst = off, which = place, order = order_in_turn(Q, still, seen, same * scale);
    if (seen.distance(still) < same * scale) {
      finding.left_behind += (finding.left_behind.empty() ? "" : ", ") + std::string(place.name);
    }
  }
  if (!any) {
    finding.result = left_out("the state has no tensor or vector that could turn");
    return finding;
  }
  finding.result =
      passed(worst, most, "tensors of the state turn with the body, or are declared to turn by themselves");
  finding.result.step = twins.seen.last;
  if (worst <= most) return finding;
  const Declarations& declared = specimen.options.declarations;
  const bool symmetric = which.kind == ASSAY_SYMMETRIC_TENSOR;
  const std::string name = "'" + std::string(which.name) + "' of the state";
  finding.result.sentence =
      name + " does not rotate with the body" +
      (declared.guesses_roles ? "" : ", although its role says so: a host that rotates it makes it wrong") +
      ". This is a defect, unless the tensor has axes of its own. To declare such axes, give " + declared.own_axes +
      (symmetric ? ". A symmetric tensor has its components in the order 11 22 33 12 13 23, none of them doubled" : "");
  if (order) finding.result.sentence = misplaced(*order, name);
  if (declared.guesses_roles) return finding;
  finding.result.verdict = Verdict::fail;
  finding.result.cause = causes::wrong_role;
  return finding;
}

namespace {

std::vector<double> state_under(const Material& material, const Tensor& sigma) {
  const std::array<double, 9> nine = nine_of(sigma);
  return material.initial_state(1, std::vector<double>(nine.begin(), nine.end()));
}

/// What is left of an initial stress in a step without deformation, and how it turns with the body.
struct Carried {
  double still = INFINITY;  ///< error, relative
  RigidTurn turned;
  bool ignored = true;                   ///< as if there were none
  std::optional<ShearOrder> order = {};  ///< in which its shears come back, where that is another one
  Tensor tried = Tensor::Zero();
};

Carried carried(const Specimen& specimen, const Tensor& sigma) {
  const Tensor I = Tensor::Identity(), deviation = sigma + specimen.pressure * I;
  const bool acts_in_time = specimen.rate_dependent() || specimen.material->has(ASSAY_GROWS);
  const double length = acts_in_time ? 1e-9 : 1, scale = size_of(deviation);
  const std::vector<double> state = state_under(specimen, sigma);
  const Tensor found = stepped(specimen, 0, length, I, I, state).cauchy;
  Carried result{
      distance(found, sigma) / scale, {}, distance(found, -specimen.pressure * I) < own_precision * scale, {}, sigma};
  for (const ShearOrder& order : other_orders) {
    const bool comes_back = distance(found, in_order(order, sigma)) < own_precision * scale;
    if (comes_back && !result.order && !specimen.space.is_plane()) result.order = order;
  }
  const Loading turning{turning_between(specimen.space, 0, 1), 1};
  const double least = 1e-2 * specimen.modulus;  // single precision leaves 1e-7 of the modulus in each step of a turn
  for (int k = 0; k < 3; ++k) {
    const int steps = (specimen.steps() / 4) << k;
    const March seen = march(specimen, turning, {.steps = steps, .phase_length = length, .state = state});
    result.turned.note(k, seen.marks[0].cauchy, rotated(specimen.space.turn(turning_angle), found),
                       std::max(scale, least));
  }
  return result;
}

/// Whether the stress of a step, however long, is that written into a tensor of the state, in whatever unit.
bool carries(const Specimen& specimen, const StatePlace& place, const Tensor& stress) {
  const Tensor I = Tensor::Identity(), pressure = specimen.pressure * I;
  const double length = specimen.rate_dependent() ? 1e6 : 1;
  for (const double unit : {1.0, 1e-3, 1e-6, 1e-9}) {
    std::vector<double> state = specimen.rest_state();
    const Variable stored = place.in(state);
    stored.with(stored.value() + unit * stress).write(&state[place.first]);
    const auto is_the_stress = [&] {
      const Tensor found = stepped(specimen, 0, length, I, I, state).cauchy + pressure;
      const double share = share_along(found, stress);
      return share > 0 && distance(found, share * stress) < own_precision * size_of(found);
    };
    if (if_taken(is_the_stress, false)) return true;
  }
  return false;
}

/// Name of a tensor of the state that carries a stress; empty where there is none.
std::string carrier(const Specimen& specimen, const Tensor& stress) {
  for (const StatePlace& place : state_of(specimen.material->table())) {
    if (place.is_tensor() && carries(specimen, place, stress)) return place.name;
  }
  return {};
}

/// A model that takes no notice of an initial stress.
TestResult ignored_stress(const Specimen& specimen, const Tensor& sigma) {
  const std::string name = carrier(specimen, sigma + specimen.pressure * Tensor::Identity());
  if (name.empty() && specimen.options.declarations.may_drop_stress) {
    return left_out("the model ignores an initial stress");
  }
  return failed(causes::initial_stress, 1, own_precision,
                name.empty()
                    ? "initial_state accepts an initial stress and ignores it: return ASSAY_FAILED to refuse one"
                    : "initial_state ignores an initial stress that '" + name + "' of the state could carry");
}

/// Stresses of several shapes and sizes: a material may yield under one, and cannot carry it then.
std::vector<Tensor> tried_stresses(const Specimen& specimen) {
  Tensor mixed, pressed, drawn;
  mixed << -1, 0.3, -0.2, 0.3, -0.6, 0.1, -0.2, 0.1, -0.8;
  pressed << -1, 0.04, -0.03, 0.04, -0.96, 0.02, -0.03, 0.02, -0.98;
  drawn << 1, 0.3, -0.2, 0.3, 0.6, 0.1, -0.2, 0.1, 0.8;
  std::vector<Tensor> all;
  for (const double share : {1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10}) {  // of the modulus
    for (const Tensor& shape : {mixed, pressed, drawn}) {
      all.push_back(share * specimen.modulus * specimen.space.within(shape) - specimen.pressure * Tensor::Identity());
    }
  }
  return all;
}

}  // namespace

/// initial_state takes a stress, or refuses it; a step without deformation returns it, and it turns with the body.
TestResult initial_stress(const Specimen& specimen) {
  TestResult none = left_out("the model accepts no initial stress");
  if (specimen.material->state_size() == 0) return none;
  Carried best;
  bool taken = false;
  for (const Tensor& sigma : tried_stresses(specimen)) {
    if (best.still <= own_precision) break;
    try {
      const Carried now = carried(specimen, sigma);
      taken = true;
      if (now.still < best.still) best = now;
    } catch (const std::runtime_error&) {  // refused, as it may be; a smaller one, perhaps
    }
  }
  if (!taken) return none;
  if (best.ignored) return ignored_stress(specimen, best.tried);
  TestResult result = best.turned.judged("an initial stress, in a body that turns", specimen.steps() / 4);
  const char* const cause = best.order ? cause_of(*best.order) : causes::initial_stress;
  if (result.verdict == Verdict::fail) result.cause = cause;
  if (best.still <= own_precision) return result;
  const std::optional<double> order = result.order;
  result =
      failed(cause, best.still, own_precision,
             best.order ? "after a step without deformation " + misplaced(*best.order, "an initial stress")
                        : "a step without deformation changes an initial stress by " + rounded(best.still) + " of it");
  result.order = order;
  return result;
}

}  // namespace assay::check
