// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/diagnosis.hpp"

#include <algorithm>
#include <cmath>

#include "harness/check/rotation_diagnosis.hpp"

namespace assay::check {

namespace {

/// Tests that one mistake about rotations, stiffness or spectra fails as a whole.
constexpr const char* of_frames[] = {
    "elasticity.components",  "elasticity.shear",     "isotropy",        "rotation.constant", "basis",
    "rotation.at_rest",       "rotation.before",      "rotation.during", "rotation.after",    "rotation.apex",
    "rotation.fixed_stretch", "rotation.revolutions", "rotation.state",  "stretches.turning", "initial_stress"};

class Diagnostician {
 public:
  Diagnostician(std::vector<TestResult>& tests, const Evidence& evidence)
      : verdicts_(tests), tests_(tests), evidence_(evidence) {}

  std::vector<Diagnosis> run() {
    const std::optional<Diagnosis> components = of("elasticity.components"), shear = of("elasticity.shear");
    const bool once_for_all = failed("rotation.constant") || failed("basis");
    if (failed("calls.increment")) add(*of("calls.increment"));
    if (failed("calls.increment") && !evidence_.has_state_that_turns) explained_ = true;  // nor has it a spin
    if (failed("rest") && !rest_is_of_stretches()) {
      // A pressure is the same in every frame: what else differs has a cause of its own.
      if (evidence_.pressed_at_rest && failed("rotation.constant"))
        add(*of("rest"));
      else
        explain(*of("rest"));
    }
    if (grows()) explain(*of("dissipation"));
    if (failed("stretches.nearly_equal") && !once_for_all) explain(*of("stretches.nearly_equal"));
    if (failed("zero_increment") && !once_for_all) add(*of("zero_increment"));
    if (components && !explained_) explain(*components);
    if (shear && (!explained_ || components)) explain(*shear);
    if (const auto carried = of("initial_stress"); carried && carried->cause == causes::components_swapped) {
      explain(*carried);
    }
    if (!explained_) {
      if (const auto turning = diagnose_rotation(verdicts_, evidence_)) explain(*turning);
    }
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

  TestResult* find(const std::string& id) const { return verdicts_.find(id); }
  bool failed(const std::string& id) const { return verdicts_.failed(id); }
  std::optional<Diagnosis> of(const std::string& id) const { return verdicts_.of(id); }

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

  void add(const Diagnosis& diagnosis) {
    const auto same = [&](const Diagnosis& d) { return d.cause == diagnosis.cause; };
    if (std::none_of(found_.begin(), found_.end(), same)) found_.push_back(diagnosis);
  }

  void explain(const Diagnosis& diagnosis) {
    explained_ = true;
    add(diagnosis);
  }

  void of_isotropy() {
    if (explained_) return;
    explained_ = failed("basis");
    const bool swapped = find("isotropy")->cause == causes::components_swapped;
    add({swapped ? causes::components_swapped : causes::not_isotropic,
         "a body that was turned before it is loaded answers otherwise: " + find("isotropy")->sentence});
  }

  Verdicts verdicts_;
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
                                            causes::wrong_role,
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
                                            causes::jump,
                                            causes::forgotten,
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
