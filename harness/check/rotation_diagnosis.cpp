// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/rotation_diagnosis.hpp"

#include <algorithm>
#include <cmath>

#include "harness/check/judge.hpp"

namespace assay::check {

namespace {

class RotationDiagnostician {
 public:
  RotationDiagnostician(const Verdicts& verdicts, const Evidence& evidence)
      : verdicts_(verdicts), evidence_(evidence) {}

  std::optional<Diagnosis> run() const {
    constexpr double small_strain_within = 0.1;
    if (failed("rotation.at_rest") && std::abs(evidence_.at_rest.small_strain - 1) < small_strain_within) {
      return Diagnosis{causes::small_strain,
                       "a body that only turns by Q is stressed as by the strain sym(Q - I): the strain is not one of "
                       "finite deformation"};
    }
    if (failed("rotation.constant") && std::abs(evidence_.at_rest.relaxing_small_strain - 1) < small_strain_within) {
      return Diagnosis{causes::small_strain,
                       "a body that only turns by Q has the viscous stress of the strain sym(Q - I): its rate is "
                       "sym(F1 - F0)/dt, not that of finite deformation"};
    }
    TestResult* constant = find("rotation.constant");
    if (constant && constant->cause == causes::shear_factor && failed("stretches.nearly_equal")) {
      constant->cause = {};  // principal axes in a wrong order are right at right angles, too
    }
    if (failed("rotation.constant") && constant->cause == causes::rotation_missing) {
      return of("rotation.constant");
    }
    std::optional<Diagnosis> of_step = of_turned_step();
    if (failed("rotation.constant") && !constant->cause.empty() && !(of_step && of_step->cause == constant->cause)) {
      return of("rotation.constant");
    }
    if (of_step) return of_step;
    if (failed("rotation.constant") && !evidence_.drifting.empty()) {
      return Diagnosis{causes::drifts, "'" + evidence_.drifting +
                                           "' of the state changes in steps without deformation, " +
                                           "and what follows shows it"};
    }
    if (failed("rotation.fixed_stretch")) return of_fixed_stretch();
    if (failed("rotation.constant") && !evidence_.right_without_spin) {
      return Diagnosis{causes::not_indifferent, find("rotation.constant")->sentence};
    }
    if (failed("rotation.after") || failed("rotation.during")) {
      if (!evidence_.state.left_behind.empty()) {
        return Diagnosis{causes::state_not_rotated, "the stress turns with the body, but " +
                                                        evidence_.state.left_behind +
                                                        " of the state does not, and the loads after that show it"};
      }
    }
    if (failed("rotation.revolutions")) {
      return Diagnosis{causes::explicit_spin, find("rotation.revolutions")->sentence};
    }
    for (const char* id : {"rotation.during", "rotation.after", "rotation.before", "rotation.at_rest"}) {
      if (!failed(id)) continue;
      return Diagnosis{find(id)->cause.empty() ? not_turned() : find(id)->cause, find(id)->sentence};
    }
    for (const char* id : {"rotation.constant", "basis"}) {
      if (failed(id) && !(std::string(id) == "basis" && failed("isotropy"))) {
        return Diagnosis{causes::not_indifferent, find(id)->sentence};
      }
    }
    return std::nullopt;
  }

 private:
  TestResult* find(const std::string& id) const { return verdicts_.find(id); }
  bool failed(const std::string& id) const { return verdicts_.failed(id); }
  std::optional<Diagnosis> of(const std::string& id) const { return verdicts_.of(id); }

  /// A law that turns nothing has no spin that could be wrong.
  const char* not_turned() const { return evidence_.has_spin ? causes::wrong_spin : causes::not_indifferent; }

  static Diagnosis of_variable(const TurnedVariable& variable, Turned how) {
    const std::string name = variable.is_stress ? "the stress" : "'" + variable.name + "' of the state";
    switch (how) {
      case Turned::with_13_and_23_exchanged:
        return {causes::components_swapped, "components 13 and 23 of " + name + " change places when the body turns"};
      case Turned::with_shear_factor:
        return {causes::shear_factor, "the shear components of " + name + " are doubled or halved when it is turned"};
      case Turned::not_at_all:
        return {variable.is_stress ? causes::rotation_missing : causes::state_not_rotated,
                name + " stays where it was when the body turns, and what follows takes it for a tensor"};
      default:
        return {causes::wrong_spin, name + " turns by " + rounded(variable.times) + " times the angle of the body"};
    }
  }

  /// A single step tells which tensor it is; the stress before all others.
  std::optional<Diagnosis> of_turned_step() const {
    const bool turning_fails =
        std::any_of(verdicts_.tests().begin(), verdicts_.tests().end(), [](const TestResult& test) {
          const bool of_rotation = test.id.rfind("rotation.", 0) == 0 && test.id != "rotation.state";
          const bool turns = of_rotation || test.id == "basis" || test.id == "stretches.turning";
          return test.verdict == Verdict::fail && turns;
        });
    if (!turning_fails || !evidence_.turned) return std::nullopt;
    const TurnedStep& step = *evidence_.turned;
    if (step.stress != Turned::rightly) return of_variable({"", true, step.stress, 1}, step.stress);
    std::optional<Diagnosis> found;
    double farthest = -1;
    for (const TurnedVariable& variable : step.carried) {
      const auto same = [&](const TurnedVariable& other) { return other.name == variable.name; };
      const auto taken = std::find_if(step.taken.begin(), step.taken.end(), same);
      const Turned declared = variable.is_own ? Turned::not_at_all : Turned::rightly;
      const Turned as = taken == step.taken.end() ? declared : taken->how;
      const bool own_frame = as == Turned::not_at_all, misread = as != Turned::rightly && !own_frame;
      const Turned how = misread ? as : variable.how;
      const bool of_spin =
          how == Turned::by_another_angle && (!failed("rotation.constant") || evidence_.right_without_spin);
      if (how == Turned::by_another_angle && !of_spin) continue;
      if (how == Turned::rightly || how == Turned::otherwise || (own_frame && how == Turned::not_at_all)) continue;
      const double far = variable.is_stress ? INFINITY : std::abs(variable.times - 1);
      if (far <= farthest) continue;
      farthest = far;
      found = of_variable(variable, how);
    }
    // A state that stays behind does not show in a frame that is turned once for all, nor less in smaller steps.
    const bool other = failed("rotation.constant") || evidence_.fixed.result.order;
    return found || other ? found : of_what_is_left(step);
  }

  /// Beside a stress that turns rightly, something that turns in no way that has a name.
  static std::optional<Diagnosis> of_what_is_left(const TurnedStep& step) {
    bool stress_is_right = false;
    const TurnedVariable* other = nullptr;
    for (const TurnedVariable& variable : step.carried) {
      if (variable.is_stress && variable.how == Turned::rightly) stress_is_right = true;
      if (!variable.is_stress && variable.how == Turned::otherwise) other = &variable;
    }
    if (!stress_is_right || !other) return std::nullopt;
    return Diagnosis{causes::state_not_rotated,
                     "the stress turns with the body, but '" + other->name + "' of the state does not"};
  }

  /// The stress of a stretched body that turns: left where it was, turned by another angle, or by about the right one
  /// in steps that are not rotations.
  Diagnosis of_fixed_stretch() const {
    constexpr double unmoved = 0.02;
    const RotationFinding& fixed = evidence_.fixed;
    if (fixed.turned && std::abs(*fixed.turned) <= unmoved) {
      return Diagnosis{causes::rotation_missing, "the stress of a stretched body that turns stays where it was"};
    }
    if (failed("rotation.constant")) {
      if (!evidence_.right_without_spin || !evidence_.has_spin) {
        return Diagnosis{causes::not_indifferent, find("rotation.constant")->sentence};
      }
      return Diagnosis{causes::wrong_spin,
                       "a stretch along axes that stand still is right in any frame, one along axes that turn is not: "
                       "components of the spin are missing or mixed up"};
    }
    if (fixed.result.order) {  // falls with the step
      return Diagnosis{causes::explicit_spin,
                       "the stress is turned in steps that are no rotations, or a turn is taken for a "
                       "strain: " +
                           fixed.result.sentence};
    }
    if (fixed.turned && std::abs(*fixed.turned - 1) > unmoved) {
      return Diagnosis{causes::wrong_spin,
                       "the stress turns by " + rounded(*fixed.turned) + " times the angle by which the body turns"};
    }
    if (!evidence_.state.left_behind.empty()) {
      return Diagnosis{causes::state_not_rotated, "of the state of a body that turns, " + evidence_.state.left_behind +
                                                      " does not turn along, and the stress is wrong by that"};
    }
    return Diagnosis{not_turned(), fixed.result.sentence};
  }

  const Verdicts& verdicts_;
  const Evidence& evidence_;
};

}  // namespace

std::optional<Diagnosis> diagnose_rotation(const Verdicts& verdicts, const Evidence& evidence) {
  return RotationDiagnostician(verdicts, evidence).run();
}

}  // namespace assay::check
