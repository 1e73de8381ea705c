// SPDX-License-Identifier: BSD-3-Clause
// Frame indifference: a history and the same history seen from a frame that turns.
#include "harness/check/frame_twins.hpp"

#include <algorithm>
#include <cmath>

#include "harness/check/tests.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::check {

namespace {

constexpr double largest_multiple = 2.5;  ///< of the body's angle by which a stress is turned
constexpr double spins_alike = 2e-2;      ///< relative: stress turned by a multiple of the angle, and stress found

/// By how many times `turning_angle` about (1, 2, 3) `found` is turned from `unturned`; null where by none.
std::optional<double> turned_by(const Space& space, const Tensor& found, const Tensor& unturned) {
  const double scale = size_of(unturned);
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
  const double length = specimen.rate_dependent() ? 1e-9 : 1.0 / specimen.steps();
  const Tensor Q = specimen.space.turn(angle);
  const auto stress = [&](const Tensor& F1) { return stepped(specimen, 1, length, F, F1, loaded.state).cauchy; };
  const Tensor held = stress(F), change = stress(Q * F) - held, whole = rotated(Q, held) - held;
  const double share = share_along(change, whole);
  const bool turns = distance(change, share * whole) < spins_alike * size_of(change);
  return turns && std::abs(share) <= largest_multiple ? std::optional(share) : std::nullopt;
}

/// Equal stretches, and a little shear on top: where a yield surface has an apex, the stress may be there.
Tensor expanded(const Space& space, double amplitude, double expansion, double shear) {
  Tensor A;
  A << 0.3, 0.2, -0.1, 0.2, -0.2, 0.3, -0.1, 0.3, -0.1;
  return space.within(Tensor::Identity() + amplitude * (expansion * Tensor::Identity() + 0.05 * shear * A));
}

struct Case {
  const char* words;
  Loading loading;
  Turn Q;
};

Case case_of(const Specimen& specimen, When when) {
  const double a = specimen.amplitude;
  const Space space = specimen.space;
  switch (when) {
    case When::before:
      return {"a body that turns before it is loaded",
              {[=](double t) { return space.stretch(a, 0.5 * std::max(0.0, t - 1)); }, 3},
              turning_between(space, 0, 1)};
    case When::during:
      return {"a body that turns while it is loaded", out_and_back(specimen), turning_between(space, 0, 2)};
    case When::apex:
      return {"a body that is expanded, then sheared while it turns",
              {[=](double t) { return expanded(space, a, std::min(t, 1.0), std::max(0.0, t - 1)); }, 2},
              turning_between(space, 1, 2)};
    case When::after:
      break;
  }
  const auto phase = [](double from, double t) { return std::clamp(t - from, 0.0, 1.0); };
  return {"a body that turns between two loads",
          {[=](double t) { return space.stretch(a, 0.5 * (phase(0, t) + phase(2, t))); }, 3},
          turning_between(space, 1, 2)};
}

/// In phases of that length [s].
TestResult rotation_within(const Specimen& specimen, const Case& c, double phase_length) {
  FailedStep last;
  const Errors errors = at_halved_steps(specimen.steps(), [&](int steps) {
    const Twins twins = march_twins(specimen, c.loading, c.Q, steps, phase_length);
    last = twins.seen.last;
    return error_between(specimen, twins.still, twins.seen, c.Q);
  });
  TestResult result = judged(errors, c.words, specimen.steps());
  result.step = last;
  return result;
}

/// In which the stiffest of the parts relaxes that are gone within 1 s [s]; null where there is none.
std::optional<double> time_of_fast_relaxation(const Specimen& specimen) {
  const RelaxingPart* stiffest = nullptr;
  const auto stiffness = [](const RelaxingPart& part) { return size_of(part.stiffness); };
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

/// When::apex at an amplitude that the material stands, if there is one.
TestResult rotation_at_apex(const Specimen& specimen) {
  constexpr double least = 1e-6;
  for (Specimen weaker = specimen; weaker.amplitude > least; weaker.amplitude *= 0.5) {
    const Loading still = case_of(weaker, When::apex).loading;
    try {
      from_rest(specimen, still);
    } catch (const MaterialFailure& failure) {
      if (failure.not_finite) return refused(ids::rotation_at_apex, nullptr, failure);
      continue;  // torn apart, as it may be
    }
    TestResult result = rotation(weaker, When::apex);
    if (result.verdict == Verdict::fail) result.cause = causes::repeated_stretch;
    return result;
  }
  return left_out("the material does not stand an expansion followed by shear");
}

RotationFinding rotation_at_fixed_stretch(const Specimen& specimen) {
  const Loading loading = stretched_and_held(specimen, 2);
  const Turn Q = turning_between(specimen.space, 1, 2);
  const int steps = specimen.steps() / 4;
  RigidTurn turned;
  Twins twins;
  for (int k = 0; k < 3; ++k) {
    twins = march_twins(specimen, loading, Q, steps << k);
    for (const std::size_t phase : {0u, 1u}) {
      const Tensor expected = rotated(Q(static_cast<double>(phase) + 1), twins.still.marks[phase].cauchy);
      turned.note(k, twins.seen.marks[phase].cauchy, expected, specimen.scale(twins.still.largest));
    }
  }
  RotationFinding finding{turned.judged("a stretched body that turns", steps)};
  finding.result.step = twins.seen.last;
  if (!turned.exact()) {
    finding.turned = turned_by(specimen.space, twins.seen.marks[1].cauchy, twins.still.marks[1].cauchy);
    finding.spin = spin_of(specimen, loading.F(1), twins.still.marks[0]);
  }
  return finding;
}

/// Many revolutions at fixed stretch must not change the size of the stress.
TestResult revolutions(const Specimen& specimen) {
  constexpr int steps = 16;
  const int turns = specimen.options.effort.quick ? 10 : 50;
  const Turn Q = [&](double t) { return specimen.space.turn(2 * std::numbers::pi * std::max(0.0, t - 1)); };
  const Twins twins = march_twins(specimen, stretched_and_held(specimen, 1 + turns), Q, steps);
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
  // What relaxes may have lost in the end what its steps have added.
  const bool of_angle = growth <= most && specimen.material->path_independent();
  const std::string words =
      std::to_string(turns) + " revolutions of a stretched body in steps of 22.5 degrees: the stress ";
  TestResult result = judged(
      between, most, words + "keeps its size, to " + rounded(between),
      of_angle ? causes::not_indifferent : causes::explicit_spin,
      words + (growth > most ? "is " + rounded(seen / still) + " times what it was"
                             : "is off by " + rounded(between) + " at " +
                                   std::to_string(std::lround(360.0 / steps * static_cast<double>(where % steps))) +
                                   " degrees, and right after whole revolutions"));
  result.step = twins.seen.last;
  return result;
}

}  // namespace assay::check
