// SPDX-License-Identifier: BSD-3-Clause
// The battery of tests that any material model must stand: frame indifference above all, and what else can be judged
// without knowing its equations.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/material/material.hpp"
#include "harness/material/material_failure.hpp"

namespace assay::check {

enum class Verdict { pass, fail, not_applicable };

/// One test of the battery. Errors are relative: of stresses to the largest of the history that is compared.
struct TestResult {
  std::string id;  ///< "rotation.during"
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
  /// The same of `other_parameters` (calls.hpp), from a process whose first instance has these; empty: not known.
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

/// The causes that a diagnosis can name.
namespace causes {
inline constexpr const char* rotation_missing = "increment rotation missing";
inline constexpr const char* wrong_spin = "wrong spin";
inline constexpr const char* explicit_spin = "explicit spin grows stress";
inline constexpr const char* state_not_rotated = "state variable not rotated";
inline constexpr const char* wrong_role = "state variable with a wrong role";
inline constexpr const char* components_swapped = "components 13 and 23 swapped";
inline constexpr const char* other_order = "components in another order";
inline constexpr const char* shear_factor = "shear factor 2";
inline constexpr const char* small_strain = "small-strain law used at finite strain";
inline constexpr const char* not_isotropic = "material not isotropic";
inline constexpr const char* not_positive = "stiffness not positive";
inline constexpr const char* not_of_class = "material not of the declared symmetry";
inline constexpr const char* repeated_stretch = "unstable at repeated principal stress";
inline constexpr const char* tangent_convention = "tangent of another convention";
inline constexpr const char* tangent_wrong = "tangent wrong";
inline constexpr const char* hidden_state = "hidden state";
inline constexpr const char* not_reproducible = "not reproducible";
inline constexpr const char* of_batch = "depends on its batch";
inline constexpr const char* of_alignment = "depends on alignment";
inline constexpr const char* kept_by_element = "state kept by element";
inline constexpr const char* host_counters = "depends on the host's counters";
inline constexpr const char* clock = "clock";
inline constexpr const char* overrun = "overrun";
inline constexpr const char* state_undeclared = "state not declared";
inline constexpr const char* properties_missing = "properties missing";
inline constexpr const char* undeclared_increment = "increment read undeclared";
inline constexpr const char* not_indifferent = "not frame-indifferent";
inline constexpr const char* stress_at_rest = "stress at rest";
inline constexpr const char* initial_stress = "initial stress not carried";
inline constexpr const char* drifts = "changes at zero strain increment";
inline constexpr const char* no_convergence = "does not converge with the step";
inline constexpr const char* jump = "stress jumps";
inline constexpr const char* forgotten = "state variable forgotten";
inline constexpr const char* energy = "energy not consistent with stress";
inline constexpr const char* rate_form = "rate form not consistent with stress";
inline constexpr const char* wave_speed = "wave speed too low";
inline constexpr const char* closed_form = "closed form not consistent with stress";
inline constexpr const char* dissipation = "negative dissipation";
inline constexpr const char* not_a_number = "numbers out of nothing";
inline constexpr const char* no_stress = "no stress";
inline constexpr const char* refuses = "refuses a step";
inline constexpr const char* refuses_length = "refuses the length of a step";
inline constexpr const char* missing_routine = "routine missing";
inline constexpr const char* not_reached = "strain not reached";
inline constexpr const char* grows = "strain of its own in time";
inline constexpr const char* single_precision = "single precision";
inline constexpr const char* not_finite = "stress or state not finite";
inline constexpr const char* not_symmetric = "stress not symmetric";
inline constexpr const char* ends_process = "ends the process";
inline constexpr const char* disturbs_process = "disturbs its process";
inline constexpr const char* other_stress = "vortex not reproduced";
}  // namespace causes

/// With which a remark begins in the sentence of a test that passes.
inline constexpr const char* remark_words = "a remark: ";

/// How sentences begin of tests that were left because an earlier one has failed.
inline constexpr const char* not_judged = "cannot be judged before this is cured";

/// Of a step that was refused with these words.
std::string cause_of_refusal(const std::string& words, bool not_finite);

/// All of them, in the order in which a diagnosis lists them.
const std::vector<std::string>& all_causes();

}  // namespace assay::check
