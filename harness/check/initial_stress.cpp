// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/initial_stress.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "harness/check/rigid_turn.hpp"
#include "harness/check/share_along.hpp"
#include "harness/check/shear_order.hpp"
#include "harness/check/state_variable.hpp"

namespace assay::check {

namespace {

std::vector<double> state_under(const Material& material, const Tensor& sigma) {
  std::vector<double> nine(9);
  for (int c = 0; c < 9; ++c) nine[static_cast<std::size_t>(c)] = component(sigma, c);
  return material.initial_state(1, nine);
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
  const Material& material = *specimen.material;
  const Tensor I = Tensor::Identity(), deviation = sigma + specimen.pressure * I;
  const bool acts_in_time = specimen.rate_dependent() || material.has(ASSAY_GROWS);
  const double length = acts_in_time ? 1e-9 : 1, scale = deviation.cwiseAbs().maxCoeff();
  const std::vector<double> state = state_under(material, sigma);
  const Tensor found = stepped(material, 0, length, I, I, state).cauchy;
  Carried result{
      distance(found, sigma) / scale, {}, distance(found, -specimen.pressure * I) < own_precision * scale, {}, sigma};
  for (const ShearOrder& order : other_orders) {
    const bool comes_back = distance(found, in_order(order, sigma)) < own_precision * scale;
    if (comes_back && !result.order && !specimen.space.is_plane()) result.order = order;
  }
  const Loading turning{[&](double t) { return specimen.space.turn(turning_angle * t); }, 1};
  const double least = 1e-2 * specimen.modulus;  // single precision leaves 1e-7 of the modulus in each step of a turn
  for (int k = 0; k < 3; ++k) {
    const int steps = (specimen.steps() / 4) << k;
    const March seen = march(material, turning, {.steps = steps, .phase_length = length, .state = state});
    result.turned.note(k, seen.marks[0].cauchy, rotated(specimen.space.turn(turning_angle), found),
                       std::max(scale, least));
  }
  return result;
}

/// Whether the stress of a step, however long, is that written into a tensor of the state, in whatever unit.
bool carries(const Specimen& specimen, const Variable& stored, std::size_t at, const Tensor& stress) {
  const Tensor I = Tensor::Identity(), pressure = specimen.pressure * I;
  const double length = specimen.rate_dependent() ? 1e6 : 1;
  for (const double unit : {1.0, 1e-3, 1e-6, 1e-9}) {
    std::vector<double> state = specimen.rest_state();
    stored.with(stored.value() + unit * stress).write(&state[at]);
    try {
      const Tensor found = stepped(*specimen.material, 0, length, I, I, state).cauchy + pressure;
      const double share = share_along(found, stress);
      if (share > 0 && distance(found, share * stress) < own_precision * found.cwiseAbs().maxCoeff()) return true;
    } catch (const MaterialFailure&) {  // it is not the stress
    }
  }
  return false;
}

/// Name of a tensor of the state that carries a stress; empty where there is none.
std::string carrier(const Specimen& specimen, const Tensor& stress) {
  const std::vector<double> rest = specimen.rest_state();
  const assay_material& table = specimen.material->table();
  std::size_t at = 0;
  for (std::uint32_t v = 0; v < table.state_count; ++v) {
    const Variable stored(table.state[v].kind, &rest[at]);
    if (stored.is_tensor() && carries(specimen, stored, at, stress)) return table.state[v].name;
    at += static_cast<std::size_t>(components_of_kind(table.state[v].kind));
  }
  return {};
}

/// A model that takes no notice of an initial stress.
TestResult ignored_stress(const Specimen& specimen, const Tensor& sigma) {
  TestResult result{.id = "initial_stress", .verdict = Verdict::fail, .cause = causes::initial_stress};
  result.measure = 1;
  result.threshold = own_precision;
  const std::string name = carrier(specimen, sigma + specimen.pressure * Tensor::Identity());
  if (!name.empty()) {
    result.sentence = "initial_state ignores an initial stress that '" + name + "' of the state could carry";
  } else if (specimen.options.declarations.may_drop_stress) {
    result = {.id = "initial_stress", .verdict = Verdict::not_applicable};
    result.sentence = "the model ignores an initial stress";
  } else {
    result.sentence = "initial_state accepts an initial stress and ignores it: return ASSAY_FAILED to refuse one";
  }
  return result;
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

TestResult initial_stress(const Specimen& specimen) {
  TestResult result{.id = "initial_stress", .verdict = Verdict::not_applicable};
  result.sentence = "the model accepts no initial stress";
  if (specimen.material->state_size() == 0) return result;
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
  if (!taken) return result;
  if (best.ignored) return ignored_stress(specimen, best.tried);
  result = best.turned.judged("initial_stress", "an initial stress, in a body that turns", specimen.steps() / 4);
  if (best.still > own_precision) {
    result.verdict = Verdict::fail;
    result.measure = best.still;
    result.threshold = own_precision;
    result.sentence = best.order
                          ? "after a step without deformation " + misplaced(*best.order, "an initial stress")
                          : "a step without deformation changes an initial stress by " + rounded(best.still) + " of it";
  }
  if (result.verdict == Verdict::fail) result.cause = best.order ? cause_of(*best.order) : causes::initial_stress;
  return result;
}

}  // namespace assay::check
