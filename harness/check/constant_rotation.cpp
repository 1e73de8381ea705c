// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/constant_rotation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "harness/check/frame_twins.hpp"
#include "harness/check/judge.hpp"

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

Loading turned_by(const Tensor& Q, const Loading& still) {
  return {[=](double t) { return Tensor(Q * still.F(t)); }, still.phases};
}

/// Whether the turned history is right where the body is turned to the frame by a step, from a state at rest: one that
/// holds axes follows that alone.
bool right_after_a_turn(const Specimen& specimen, const Tensor& Q, const Loading& still,
                        const std::vector<double>& rest) {
  const Material& material = *specimen.material;
  const Tensor I = Tensor::Identity();
  try {
    const Point turned = stepped(material, 0, 1, I, Q, rest);
    const Loading seen = turned_by(Q, still);
    const MarchOptions from_rest{.steps = specimen.steps(), .state = rest};
    MarchOptions from_turned = from_rest;
    from_turned.state = turned.state;
    const March a = march(material, still, from_rest), b = march(material, seen, from_turned);
    const double scale = std::max(a.largest, specimen.least_stress());
    for (std::size_t k = 0; k < a.marks.size(); ++k) {
      if (!(distance(rotated(Q.transpose(), b.marks[k].cauchy), a.marks[k].cauchy) <= own_precision * scale)) {
        return false;
      }
    }
    return true;
  } catch (const MaterialFailure&) {
    return false;
  }
}

/// The same where a step at rest comes before: what that sets up turns along from then on.
bool right_after_rest_and_turn(const Specimen& specimen, const Tensor& Q, const Loading& still) {
  const Tensor I = Tensor::Identity();
  const Point rested = stepped(*specimen.material, 0, 1, I, I, specimen.rest_state());
  return right_after_a_turn(specimen, Q, still, rested.state);
}

/// The multiple of the frame's angle by which the stress of a stretch along axes that stand still turns; nothing where
/// it is none that is likely.
std::optional<double> multiple_of_angle(const Specimen& specimen) {
  constexpr double alike = 1e-3;
  const Loading still = still_stretch(specimen), seen = turned_by(specimen.space.turn(angle), still);
  const MarchOptions options{.steps = specimen.steps(), .state = specimen.rest_state()};
  const March a = march(*specimen.material, still, options), b = march(*specimen.material, seen, options);
  for (const double times : {-1.0, 0.5, 2.0}) {
    const Tensor expected = rotated(specimen.space.turn(times * angle), a.marks[0].cauchy);
    if (distance(b.marks[0].cauchy, expected) <= alike * std::max(a.largest, specimen.least_stress())) return times;
  }
  return std::nullopt;
}

/// Whether a step in which the body does not move changes the stress where the body was turned, and only there.
bool turns_on(const Specimen& specimen) {
  constexpr double kept = 1e-6, changed = 1e-2;
  const Material& material = *specimen.material;
  const double length = specimen.rate_dependent() ? 1e-9 : 1;
  const auto change = [&](const Loading& loading) {
    const March loaded = march(material, loading, {.steps = specimen.steps(), .state = specimen.rest_state()});
    const Tensor F = loading.F(1);
    const Point held = stepped(material, 1, length, F, F, loaded.marks[0].state);
    const Point again = stepped(material, 1, length, F, F, held.state);
    return distance(again.cauchy, held.cauchy) / std::max(loaded.largest, specimen.least_stress());
  };
  const Loading still = still_stretch(specimen);
  return change(still) <= kept && change(turned_by(specimen.space.turn(angle), still)) >= changed;
}

/// As `judge`, of a material that may refuse the loading that it takes.
template <class Judge>
bool where_taken(const Judge& judge) {
  try {
    return judge();
  } catch (const MaterialFailure&) {
    return false;
  }
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

}  // namespace

TestResult constant_rotation(const Specimen& specimen) {
  const Tensor Q = specimen.space.turn(angle);
  const Loading still = out_and_back(specimen);
  const auto in_frame = [&](const Tensor& R) { return turned_by(R, still); };
  TestResult result = twin_or_tolerance(specimen, {"rotation.constant", still, in_frame(Q), Q, Vector3::UnitX(),
                                                   "the same history in a frame with a constant rotation"});
  if (result.verdict == Verdict::pass) return result;
  if (!specimen.isotropic() && right_after_a_turn(specimen, Q, still, specimen.rest_state())) {
    result.verdict = Verdict::not_applicable;
    result.sentence = "the state at rest holds axes of the material: right where the body is turned before";
    return result;
  }
  const auto is_right = [&](const Tensor& R, const Loading& history) {
    const TestResult twin = exact_twin(specimen, {"", history, turned_by(R, history), R, Vector3::UnitX(), ""});
    return twin.verdict == Verdict::pass || *twin.measure < 1e-3 * *result.measure;
  };
  const auto right = [&](const Tensor& R) { return is_right(R, still); };
  const FrameTwins alike{"", still, in_frame(Q), Tensor::Identity(), Vector3::UnitX(), ""};
  const TestResult unturned = exact_twin(specimen, alike);
  if (unturned.verdict == Verdict::pass) {
    result.cause = causes::rotation_missing;
    result.sentence += ", and equal to the stress of the unrotated body";
  } else if (!specimen.isotropic() && where_taken([&] { return right_after_rest_and_turn(specimen, Q, still); })) {
    result.cause = causes::state_not_rotated;
    result.sentence +=
        "; right if the body rests in its first step and rotates in the second: the first call sets up a tensor and "
        "does not rotate it by the rotation of that step";
  } else if (where_taken([&] { return turns_by_another_angle(specimen, result); })) {
    return result;
  } else if (const auto order = order_by_turns(specimen, is_right)) {
    result.cause = cause_of(*order);
    result.sentence += "; right in frames that exchange certain axes: " + misplaced_somewhere(*order);
  } else if (right(specimen.space.turn(small_angle))) {
    result.sentence += "; right in a frame that is turned by 17 degrees: it depends on the size of the rotation";
  } else if (specimen.isotropic() && right(rotation_about_z(right_angle)) &&
             (specimen.space.is_plane() || right(next_axes()))) {
    result.cause = causes::shear_factor;
    result.sentence +=
        "; right in frames at right angles: shear and normal components are not weighted as in an invariant";
  } else {
    where_taken([&] { return turns_on_in_place(specimen, result); });
  }
  return result;
}

bool right_without_spin(const Specimen& specimen) {
  const Tensor Q = specimen.space.turn(angle);
  const Loading still = still_stretch(specimen), seen = turned_by(Q, still);
  try {
    return exact_twin(specimen, {"", still, seen, Q, Vector3::UnitX(), ""}).verdict == Verdict::pass;
  } catch (const MaterialFailure&) {
    return false;
  }
}

}  // namespace assay::check
