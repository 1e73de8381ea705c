// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/diagnosis.hpp"

#include <algorithm>
#include <cmath>

#include "harness/check/diagnosis_rows.hpp"

namespace assay::check {

namespace {

/// Tests that one mistake about rotations, stiffness or spectra fails as a whole.
constexpr const char* of_frames[] = {
    "elasticity.components",  "elasticity.shear",     "isotropy",        "rotation.constant", "basis",
    "rotation.at_rest",       "rotation.before",      "rotation.during", "rotation.after",    "rotation.apex",
    "rotation.fixed_stretch", "rotation.revolutions", "rotation.state",  "stretches.turning", "initial_stress",
    "elasticity.class",       "symmetry_class"};

/// A test that tells nothing of its own where another one fails.
struct Consequence {
  const char *test, *of;
};
constexpr Consequence consequences[] = {
    {"dissipation", "energy"},  // without a right energy there is none to be lost
    {"dissipation", "calls.increment"},
    {"energy", "elasticity.major"},  // there is none
    {"dissipation", "elasticity.major"},
    {"elasticity.major", "elasticity.class"},  // a stiffness that is mixed up is seldom symmetric
    {"clock", "calls.repeated"},               // what is kept elsewhere follows no clock
};

bool is_of_frames(const TestResult& test) {
  return std::any_of(std::begin(of_frames), std::end(of_frames), [&](const char* id) { return test.id == id; });
}

class Diagnostician {
 public:
  Diagnostician(std::vector<TestResult>& tests, const Evidence& evidence) : findings_{Verdicts(tests), evidence} {}

  std::vector<Diagnosis> run() {
    for (const auto& rows : {rows_before_rotation(), rows_of_rotation(), rows_after_rotation()}) {
      for (const Row& row : rows) suspect(row);
    }
    for (const Suspect& each : suspects_) accept(each, !is_too_small(each));
    for (const Suspect& each : suspects_) accept(each, is_too_small(each));
    for (const TestResult& test : tests()) {
      if (test.verdict == Verdict::fail && speaks_for_itself(test)) add({test.cause, test.sentence});
    }
    name_what_follows();
    if (!found_.empty()) return found_;
    for (const TestResult& test : tests()) {
      if (test.verdict == Verdict::fail) add({test.cause, test.sentence});
    }
    return found_;
  }

 private:
  struct Suspect {
    const Row* row;
    Suspicion what;
  };

  std::vector<TestResult>& tests() const { return findings_.verdicts.tests(); }

  void suspect(const Row& row) {
    if (const auto what = row.evidence(findings_)) suspects_.push_back({&row, *what});
  }

  /// The largest error of the tests of frames, over the largest stress; what has none is no matter of size.
  double error_of_frames() const {
    double largest = 0;
    for (const TestResult& test : tests()) {
      const double measure = test.measure.value_or(0);
      if (test.verdict == Verdict::fail && is_of_frames(test) && std::isfinite(measure)) {
        largest = std::max(largest, measure);
      }
    }
    return largest;
  }

  /// A cause is of the size of what it explains.
  bool is_too_small(const Suspect& each) const {
    constexpr double least = 0.05;
    return each.row->explains == Explains::frames && each.what.size < least * error_of_frames();
  }

  void accept(const Suspect& each, bool in_turn) {
    if (!in_turn || (each.row->beside == Beside::no_frames && frames_explained_)) return;
    add({each.what.cause, each.what.sentence});
    if (each.row->explains == Explains::frames) frames_explained_ = true;
  }

  /// Whether a test that has failed tells a cause that does not follow from another one.
  bool speaks_for_itself(const TestResult& test) const {
    if (test.cause.empty() || (frames_explained_ && is_of_frames(test))) return false;
    if (!found_.empty() && test.cause == causes::no_convergence) return false;  // the weakest of all
    if (test.id == "rest" && rest_is_of_stretches(findings_.verdicts)) return false;
    return std::none_of(std::begin(consequences), std::end(consequences),
                        [&](const Consequence& each) { return test.id == each.test && findings_.failed(each.of); });
  }

  /// A failed test that has no cause of its own has that of the first one found.
  void name_what_follows() {
    for (TestResult& test : tests()) {
      if (test.verdict != Verdict::fail || !(test.cause.empty() || (frames_explained_ && is_of_frames(test)))) continue;
      test.cause = found_.empty() ? causes::not_indifferent : found_.front().cause;
    }
  }

  void add(const Diagnosis& diagnosis) {
    const auto same = [&](const Diagnosis& d) { return d.cause == diagnosis.cause; };
    if (std::none_of(found_.begin(), found_.end(), same)) found_.push_back(diagnosis);
  }

  Findings findings_;
  std::vector<Suspect> suspects_;
  std::vector<Diagnosis> found_;
  bool frames_explained_ = false;
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
                                            causes::not_of_class,
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
