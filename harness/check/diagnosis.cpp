// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/diagnosis.hpp"

#include <algorithm>
#include <cmath>

#include "harness/check/diagnosis_rows.hpp"
#include "harness/check/shear_order.hpp"

namespace assay::check {

namespace {

/// A test that tells nothing of its own where another one fails.
struct Consequence {
  const char *test, *of;
};
constexpr Consequence consequences[] = {
    {"dissipation", "energy"},  // without a right energy there is none to be lost
    {"dissipation", "calls.increment"},
    {"energy", "elasticity.major"},  // there is none
    {"dissipation", "elasticity.major"},
    {"elasticity.major", "elasticity.class"},          // a stiffness that is mixed up is
                                                       // seldom symmetric
    {"elasticity.positive", "elasticity.components"},  // shears that are exchanged drive each other on
    {"elasticity.positive", "elasticity.class"},
    {"dissipation", "elasticity.positive"},  // whatever drives itself on
    {"clock", "calls.repeated"},             // what is kept elsewhere follows no clock
    {"calls.batch", "calls.repeated"},
    {"calls.alignment", "calls.repeated"},
    {"calls.bits", "calls.repeated"},
    {"clock", "calls.alignment"},  // arrays lie anywhere in other tests
    {"continuity", "calls.alignment"},
    {"calls.batch", "calls.alignment"},
};

class Diagnostician {
 public:
  Diagnostician(std::vector<TestResult>& tests, const Evidence& evidence) : findings_{Verdicts(tests), evidence, {}} {}

  std::vector<Diagnosis> run() {
    std::vector<const Row*> too_small;
    for (const auto& rows : {rows_before_rotation(), rows_of_rotation(), rows_after_rotation()}) {
      for (const Row& row : rows) {
        if (!take(row, least_share * error_of_frames())) too_small.push_back(&row);
      }
    }
    for (const Row* row : too_small) add_beside(*row);
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
  static constexpr double least_share = 0.05;  ///< a cause is of the size of what it explains

  std::vector<TestResult>& tests() const { return findings_.verdicts.tests(); }

  /// The largest error of the tests of frames, over the largest stress; what has none is no matter of size.
  double error_of_frames() const {
    double largest = 0;
    for (const TestResult& test : tests()) {
      const double measure = test.measure.value_or(0);
      if (test.verdict == Verdict::fail && is_of(Explains::frames, test.id) && std::isfinite(measure)) {
        largest = std::max(largest, measure);
      }
    }
    return largest;
  }

  static bool is_shut_out(const Row& row, const Findings& findings) {
    return (row.beside == Beside::no_frames && findings.has_explained(Explains::frames)) ||
           (row.beside == Beside::no_time && findings.has_explained(Explains::time));
  }

  /// False where what the row names would explain the tests of frames, and makes a smaller error than `least`.
  bool take(const Row& row, double least) {
    if (is_shut_out(row, findings_)) return true;
    const std::optional<Suspicion> what = row.evidence(findings_);
    if (!what) return true;
    if (row.explains == Explains::frames && what->size < least) return false;
    add({what->cause, what->sentence});
    if (row.explains != Explains::its_own_test) findings_.explained.push_back(row.explains);
    return true;
  }

  /// What is too small to explain the others, and wrong all the same.
  void add_beside(const Row& row) {
    if (const std::optional<Suspicion> what = row.evidence(findings_)) add({what->cause, what->sentence});
  }

  /// Whether a test that has failed tells a cause that does not follow from another one.
  bool speaks_for_itself(const TestResult& test) const {
    if (test.cause.empty() || findings_.is_explained(test.id)) return false;
    if (!found_.empty() && test.cause == causes::no_convergence) return false;  // the weakest of all
    const bool of_order = !found_.empty() && is_of_order(found_.front().cause);
    if (of_order && test.cause == causes::tangent_wrong) return false;  // of the stress in its right order
    if (test.id == "rest" && rest_is_of_stretches(findings_.verdicts)) return false;
    return std::none_of(std::begin(consequences), std::end(consequences),
                        [&](const Consequence& each) { return test.id == each.test && findings_.failed(each.of); });
  }

  /// A failed test that has no cause of its own has that of the first one found.
  void name_what_follows() {
    for (TestResult& test : tests()) {
      if (test.verdict != Verdict::fail || !(test.cause.empty() || findings_.is_explained(test.id))) continue;
      test.cause = found_.empty() ? causes::not_indifferent : found_.front().cause;
    }
  }

  void add(const Diagnosis& diagnosis) {
    const auto same = [&](const Diagnosis& d) { return d.cause == diagnosis.cause; };
    if (std::none_of(found_.begin(), found_.end(), same)) found_.push_back(diagnosis);
  }

  Findings findings_;
  std::vector<Diagnosis> found_;
};

}  // namespace

const std::vector<std::string>& all_causes() {
  static const std::vector<std::string> all{causes::components_swapped,
                                            causes::other_order,
                                            causes::shear_factor,
                                            causes::small_strain,
                                            causes::rotation_missing,
                                            causes::wrong_spin,
                                            causes::explicit_spin,
                                            causes::state_not_rotated,
                                            causes::wrong_role,
                                            causes::not_isotropic,
                                            causes::not_of_class,
                                            causes::not_positive,
                                            causes::repeated_stretch,
                                            causes::tangent_convention,
                                            causes::tangent_wrong,
                                            causes::hidden_state,
                                            causes::not_reproducible,
                                            causes::of_batch,
                                            causes::of_alignment,
                                            causes::kept_by_element,
                                            causes::host_counters,
                                            causes::clock,
                                            causes::overrun,
                                            causes::state_undeclared,
                                            causes::properties_missing,
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
                                            causes::refuses_length,
                                            causes::missing_routine,
                                            causes::not_reached,
                                            causes::grows,
                                            causes::single_precision,
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
