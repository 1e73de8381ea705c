// SPDX-License-Identifier: BSD-3-Clause
// The battery of tests that any material model must stand: frame indifference above all, and what else can be judged
// without knowing its equations.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/check/names.hpp"
#include "harness/material/material.hpp"
#include "harness/material/material_failure.hpp"

namespace assay::check {

enum class Verdict { pass, fail, not_applicable };

/// One test of the battery. Errors are relative: of stresses to the largest of the history that is compared.
struct TestResult {
  std::string id = {};  ///< of `ids`: "rotation.during"
  Verdict verdict = Verdict::pass;
  std::optional<double> measure = {};    ///< what was found; null where nothing was measured
  std::optional<double> threshold = {};  ///< largest measure that passes
  std::optional<double> order = {};  ///< at which the measure falls with the step; null where it does not depend on it
  std::string cause = {};            ///< of `causes`; empty where nothing is wrong
  std::string sentence = {};         ///< one plain sentence
  std::optional<FailedStep> step = {};  ///< where a call of `update` failed, or its result was wrong
  bool refused = false;                 ///< by the model's own word: it may stand a smaller strain
  double wall_s = 0;                    ///< that the test took
};

/// What is wrong with the model, from all tests together.
struct Diagnosis {
  std::string cause, sentence;
};

/// What the histories of the tests are like.
struct Effort {
  bool quick = false;                   ///< fewer steps and states: a fraction of a second
  double strain = 0.15;                 ///< at most [1]
  bool strain_is_asked = false;         ///< for: to be reached, or the material fails
  double step = 1;                      ///< the longest usual step [s]; all times of the tests go with it
  std::optional<double> pressure = {};  ///< at rest [Pa]; null: what the model needs
};

struct Report {
  std::vector<TestResult> tests;
  std::vector<Diagnosis> diagnosis;          ///< the most telling first; empty where every test passes
  Effort effort = {};                        ///< that was made in the end
  double strain = 0, pressure = 0;           ///< of the histories [1], and at rest [Pa]
  std::vector<std::string> not_tested = {};  ///< what a pass says nothing of, as parts of a sentence
  bool passes() const { return diagnosis.empty(); }
};

/// How the author of a model declares what the tests look for, for their sentences.
struct Declarations {
  std::string rate_dependence = "ASSAY_RATE_DEPENDENT";
  std::string own_axes = "ASSAY_ROLE_ROTATES_ITSELF";
  std::string growth = "ASSAY_GROWS";
  std::string numbered_state = {};  ///< an array whose numbers are the names s1, s2 ... of state variables; or empty
  bool guesses_roles = false;       ///< of the state: a foreign interface knows none
  bool may_drop_stress = false;     ///< an initial one that it cannot carry: it has no way to refuse
  bool plane_stress = false;        ///< in the plane 12: a stretch along 3 gives no stress, and none acts there
  double tangent_within = 1e-4;     ///< relative: of a foreign implicit law more, as its last iteration leaves it
  std::string tangent = "d sigma / d F1 in row-major order";
};

struct Options {
  Effort effort = {};
  std::string only = {};      ///< id of the one test that is wanted, besides those that it stands on; empty: all
  std::string without = {};   ///< id of a test that is left out
  bool well_aligned = false;  ///< of calls.arrays: where each array begins at a multiple of 64 bytes
  Declarations declarations = {};
  /// The last of the first histories (arrays.hpp) as a process gives it that begins with it; empty: not known.
  std::vector<std::vector<double>> elsewhere = {};
  /// The same of `other_parameters` (arrays.hpp), from a process whose first instance has these; empty: not known.
  std::vector<std::vector<double>> others_elsewhere = {};
  const assay_material* table_of_others = nullptr;  ///< makes the instance of other parameters; null: the model's own
  bool has_refused = false;                         ///< a step by its own word, at larger strains
  std::function<void(const std::string& id)> begins = {};   ///< told before each test
  std::function<void(const TestResult& result)> ends = {};  ///< after it, before the diagnosis
};

/// Of all tests, in their order.
std::vector<std::string> test_ids();

/// Runs every test; all of them again at smaller strains, as long as the model refuses a step of one by its own word. A
/// material that cannot be loaded at all ends as a single failed test "loading".
Report run_battery(const Material& material, const Options& options = {});

/// With which a remark begins in the sentence of a test that passes.
inline constexpr const char* remark_words = "a remark: ";

/// How the sentence begins of a tangent whose largest components agree, but not what a change of shape adds.
inline constexpr const char* tangent_of_shape = "the tangent of a change of shape";

/// What a sentence holds of a tangent of which no more can be told than how wrong it is.
inline constexpr const char* of_largest_component = " of its largest component; ";

/// How sentences begin of tests that were left because an earlier one has failed.
inline constexpr const char* not_judged = "cannot be judged before this is cured";

/// Of a step that was refused with these words.
std::string cause_of_refusal(const std::string& words, bool not_finite);

}  // namespace assay::check
