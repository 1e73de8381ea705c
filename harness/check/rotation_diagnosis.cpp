// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "harness/check/diagnosis_rows.hpp"
#include "harness/check/judge.hpp"
#include "harness/check/shear_order.hpp"

namespace assay::check {

namespace {

using Found = std::optional<Suspicion>;

constexpr double small_strain_within = 0.1;  ///< of the stress of sym(Q - I)
constexpr double unmoved = 0.02;             ///< of the body's angle

/// What a model is said to be of which no more is known; a stress that is not symmetric says more.
Found unnamed(const Findings& f, const std::string& sentence) {
  if (Found asymmetry = said_by(f, "symmetry")) return Suspicion{asymmetry->cause, asymmetry->sentence};
  return Suspicion{causes::not_indifferent, sentence};
}

/// A law that turns nothing has no spin that could be wrong.
Found not_turned(const Findings& f, const std::string& sentence) {
  return f.evidence.has_spin ? Suspicion{causes::wrong_spin, sentence} : unnamed(f, sentence);
}

Found small_strain_at_rest(const Findings& f) {
  if (!f.failed("rotation.at_rest") || !(std::abs(f.evidence.at_rest.small_strain - 1) < small_strain_within)) {
    return std::nullopt;
  }
  return Suspicion{causes::small_strain,
                   "a rigid rotation Q gives the stress of the strain sym(Q - I): the strain measure is not valid for "
                   "finite rotations"};
}

Found small_strain_of_rates(const Findings& f) {
  const bool is_small = std::abs(f.evidence.at_rest.relaxing_small_strain - 1) < small_strain_within;
  if (!f.failed("rotation.constant") || !is_small) return std::nullopt;
  return Suspicion{causes::small_strain,
                   "a rigid rotation Q gives the viscous stress of the strain sym(Q - I): the strain rate is sym(F1 - "
                   "F0)/dt, which is not valid for finite rotations"};
}

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
Found what_is_left(const TurnedStep& step) {
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
std::optional<Turned> wrong_way(const Findings& f, const TurnedStep& step, TurnedVariable& variable) {
  const auto same = [&](const TurnedVariable& other) { return other.name == variable.name; };
  const auto taken = std::find_if(step.taken.begin(), step.taken.end(), same);
  const Turned declared = variable.is_own ? Turned::not_at_all : Turned::rightly;
  const Turned as = taken == step.taken.end() ? declared : taken->how;
  const bool own_frame = as == Turned::not_at_all, misread = as != Turned::rightly && !own_frame;
  const Turned how = misread ? as : variable.how;
  if (misread) variable.order = step.order;
  const bool of_spin = !f.failed("rotation.constant") || f.evidence.right_without_spin;
  if (how == Turned::by_another_angle && !of_spin && !variable.exactly) return std::nullopt;
  if (how == Turned::rightly || how == Turned::otherwise || (own_frame && how == Turned::not_at_all)) {
    return std::nullopt;
  }
  return how;
}

bool any_turn_fails(const Findings& f) {
  const std::vector<TestResult>& tests = f.verdicts.tests();
  return std::any_of(tests.begin(), tests.end(), [](const TestResult& test) {
    const bool of_rotation = test.id.starts_with("rotation.") && test.id != "rotation.state";
    const bool turns = of_rotation || test.id == "basis" || test.id == "stretches.turning";
    return test.verdict == Verdict::fail && turns;
  });
}

/// A single step tells which tensor it is; the stress before all others.
Found turned_step_of(const Findings& f) {
  if (!any_turn_fails(f) || !f.evidence.turned) return std::nullopt;
  const TurnedStep& step = *f.evidence.turned;
  if (step.stress != Turned::rightly) return of_variable({.is_stress = true, .order = step.order}, step.stress);
  Found found;
  double farthest = -1;
  for (TurnedVariable variable : step.carried) {
    const std::optional<Turned> how = wrong_way(f, step, variable);
    const double far = variable.is_stress ? INFINITY : std::abs(variable.times - 1);
    if (!how || far <= farthest) continue;
    farthest = far;
    found = of_variable(variable, *how);
  }
  // A state that stays behind does not show in a frame that is turned once for all, nor less in smaller steps.
  const bool other = f.failed("rotation.constant") || f.evidence.fixed.result.order;
  return found || other ? found : what_is_left(step);
}

/// What the test itself has found out of frames that are turned once for all.
Found constant_by_itself(const Findings& f) {
  Found said = said_by(f, "rotation.constant");
  if (!said || said->cause.empty()) return std::nullopt;
  // principal axes in a wrong order are right at right angles, too
  if (said->cause == causes::shear_factor && f.failed("stretches.nearly_equal")) return std::nullopt;
  return said;
}

Found unrotated_once_for_all(const Findings& f) {
  const Found said = constant_by_itself(f);
  return said && said->cause == causes::rotation_missing ? said : std::nullopt;
}

/// Where the turned step says the same, it also says of what.
Found turned_once_for_all(const Findings& f) {
  const Found said = constant_by_itself(f), step = turned_step_of(f);
  return said && !(step && step->cause == said->cause) ? said : std::nullopt;
}

Found drift(const Findings& f) {
  if (!f.failed("rotation.constant") || f.evidence.drifting.empty()) return std::nullopt;
  return Suspicion{causes::drifts, "'" + f.evidence.drifting + "' of the state changes in steps without deformation, " +
                                       "and this makes later stresses wrong"};
}

Found unmoved_at_fixed_stretch(const Findings& f) {
  const RotationFinding& fixed = f.evidence.fixed;
  if (!f.failed("rotation.fixed_stretch") || !fixed.turned || std::abs(*fixed.turned) > unmoved) return std::nullopt;
  return Suspicion{causes::rotation_missing, "the stress of a stretched body does not rotate with the body"};
}

Found wrong_frame_at_fixed_stretch(const Findings& f) {
  if (!f.failed("rotation.fixed_stretch") || !f.failed("rotation.constant")) return std::nullopt;
  if (!f.evidence.right_without_spin || !f.evidence.has_spin) {
    return unnamed(f, f.find("rotation.constant")->sentence);
  }
  return Suspicion{causes::wrong_spin,
                   "the stress is right in every frame if the axes of stretch are fixed, and wrong if they rotate: "
                   "components of the spin are missing or mixed up"};
}

/// Of the body's angle: by which a small turn turns the stress, where that is not 1.
std::optional<double> other_spin(const RotationFinding& fixed) {
  return fixed.spin && std::abs(*fixed.spin - 1) > unmoved ? fixed.spin : std::nullopt;
}

Found no_rotations(const Findings& f) {
  const RotationFinding& fixed = f.evidence.fixed;
  const bool small_turns_are_right = fixed.spin && std::abs(*fixed.spin - 1) <= unmoved;
  const bool of_steps = (fixed.result.order && !other_spin(fixed)) || small_turns_are_right;
  if (!f.failed("rotation.fixed_stretch") || !of_steps) return std::nullopt;
  return Suspicion{
      causes::explicit_spin,
      "the increment that rotates the stress is not a rotation, or part of the rotation is taken as strain: " +
          fixed.result.sentence};
}

Found another_angle(const Findings& f) {
  const RotationFinding& fixed = f.evidence.fixed;
  if (!f.failed("rotation.fixed_stretch")) return std::nullopt;
  const bool other_angle = fixed.turned && std::abs(*fixed.turned - 1) > unmoved;
  // A large turn may be taken for another one, by which it comes to the same place.
  const std::optional<double> small = other_spin(fixed), times = small || !other_angle ? small : fixed.turned;
  if (!times) return std::nullopt;
  return Suspicion{causes::wrong_spin, "the stress rotates by " + rounded(*times) +
                                           " times the angle of the body's rotation" +
                                           (fixed.turned ? "" : ", and its increments are not rotations")};
}

Found left_behind_at_fixed_stretch(const Findings& f) {
  if (!f.failed("rotation.fixed_stretch") || f.evidence.state.left_behind.empty()) return std::nullopt;
  return Suspicion{causes::state_not_rotated,
                   "when the body rotates, " + f.evidence.state.left_behind +
                       " of the state does not rotate with it, and this makes the stress wrong"};
}

Found fixed_stretch(const Findings& f) {
  if (!f.failed("rotation.fixed_stretch")) return std::nullopt;
  return not_turned(f, f.evidence.fixed.result.sentence);
}

Found constant_with_a_stretch(const Findings& f) {
  if (!f.failed("rotation.constant") || f.evidence.right_without_spin) return std::nullopt;
  return unnamed(f, f.find("rotation.constant")->sentence);
}

Found left_behind(const Findings& f) {
  const bool fails = f.failed("rotation.after") || f.failed("rotation.during");
  if (!fails || f.evidence.state.left_behind.empty()) return std::nullopt;
  return Suspicion{causes::state_not_rotated,
                   "the stress turns with the body, but " + f.evidence.state.left_behind +
                       " of the state does not, and this makes the stress of later loads wrong"};
}

Found growth_in_revolutions(const Findings& f) {
  if (!f.failed("rotation.revolutions")) return std::nullopt;
  return Suspicion{f.find("rotation.revolutions")->cause, f.find("rotation.revolutions")->sentence};
}

Found any_turn(const Findings& f) {
  for (const char* id : {"rotation.during", "rotation.after", "rotation.before", "rotation.at_rest"}) {
    const Found said = said_by(f, id);
    if (said) return said->cause.empty() ? not_turned(f, said->sentence) : said;
  }
  return std::nullopt;
}

Found any_frame(const Findings& f) {
  for (const char* id : {"rotation.constant", "basis"}) {
    const bool of_isotropy = std::string(id) == "basis" && f.failed("isotropy");
    if (f.failed(id) && !of_isotropy) return unnamed(f, f.find(id)->sentence);
  }
  return std::nullopt;
}

constexpr Row rows[] = {
    {small_strain_at_rest, Explains::frames, Beside::no_frames},
    {small_strain_of_rates, Explains::frames, Beside::no_frames},
    {unrotated_once_for_all, Explains::frames, Beside::no_frames},
    {turned_once_for_all, Explains::frames, Beside::no_frames},
    {turned_step_of, Explains::frames, Beside::no_frames},
    {drift, Explains::frames, Beside::no_frames},
    {unmoved_at_fixed_stretch, Explains::frames, Beside::no_frames},
    {wrong_frame_at_fixed_stretch, Explains::frames, Beside::no_frames},
    {no_rotations, Explains::frames, Beside::no_frames},
    {another_angle, Explains::frames, Beside::no_frames},
    {left_behind_at_fixed_stretch, Explains::frames, Beside::no_frames},
    {fixed_stretch, Explains::frames, Beside::no_frames},
    {constant_with_a_stretch, Explains::frames, Beside::no_frames},
    {left_behind, Explains::frames, Beside::no_frames},
    {growth_in_revolutions, Explains::frames, Beside::no_frames},
    {any_turn, Explains::frames, Beside::no_frames},
    {any_frame, Explains::frames, Beside::no_frames},
};

}  // namespace

std::span<const Row> rows_of_rotation() { return rows; }

}  // namespace assay::check
