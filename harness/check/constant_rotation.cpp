// SPDX-License-Identifier: BSD-3-Clause
// A frame that is turned once for all, what any model keeps exactly; and a body that is, with its frame or without.
#include <cmath>

#include "harness/check/component_slip.hpp"
#include "harness/check/frame_twins.hpp"
#include "harness/check/tests.hpp"

namespace assay::check {

namespace {

constexpr double angle = turning_angle, small_angle = 0.3;

/// A stretch along axes that stand still.
Loading still_stretch(const Specimen& specimen) {
  Tensor axes;
  axes << 0.9, 0.4, -0.3, 0.4, -0.5, 0.2, -0.3, 0.2, 0.3;
  return {[axes = specimen.space.within(axes), a = specimen.amplitude](double t) {
            return Tensor(Tensor::Identity() + a * std::sin(4 * t) * axes);
          },
          1};
}

/// Whether the turned history is right where the body is turned to the frame by a step, from a state at rest: one that
/// holds axes follows that alone.
bool right_after_a_turn(const Specimen& specimen, const Tensor& Q, const Loading& still,
                        const std::vector<double>& rest) {
  const Material& material = *specimen.material;
  const auto is_right = [&] {
    const Point there = stepped(material, 0, 1, Tensor::Identity(), Q, rest);
    const March a = march(material, still, {.steps = specimen.steps(), .state = rest});
    const March b = march(material, turned(still, Q), {.steps = specimen.steps(), .state = there.state});
    return error_between(specimen, a, b, [&](double) { return Q; }) <= own_precision;
  };
  return if_taken(is_right, false);
}

/// The same where a step at rest comes before: what that sets up turns along from then on.
bool right_after_rest_and_turn(const Specimen& specimen, const Tensor& Q, const Loading& still) {
  const Point rested = hold(specimen, 0, 1, Tensor::Identity(), {{}, specimen.rest_state()});
  return right_after_a_turn(specimen, Q, still, rested.state);
}

/// The multiple of the frame's angle by which the stress of a stretch along axes that stand still turns; nothing where
/// it is none that is likely.
std::optional<double> multiple_of_angle(const Specimen& specimen) {
  constexpr double alike = 1e-3;
  const Loading still = still_stretch(specimen);
  const March a = from_rest(specimen, still), b = from_rest(specimen, turned(still, specimen.space.turn(angle)));
  for (const double times : {-1.0, 0.5, 2.0}) {
    const Tensor expected = rotated(specimen.space.turn(times * angle), a.marks[0].cauchy);
    if (distance(b.marks[0].cauchy, expected) <= alike * specimen.scale(a.largest)) return times;
  }
  return std::nullopt;
}

/// Whether a step in which the body does not move changes the stress where the body was turned, and only there.
bool turns_on(const Specimen& specimen) {
  constexpr double kept = 1e-6, changed = 1e-2;
  const double length = specimen.rate_dependent() ? 1e-9 : 1;
  const auto change = [&](const Loading& loading) {
    const March loaded = from_rest(specimen, loading);
    const Tensor F = loading.F(1);
    const Point held = hold(specimen, 1, length, F, loaded.marks[0]), again = hold(specimen, 1, length, F, held);
    return distance(again.cauchy, held.cauchy) / specimen.scale(loaded.largest);
  };
  const Loading still = still_stretch(specimen);
  return change(still) <= kept && change(turned(still, specimen.space.turn(angle))) >= changed;
}

bool turns_by_another_angle(const Specimen& specimen, TestResult& result) {
  const auto times = multiple_of_angle(specimen);
  if (!times) return false;
  result.cause = causes::wrong_spin;
  result.sentence +=
      "; for a stretch along fixed axes the stress rotates by " + rounded(*times) + " times the angle of the frame";
  return true;
}

bool turns_on_in_place(const Specimen& specimen, TestResult& result) {
  if (!turns_on(specimen)) return false;
  result.cause = causes::wrong_spin;
  result.sentence +=
      "; after a rotation, the stress goes on rotating in steps without motion: the rotation is taken from F, not from "
      "the increment";
  return true;
}

/// The slip in components of the stress that explains why `seen` is not `still` turned by Q.
std::optional<ComponentSlip> slip_of_stress(const Specimen& specimen, const FrameTwins& twins) {
  constexpr double explained = 1e-3;  // of the error
  if (specimen.space.is_plane()) return std::nullopt;
  const auto found = [&]() -> std::optional<ComponentSlip> {
    const March still = from_rest(specimen, twins.still), seen = from_rest(specimen, twins.seen);
    const auto error = [&](const ComponentSlip& slip) {
      double worst = 0;
      for (std::size_t k = 0; k < still.marks.size(); ++k) {
        const Tensor expected = rotated(twins.Q, slip.undone(still.marks[k].cauchy));
        worst = std::max(worst, distance(slip.undone(seen.marks[k].cauchy), expected));
      }
      return worst;
    };
    const double as_it_is = error({});
    return slip_that([&](const ComponentSlip& slip) { return error(slip) <= explained * as_it_is; });
  };
  return if_taken(found, std::nullopt);
}

}  // namespace

/// Orientation of the frame from the beginning on; sigma = Q sigma_0 Q^T.
TestResult constant_rotation(const Specimen& specimen) {
  const Tensor Q = specimen.space.turn(angle);
  const Loading still = out_and_back(specimen);
  const Loading seen = turned(still, Q);
  TestResult result =
      twin_or_tolerance(specimen, {still, seen, Q, "the same history in a frame with a constant rotation"});
  if (result.verdict == Verdict::pass) return result;
  if (!specimen.isotropic() && right_after_a_turn(specimen, Q, still, specimen.rest_state())) {
    result.verdict = Verdict::not_applicable;
    result.sentence = "the state at rest holds axes of the material: right where the body is turned before";
    return result;
  }
  const auto is_right = [&](const Tensor& R, const Loading& history) {
    const TestResult twin = exact_twin(specimen, {history, turned(history, R), R});
    return twin.verdict == Verdict::pass || *twin.measure < 1e-3 * *result.measure;
  };
  const auto right = [&](const Tensor& R) { return is_right(R, still); };
  if (is_exact_twin(specimen, {still, seen})) {
    result.cause = causes::rotation_missing;
    result.sentence += ", and equal to the stress of the unrotated body";
  } else if (!specimen.isotropic() && if_taken([&] { return right_after_rest_and_turn(specimen, Q, still); }, false)) {
    result.cause = causes::state_not_rotated;
    result.sentence +=
        "; right if the body rests in its first step and rotates in the second: the first call sets up a tensor and "
        "does not rotate it by the rotation of that step";
  } else if (if_taken([&] { return turns_by_another_angle(specimen, result); }, false)) {
    return result;
  } else if (const auto order = order_by_turns(specimen, is_right)) {
    result.cause = cause_of(*order);
    result.sentence += "; right in frames that exchange certain axes: " + misplaced_somewhere(*order);
  } else if (const auto slip = slip_of_stress(specimen, {still, seen, Q})) {
    result.cause = slip->cause;
    result.sentence += ", because " + slip->of("the stress");
  } else if (right(specimen.space.turn(small_angle))) {
    result.sentence += "; right in a frame that is turned by 17 degrees: it depends on the size of the rotation";
  } else if (specimen.isotropic() && right(rotation_about_z(right_angle)) &&
             (specimen.space.is_plane() || right(next_axes()))) {
    result.cause = causes::shear_factor;
    result.sentence +=
        "; right in frames at right angles: shear and normal components are not weighted as in an invariant";
  } else {
    if_taken([&] { return turns_on_in_place(specimen, result); }, false);
  }
  return result;
}

bool right_without_spin(const Specimen& specimen) {
  const Tensor Q = specimen.space.turn(angle);
  const Loading still = still_stretch(specimen);
  return if_taken([&] { return is_exact_twin(specimen, {still, turned(still, Q), Q}); }, false);
}

/// Body and frame turned: F' = Q F Q^T.
TestResult change_of_basis(const Specimen& specimen) {
  const bool directed = has_direction(specimen.material->table());
  if (!specimen.isotropic() && !directed) {
    return left_out("the material has axes of its own, and declares no direction that could rotate with the frame");
  }
  const Tensor Q =
      directed ? rotation_about_z(turning_angle) : specimen.space.turn(turning_angle);  // the third axis may be fixed
  const Loading still = out_and_back(specimen);
  const Loading seen{[=](double t) { return rotated(Q, still.F(t)); }, still.phases};
  return twin_or_tolerance(specimen, {still, seen, Q, "body and frame turned together", Q * Vector3::UnitX()});
}

/// The body alone turned before it is loaded: F' = F Q^T, sigma' = sigma for isotropic materials.
TestResult isotropy(const Specimen& specimen) {
  if (!specimen.isotropic()) return left_out("the model does not claim to be isotropic");
  const Loading still = out_and_back(specimen);
  const auto before = [&](const Tensor& Q, const Loading& history) {
    const Loading seen{[=](double t) { return Tensor(history.F(t) * Q.transpose()); }, history.phases};
    return FrameTwins{history, seen, Tensor::Identity(), "the same history of a body that was rotated before"};
  };
  TestResult result = twin_or_tolerance(specimen, before(specimen.space.turn(turning_angle), still));
  if (result.verdict == Verdict::pass) return result;
  if (const auto order = order_by_turns(specimen, [&](const Tensor& Q, const Loading& history) {
        return is_exact_twin(specimen, before(Q, history));
      })) {
    result.cause = cause_of(*order);
    result.sentence += "; right where the turn exchanges certain axes: " + misplaced_somewhere(*order);
    return result;
  }
  // A crystal that is not declared is as right; its small strains are those of one, too.
  const auto right = [&](const Tensor& Q) {
    const TestResult twin = exact_twin(specimen, before(Q, still));
    return twin.verdict == Verdict::pass || *twin.measure < 1e-3 * *result.measure;
  };
  if (right(rotation_about_z(right_angle)) && (specimen.space.is_plane() || right(next_axes())) &&
      shear_modulus(specimen).verdict == Verdict::pass) {
    result.cause = causes::shear_factor;
    result.sentence +=
        "; right after rotations by right angles, and isotropic in small strains: shear and normal components are not "
        "weighted as in an invariant";
  }
  return result;
}

}  // namespace assay::check
