// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/diagnosis.hpp"

#include <algorithm>
#include <cmath>

#include "harness/check/judge.hpp"

namespace assay::check {

namespace {

/// Tests that one mistake about rotations, stiffness or spectra fails as a whole.
constexpr const char* of_frames[] = {
    "elasticity.components",  "elasticity.shear",     "isotropy",          "rotation.constant", "basis",
    "rotation.at_rest",       "rotation.before",      "rotation.during",   "rotation.after",    "rotation.apex",
    "rotation.fixed_stretch", "rotation.revolutions", "stretches.turning", "initial_stress"};

class Diagnostician {
 public:
  Diagnostician(std::vector<TestResult>& tests, const Evidence& evidence) : tests_(tests), evidence_(evidence) {}

  std::vector<Diagnosis> run() {
    const std::optional<Diagnosis> components = of("elasticity.components"), shear = of("elasticity.shear");
    const bool once_for_all = failed("rotation.constant") || failed("basis");
    if (failed("calls.increment")) add(*of("calls.increment"));
    if (failed("calls.increment") && !evidence_.has_state_that_turns) explained_ = true;  // nor has it a spin
    if (failed("rest") && !rest_is_of_stretches()) explain(*of("rest"));
    if (grows()) explain(*of("dissipation"));
    if (failed("stretches.nearly_equal") && !once_for_all) explain(*of("stretches.nearly_equal"));
    if (failed("zero_increment") && !once_for_all) add(*of("zero_increment"));
    if (components && !explained_) explain(*components);
    if (shear && (!explained_ || components)) explain(*shear);
    if (const auto carried = of("initial_stress"); carried && carried->cause == causes::components_swapped) {
      explain(*carried);
    }
    if (!explained_) of_rotation();
    if (failed("symmetry") && !found_.empty() && found_.front().cause == causes::not_indifferent) {
      found_.front() = *of("symmetry");  // which says more
    }
    if (failed("isotropy")) of_isotropy();
    for (const TestResult& test : tests_) {
      if (test.verdict != Verdict::fail) continue;
      if (test.cause.empty() || (explained_ && is_of_frames(test.id))) continue;
      if (!found_.empty() && test.cause == causes::no_convergence) continue;  // the weakest of all
      if (test.id == "rest" && rest_is_of_stretches()) continue;
      if (test.id == "dissipation" && (failed("energy") || failed("calls.increment")))
        continue;                                                    // it tells nothing then
      if (test.id == "clock" && failed("calls.repeated")) continue;  // nor of what is kept elsewhere
      add({test.cause, test.sentence});
    }
    for (TestResult& test : tests_) {
      if (test.verdict == Verdict::fail && (test.cause.empty() || (explained_ && is_of_frames(test.id)))) {
        test.cause = found_.empty() ? causes::not_indifferent : found_.front().cause;
      }
    }
    if (found_.empty()) {
      for (const TestResult& test : tests_) {
        if (test.verdict == Verdict::fail) add({test.cause, test.sentence});
      }
    }
    return found_;
  }

 private:
  static bool is_of_frames(const std::string& id) {
    return std::any_of(std::begin(of_frames), std::end(of_frames), [&](const char* each) { return id == each; });
  }

  TestResult* find(const std::string& id) const {
    const auto found = std::find_if(tests_.begin(), tests_.end(), [&](const TestResult& t) { return t.id == id; });
    return found == tests_.end() ? nullptr : &*found;
  }

  bool failed(const std::string& id) const { return find(id) && find(id)->verdict == Verdict::fail; }

  /// Whether a step at rest fails as other steps between equal stretches do.
  bool rest_is_of_stretches() const {
    const auto rest = of("rest"), equal = of("stretches.nearly_equal");
    return rest && equal && equal->cause == causes::repeated_stretch &&
           (rest->cause == causes::refuses || rest->cause == causes::not_finite);
  }

  /// Whether a stress that is held grows without bounds: then no test of rotation means anything.
  bool grows() const {
    return failed("dissipation") && failed("rotation.revolutions") && !failed("rotation.constant") &&
           !std::isfinite(find("rotation.revolutions")->measure.value_or(0));
  }

  std::optional<Diagnosis> of(const std::string& id) const {
    if (!failed(id)) return std::nullopt;
    return Diagnosis{find(id)->cause, find(id)->sentence};
  }

  void add(const Diagnosis& diagnosis) {
    const auto same = [&](const Diagnosis& d) { return d.cause == diagnosis.cause; };
    if (std::none_of(found_.begin(), found_.end(), same)) found_.push_back(diagnosis);
  }

  void explain(const Diagnosis& diagnosis) {
    explained_ = true;
    add(diagnosis);
  }

  /// A law that turns nothing has no spin that could be wrong.
  const char* not_turned() const { return evidence_.has_spin ? causes::wrong_spin : causes::not_indifferent; }

  void of_rotation() {
    constexpr double small_strain_within = 0.1;
    if (failed("rotation.at_rest") && std::abs(evidence_.at_rest.small_strain - 1) < small_strain_within) {
      return explain({causes::small_strain,
                      "a body that only turns by Q is stressed as by the strain sym(Q - I): the strain is not one of "
                      "finite deformation"});
    }
    if (failed("rotation.constant") && std::abs(evidence_.at_rest.relaxing_small_strain - 1) < small_strain_within) {
      return explain({causes::small_strain,
                      "a body that only turns by Q has the viscous stress of the strain sym(Q - I): its rate is "
                      "sym(F1 - F0)/dt, not that of finite deformation"});
    }
    TestResult* constant = find("rotation.constant");
    if (constant && constant->cause == causes::shear_factor && failed("stretches.nearly_equal")) {
      constant->cause = {};  // principal axes in a wrong order are right at right angles, too
    }
    if (failed("rotation.constant") && constant->cause == causes::rotation_missing) {
      return explain(*of("rotation.constant"));
    }
    const std::optional<Diagnosis> of_step = of_turned_step();
    if (failed("rotation.constant") && !constant->cause.empty() && !(of_step && of_step->cause == constant->cause)) {
      return explain(*of("rotation.constant"));
    }
    if (of_step) return explain(*of_step);
    if (failed("rotation.constant") && !evidence_.drifting.empty()) {
      return explain({causes::drifts, "'" + evidence_.drifting +
                                          "' of the state changes in steps without deformation, " +
                                          "and what follows shows it"});
    }
    if (failed("rotation.fixed_stretch")) return of_fixed_stretch();
    if (failed("rotation.constant") && !evidence_.right_without_spin) {
      return explain({causes::not_indifferent, find("rotation.constant")->sentence});
    }
    if (failed("rotation.after") || failed("rotation.during")) {
      if (!evidence_.state.left_behind.empty()) {
        return explain({causes::state_not_rotated, "the stress turns with the body, but " +
                                                       evidence_.state.left_behind +
                                                       " of the state does not, and the loads after that show it"});
      }
    }
    if (failed("rotation.revolutions")) {
      return explain({causes::explicit_spin, find("rotation.revolutions")->sentence});
    }
    for (const char* id : {"rotation.during", "rotation.after", "rotation.before", "rotation.at_rest"}) {
      if (!failed(id)) continue;
      return explain({find(id)->cause.empty() ? not_turned() : find(id)->cause, find(id)->sentence});
    }
    for (const char* id : {"rotation.constant", "basis"}) {
      if (failed(id) && !(std::string(id) == "basis" && failed("isotropy"))) {
        return explain({causes::not_indifferent, find(id)->sentence});
      }
    }
  }

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
    const bool turning_fails = std::any_of(tests_.begin(), tests_.end(), [](const TestResult& test) {
      const bool turns = test.id.rfind("rotation.", 0) == 0 || test.id == "basis" || test.id == "stretches.turning";
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
  void of_fixed_stretch() {
    constexpr double unmoved = 0.02;
    const RotationFinding& fixed = evidence_.fixed;
    if (fixed.turned && std::abs(*fixed.turned) <= unmoved) {
      return explain({causes::rotation_missing, "the stress of a stretched body that turns stays where it was"});
    }
    if (failed("rotation.constant")) {
      if (!evidence_.right_without_spin || !evidence_.has_spin) {
        return explain({causes::not_indifferent, find("rotation.constant")->sentence});
      }
      return explain({causes::wrong_spin,
                      "a stretch along axes that stand still is right in any frame, one along axes that turn is not: "
                      "components of the spin are missing or mixed up"});
    }
    if (fixed.result.order) {  // falls with the step
      return explain({causes::explicit_spin,
                      "the stress is turned in steps that are no rotations, or a turn is taken for a "
                      "strain: " +
                          fixed.result.sentence});
    }
    if (fixed.turned && std::abs(*fixed.turned - 1) > unmoved) {
      return explain({causes::wrong_spin,
                      "the stress turns by " + rounded(*fixed.turned) + " times the angle by which the body turns"});
    }
    if (!evidence_.state.left_behind.empty()) {
      return explain({causes::state_not_rotated, "of the state of a body that turns, " + evidence_.state.left_behind +
                                                     " does not turn along, and the stress is wrong by that"});
    }
    explain({not_turned(), fixed.result.sentence});
  }

  void of_isotropy() {
    if (explained_) return;
    explained_ = failed("basis");
    const bool swapped = find("isotropy")->cause == causes::components_swapped;
    add({swapped ? causes::components_swapped : causes::not_isotropic,
         "a body that was turned before it is loaded answers otherwise: " + find("isotropy")->sentence});
  }

  std::vector<TestResult>& tests_;
  const Evidence& evidence_;
  std::vector<Diagnosis> found_;
  bool explained_ = false;  ///< what the tests of frames have found
};

}  // namespace

const std::vector<std::string>& all_causes() {
  static const std::vector<std::string> all{causes::components_swapped,
                                            causes::shear_factor,
                                            causes::small_strain,
                                            causes::rotation_missing,
                                            causes::wrong_spin,
                                            causes::explicit_spin,
                                            causes::state_not_rotated,
                                            causes::not_isotropic,
                                            causes::repeated_stretch,
                                            causes::tangent_convention,
                                            causes::tangent_wrong,
                                            causes::hidden_state,
                                            causes::clock,
                                            causes::overrun,
                                            causes::undeclared_increment,
                                            causes::not_indifferent,
                                            causes::stress_at_rest,
                                            causes::initial_stress,
                                            causes::drifts,
                                            causes::no_convergence,
                                            causes::energy,
                                            causes::rate_form,
                                            causes::wave_speed,
                                            causes::closed_form,
                                            causes::dissipation,
                                            causes::not_a_number,
                                            causes::no_stress,
                                            causes::refuses,
                                            causes::not_finite,
                                            causes::not_symmetric,
                                            causes::ends_process,
                                            causes::disturbs_process,
                                            causes::other_stress};
  return all;
}

std::vector<Diagnosis> diagnose(std::vector<TestResult>& tests, const Evidence& evidence) {
  return Diagnostician(tests, evidence).run();
}

}  // namespace assay::check
