// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/diagnosis.hpp"

#include "harness/check/stiffness.hpp"

namespace assay::check {

namespace {

constexpr const char* of_frames[] = {
    ids::shear_components, ids::shear_modulus,   ids::isotropy,          ids::constant_rotation, ids::basis,
    ids::rotation_at_rest, ids::rotation_before, ids::rotation_during,   ids::rotation_after,    ids::rotation_at_apex,
    ids::fixed_stretch,    ids::revolutions,     ids::rotation_of_state, ids::turning_stretches, ids::initial_stress,
    ids::class_at_rest,    ids::class_in_loading};
constexpr const char* of_time[] = {ids::rest,         ids::clock, ids::zero_increment, ids::rotation_at_rest,
                                   ids::step_halving, ids::jumps, ids::dissipation,    ids::initial_stress};

/// A test that tells nothing of its own where another one fails.
struct Consequence {
  const char *test, *of;
};
constexpr Consequence consequences[] = {
    {ids::dissipation, ids::energy},  // without a right energy there is none to be lost
    {ids::dissipation, ids::increment},
    {ids::energy, ids::major_symmetry},  // there is none
    {ids::dissipation, ids::major_symmetry},
    {ids::major_symmetry, ids::class_at_rest},         // a stiffness that is mixed up is
                                                       // seldom symmetric
    {ids::positive_stiffness, ids::shear_components},  // shears that are exchanged drive each other on
    {ids::positive_stiffness, ids::shear_modulus},     // as those of the wrong sign do
    {ids::positive_stiffness, ids::class_at_rest},
    {ids::dissipation, ids::positive_stiffness},  // whatever drives itself on
    {ids::clock, ids::repeated},                  // what is kept elsewhere follows no clock
    {ids::batch, ids::repeated},
    {ids::alignment, ids::repeated},
    {ids::bits, ids::repeated},
    {ids::clock, ids::alignment},  // arrays lie anywhere in other tests
    {ids::continuity, ids::alignment},
    {ids::batch, ids::alignment},
};

/// Walks the rows, and then what they have left unexplained.
class Diagnostician {
 public:
  Diagnostician(std::vector<TestResult>& tests, const Evidence& evidence) : facts_{tests, evidence} {}

  std::vector<Diagnosis> run() {
    std::vector<Suspicion> too_small;
    for (const Row& row : rows()) {
      if (is_shut_out(row) || !row.where(facts_)) continue;
      const std::optional<Suspicion> what = row.says(facts_);
      if (!what) continue;
      const bool is_too_small = row.explains == Explains::frames && what->size < least_share * error_of_frames();
      if (is_too_small) {
        too_small.push_back(*what);
        continue;
      }
      add(what->cause, what->sentence);
      if (row.explains != Explains::its_own_test) facts_.explained.push_back(row.explains);
    }
    // What is too small to explain the others, and wrong all the same.
    for (const Suspicion& what : too_small) add(what.cause, what.sentence);
    add_failures([&](const TestResult& test) { return speaks_for_itself(test); });
    name_what_follows();
    if (found_.empty()) add_failures([](const TestResult&) { return true; });
    return found_;
  }

 private:
  static constexpr double least_share = 0.05;  ///< a cause is of the size of what it explains

  /// The largest error of the tests of frames, over the largest stress; what has none is no matter of size.
  double error_of_frames() const {
    double largest = 0;
    for (const TestResult& test : facts_.tests) {
      const double measure = test.measure.value_or(0);
      if (test.verdict == Verdict::fail && is_of(Explains::frames, test.id) && std::isfinite(measure)) {
        largest = std::max(largest, measure);
      }
    }
    return largest;
  }

  bool is_shut_out(const Row& row) const {
    return (row.beside == Beside::no_frames && facts_.has_explained(Explains::frames)) ||
           (row.beside == Beside::no_time && facts_.has_explained(Explains::time));
  }

  /// Whether a test that has failed tells a cause that does not follow from another one.
  bool speaks_for_itself(const TestResult& test) const {
    if (test.cause.empty() || facts_.is_explained(test.id)) return false;
    if (!found_.empty() && test.cause == causes::no_convergence) return false;  // the weakest of all
    const bool of_order = !found_.empty() && is_of_order(found_.front().cause);
    if (of_order && test.cause == causes::tangent_wrong) return false;  // of the stress in its right order
    if (test.id == ids::rest && rest_is_of_stretches(facts_)) return false;
    return std::none_of(std::begin(consequences), std::end(consequences),
                        [&](const Consequence& each) { return test.id == each.test && facts_.failed(each.of); });
  }

  /// A failed test that has no cause of its own has that of the first one found.
  void name_what_follows() {
    for (TestResult& test : facts_.tests) {
      if (test.verdict != Verdict::fail || !(test.cause.empty() || facts_.is_explained(test.id))) continue;
      test.cause = found_.empty() ? causes::not_indifferent : found_.front().cause;
    }
  }

  void add_failures(const auto& predicate) {
    for (const TestResult& test : facts_.tests) {
      if (test.verdict == Verdict::fail && predicate(test)) add(test.cause, test.sentence);
    }
  }

  void add(const std::string& cause, const std::string& sentence) {
    const auto same = [&](const Diagnosis& d) { return d.cause == cause; };
    if (std::none_of(found_.begin(), found_.end(), same)) found_.push_back({cause, sentence});
  }

  Facts facts_;
  std::vector<Diagnosis> found_;
};

}  // namespace

bool is_of(Explains group, const std::string& test) {
  const auto holds = [&](const auto& all) { return std::find(std::begin(all), std::end(all), test) != std::end(all); };
  return (group == Explains::frames && holds(of_frames)) || (group == Explains::time && holds(of_time));
}

bool rest_is_of_stretches(const Facts& facts) {
  const std::string rest = facts.cause(ids::rest);
  return facts.cause(ids::nearly_equal_stretches) == causes::repeated_stretch &&
         (rest == causes::refuses || rest == causes::not_finite);
}

std::vector<Diagnosis> diagnose(std::vector<TestResult>& tests, const Evidence& evidence) {
  return Diagnostician(tests, evidence).run();
}

}  // namespace assay::check
