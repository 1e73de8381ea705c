// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "harness/check/loading.hpp"
#include "harness/check/rigid_turn.hpp"
#include "harness/check/share_along.hpp"
#include "harness/check/shear_order.hpp"
#include "harness/check/state_variable.hpp"
#include "harness/numeric/stable_norm.hpp"

namespace assay::check {

namespace {

constexpr double largest_multiple = 2.5;  ///< of the body's angle by which a stress is turned
constexpr double spins_alike = 2e-2;      ///< relative: stress turned by a multiple of the angle, and stress found

using AngleOf = std::function<double(double)>;

double ramp(double from, double to, double t) { return std::clamp((t - from) / (to - from), 0.0, 1.0); }

Loading turning(const Space& space, const Loading& loading, const AngleOf& angle_at) {
  return {[=](double t) { return Tensor(space.turn(angle_at(t)) * loading.F(t)); }, loading.phases};
}

/// The largest over the phases' ends, relative to the largest stress of the history at rest.
double error_between(const Specimen& specimen, const March& still, const March& seen, const AngleOf& angle_at) {
  double error = 0;
  for (std::size_t k = 0; k < still.marks.size(); ++k) {
    const Tensor Q = specimen.space.turn(angle_at(static_cast<double>(k) + 1));
    error = std::max(error, distance(rotated(Q.transpose(), seen.marks[k].cauchy), still.marks[k].cauchy));
  }
  return error / std::max(still.largest, specimen.least_stress());
}

struct Twins {
  March still, seen;
};

Twins march_twins(const Specimen& specimen, const Loading& loading, const AngleOf& angle_at, int steps,
                  double phase_length = 1) {
  MarchOptions options{.steps = steps, .phase_length = phase_length, .state = specimen.rest_state()};
  Twins twins;
  twins.still = march(*specimen.material, loading, options);
  twins.seen = march(*specimen.material, turning(specimen.space, loading, angle_at), options);
  return twins;
}

/// By how many times `turning_angle` about (1, 2, 3) `found` is turned from `unturned`; null where by none.
std::optional<double> turned_by(const Space& space, const Tensor& found, const Tensor& unturned) {
  const double scale = unturned.cwiseAbs().maxCoeff();
  const auto miss = [&](double k) { return distance(rotated(space.turn(k * turning_angle), unturned), found) / scale; };
  constexpr double step = 0.01;
  double best = 0;
  for (double k = -largest_multiple; k <= largest_multiple; k += step) {
    if (miss(k) < miss(best)) best = k;
  }
  return miss(best) < spins_alike ? std::optional(best) : std::nullopt;
}

/// By how many times its angle a small turn of a loaded body turns the stress; null where it does something else, too.
std::optional<double> spin_of(const Specimen& specimen, const Tensor& F, const Point& loaded) {
  constexpr double angle = 1e-3;
  const Material& material = *specimen.material;
  const double length = specimen.rate_dependent() ? 1e-9 : 1.0 / specimen.steps();
  const Tensor Q = specimen.space.turn(angle);
  const auto stress = [&](const Tensor& F1) { return stepped(material, 1, length, F, F1, loaded.state).cauchy; };
  const Tensor held = stress(F), change = stress(Q * F) - held, whole = rotated(Q, held) - held;
  const double share = share_along(change, whole);
  const bool turns = distance(change, share * whole) < spins_alike * change.cwiseAbs().maxCoeff();
  return turns && std::abs(share) <= largest_multiple ? std::optional(share) : std::nullopt;
}

/// Equal stretches, and a little shear on top: where a yield surface has an apex, the stress may be there.
Tensor expanded(const Space& space, double amplitude, double expansion, double shear) {
  Tensor A;
  A << 0.3, 0.2, -0.1, 0.2, -0.2, 0.3, -0.1, 0.3, -0.1;
  return space.within(Tensor::Identity() + amplitude * (expansion * Tensor::Identity() + 0.05 * shear * A));
}

struct Case {
  const char* id;
  const char* words;
  Loading loading;
  AngleOf angle_at;
};

Case case_of(const Specimen& specimen, When when) {
  const double a = specimen.amplitude;
  const Space space = specimen.space;
  switch (when) {
    case When::before:
      return {"rotation.before",
              "a body that turns before it is loaded",
              {[a, space = specimen.space](double t) { return space.stretch(a, 0.5 * std::max(0.0, t - 1)); }, 3},
              [](double t) { return turning_angle * ramp(0, 1, t); }};
    case When::during:
      return {"rotation.during", "a body that turns while it is loaded", out_and_back(specimen),
              [](double t) { return turning_angle * ramp(0, 2, t); }};
    case When::apex:
      return {"rotation.apex",
              "a body that is expanded, then sheared while it turns",
              {[=](double t) { return expanded(space, a, std::min(t, 1.0), std::max(0.0, t - 1)); }, 2},
              [](double t) { return turning_angle * ramp(1, 2, t); }};
    case When::after:
      break;
  }
  return {
      "rotation.after",
      "a body that turns between two loads",
      {[a, space = specimen.space](double t) { return space.stretch(a, 0.5 * (ramp(0, 1, t) + ramp(2, 3, t))); }, 3},
      [](double t) { return turning_angle * ramp(1, 2, t); }};
}

}  // namespace

TestResult rotation_at_apex(const Specimen& specimen) {
  constexpr double least = 1e-6;
  for (Specimen weaker = specimen; weaker.amplitude > least; weaker.amplitude *= 0.5) {
    const Loading still = case_of(weaker, When::apex).loading;
    try {
      march(*specimen.material, still, {.steps = specimen.steps(), .state = specimen.rest_state()});
    } catch (const MaterialFailure& failure) {
      if (failure.not_finite) return refused("rotation.apex", nullptr, failure);
      continue;  // torn apart, as it may be
    }
    TestResult result = rotation(weaker, When::apex);
    if (result.verdict == Verdict::fail) result.cause = causes::repeated_stretch;
    return result;
  }
  return {.id = "rotation.apex",
          .verdict = Verdict::not_applicable,
          .sentence = "the material does not stand an expansion followed by shear"};
}

namespace {

/// In phases of that length [s].
TestResult rotation_within(const Specimen& specimen, const Case& c, double phase_length) {
  std::array<double, 3> errors{};
  Twins twins;
  for (int k = 0; k < 3; ++k) {
    twins = march_twins(specimen, c.loading, c.angle_at, specimen.steps() << k, phase_length);
    errors[static_cast<std::size_t>(k)] = error_between(specimen, twins.still, twins.seen, c.angle_at);
  }
  const Limit limit = limit_of(errors);
  TestResult result{.id = c.id, .measure = limit.value, .threshold = converging_limit, .order = limit.order};
  result.verdict = limit.passes() ? Verdict::pass : Verdict::fail;
  result.sentence = std::string(c.words) + ": " + how(limit, errors, specimen.steps());
  result.step = twins.seen.last;
  return result;
}

/// In which the stiffest of the parts relaxes that are gone within 1 s [s]; null where there is none.
std::optional<double> time_of_fast_relaxation(const Specimen& specimen) {
  const RelaxingPart* stiffest = nullptr;
  const auto stiffness = [](const RelaxingPart& part) { return part.stiffness.cwiseAbs().maxCoeff(); };
  for (const RelaxingPart& part : specimen.parts) {
    if (part.longer <= 1 && (!stiffest || stiffness(part) > stiffness(*stiffest))) stiffest = &part;
  }
  return stiffest ? std::optional(std::sqrt(stiffest->brief * stiffest->longer)) : std::nullopt;
}

}  // namespace

TestResult rotation(const Specimen& specimen, When when) {
  const Case c = case_of(specimen, when);
  TestResult usual = rotation_within(specimen, c, 1);
  const std::optional<double> brief = time_of_fast_relaxation(specimen);
  if (usual.verdict == Verdict::fail || when != When::during || !brief) return usual;
  TestResult fast = rotation_within(specimen, c, *brief);  // before its overstress is gone
  fast.sentence += ", in " + rounded(2 * *brief) + " s";
  return fast.verdict == Verdict::fail ? fast : usual;
}

RotationFinding rotation_at_fixed_stretch(const Specimen& specimen) {
  const double a = specimen.amplitude;
  const Loading loading{[a, space = specimen.space](double t) { return space.stretch(a, 0.5 * std::min(t, 1.0)); }, 2};
  const AngleOf angle_at = [](double t) { return turning_angle * ramp(1, 2, t); };
  const int steps = specimen.steps() / 4;
  RigidTurn turned;
  Twins twins;
  for (int k = 0; k < 3; ++k) {
    twins = march_twins(specimen, loading, angle_at, steps << k);
    const double scale = std::max(twins.still.largest, specimen.least_stress());
    for (const std::size_t phase : {0u, 1u}) {
      const Tensor Q = specimen.space.turn(angle_at(static_cast<double>(phase) + 1));
      turned.note(k, twins.seen.marks[phase].cauchy, rotated(Q, twins.still.marks[phase].cauchy), scale);
    }
  }
  RotationFinding finding{turned.judged("rotation.fixed_stretch", "a stretched body that turns", steps)};
  finding.result.step = twins.seen.last;
  if (!turned.exact()) {
    finding.turned = turned_by(specimen.space, twins.seen.marks[1].cauchy, twins.still.marks[1].cauchy);
    finding.spin = spin_of(specimen, loading.F(1), twins.still.marks[0]);
  }
  return finding;
}

TestResult revolutions(const Specimen& specimen) {
  constexpr int steps = 16;
  const int turns = specimen.options.effort.quick ? 10 : 50;
  const double a = specimen.amplitude;
  const Loading loading{[a, space = specimen.space](double t) { return space.stretch(a, 0.5 * std::min(t, 1.0)); },
                        1 + turns};
  const AngleOf angle_at = [](double t) { return 2 * std::numbers::pi * std::max(0.0, t - 1); };
  const Twins twins = march_twins(specimen, loading, angle_at, steps);
  const double still = stable_norm(twins.still.marks.back().cauchy), seen = stable_norm(twins.seen.marks.back().cauchy);
  const auto growth_of = [&](double now, double before) {
    return std::abs(now - before) / std::max({before, 1e-6 * twins.still.largest, specimen.least_stress()});
  };
  std::size_t where = 0;  // within revolutions
  double between = 0;
  for (std::size_t k = 0; k < twins.seen.sizes.size(); ++k) {
    const double growth = growth_of(twins.seen.sizes[k], twins.still.sizes[k]);
    if (!(growth <= between)) between = growth, where = k + 1;
  }
  const double growth = growth_of(seen, still);
  constexpr double most = 1e-3;  // 800 steps in single precision
  TestResult result{.id = "rotation.revolutions", .measure = between, .threshold = most, .step = twins.seen.last};
  result.verdict = between <= most ? Verdict::pass : Verdict::fail;
  // What relaxes may have lost in the end what its steps have added.
  const bool of_angle = growth <= most && specimen.material->path_independent();
  if (between > most) result.cause = of_angle ? causes::not_indifferent : causes::explicit_spin;
  result.sentence =
      std::to_string(turns) + " revolutions of a stretched body in steps of 22.5 degrees: the stress " +
      (growth > most    ? "is " + rounded(seen / still) + " times what it was"
       : between > most ? "is off by " + rounded(between) + " at " +
                              std::to_string(std::lround(360.0 / steps * static_cast<double>(where % steps))) +
                              " degrees, and right after whole revolutions"
                        : "keeps its size, to " + rounded(between));
  return result;
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
  const double a = specimen.amplitude;
  const Loading loading{[a, space = specimen.space](double t) { return space.stretch(a, 0.5 * std::min(t, 1.0)); }, 2};
  const Twins twins = march_twins(
      specimen, loading, [](double t) { return turning_angle * ramp(1, 2, t); }, specimen.steps());
  RotationFinding finding{{.id = "rotation.state"}};
  const assay_material& table = specimen.material->table();
  double worst = 0;
  std::string which;
  std::optional<ShearOrder> order;
  std::size_t at = 0;
  bool any = false, symmetric = false;
  for (std::uint32_t v = 0; v < table.state_count; ++v) {
    const int size = components_of_kind(table.state[v].kind);
    const auto value = [&](const March& m, std::size_t mark) {
      return Variable(table.state[v].kind, &m.marks[mark].state[at]);
    };
    const Variable loaded = value(twins.still, 0), still = value(twins.still, 1), seen = value(twins.seen, 1),
                   turned = still.turned(specimen.space.turn(turning_angle));
    at += static_cast<std::size_t>(size);
    const double scale = still.largest();
    if (size == 1 || !(scale > faded * loaded.largest())) continue;  // what has relaxed is rounding
    if (still.distance(turned) < same * scale) continue;             // a sphere says nothing
    any = true;
    const double off = seen.distance(turned) / scale;
    if (table.state[v].role == ASSAY_ROLE_PLAIN && !(off <= worst)) {
      worst = off, which = table.state[v].name, symmetric = table.state[v].kind == ASSAY_SYMMETRIC_TENSOR;
      order = order_in_turn(specimen.space.turn(turning_angle), still, seen, same * scale);
    }
    if (table.state[v].role == ASSAY_ROLE_PLAIN && seen.distance(still) < same * scale) {
      finding.left_behind += (finding.left_behind.empty() ? "" : ", ") + std::string(table.state[v].name);
    }
  }
  if (!any) {
    finding.result.verdict = Verdict::not_applicable;
    finding.result.sentence = "the state has no tensor or vector that could turn";
    return finding;
  }
  finding.result.measure = worst;
  finding.result.threshold = most;
  finding.result.step = twins.seen.last;
  finding.result.sentence = "tensors of the state turn with the body, or are declared to turn by themselves";
  if (worst <= most) return finding;
  const Declarations& declared = specimen.options.declarations;
  finding.result.sentence =
      "'" + which + "' of the state does not rotate with the body" +
      (declared.guesses_roles ? "" : ", although its role says so: a host that rotates it makes it wrong") +
      ". This is a defect, unless the tensor has axes of its own. To declare such axes, give " + declared.own_axes +
      (symmetric ? ". A symmetric tensor has its components in the order 11 22 33 12 13 23, none of them doubled" : "");
  if (order) finding.result.sentence = misplaced(*order, "'" + which + "' of the state");
  if (declared.guesses_roles) return finding;
  finding.result.verdict = Verdict::fail;
  finding.result.cause = causes::wrong_role;
  return finding;
}

}  // namespace assay::check
