// SPDX-License-Identifier: BSD-3-Clause
// What `check` finds out about a model behind a foreign interface beyond the battery: by another description of it, by
// other values of what its host tells, and by what lies around its arrays.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "adapters/foreign/host_values.hpp"
#include "drivers/check/check_process.hpp"
#include "drivers/material/material_choice.hpp"
#include "harness/check/arrays.hpp"
#include "harness/material/material_failure.hpp"
#include "harness/numeric/number_archive.hpp"

namespace assay::drivers {

inline constexpr const char *beyond_test = "calls.beyond", *host_test = "calls.host";

// Steps in the middle of histories, to be taken again in other circumstances.

struct RepeatedStep : FailedStep {
  bool first = false;  ///< of its history
};

/// What a step gives: its status, the nine components of the stress [Pa], the state.
using Answer = std::vector<double>;
inline constexpr std::size_t stress_of_answer = 1, state_of_answer = 10;

/// said: what the material says of the step.
Answer answer_of(const Material& material, const FailedStep& step, UpdateReport* said = nullptr);

inline bool is_good(const Answer& answer) { return static_cast<int>(answer[0]) != ASSAY_FAILED; }
inline Answer state_in(const Answer& answer) { return {answer.begin() + state_of_answer, answer.end()}; }

/// The largest finite component of the stress [Pa]; 0 where none is.
double largest_stress(const Answer& answer);

/// Bit for bit, but that one number that is none is as good as another.
bool same_answer(const Answer& a, const Answer& b);

/// Of a body that turns while it is strained out, back and beyond, from rest under a pressure [Pa]; up to the first
/// that the material does not take. The first is from rest. Throws std::runtime_error where it cannot be at rest.
std::vector<RepeatedStep> repeated_steps(const Material& material, double strain, double pressure, int count);

// What a model does in a process that begins in another way: one that keeps something of its first call shows it.

/// Numbers that `make` gives in a process of its own, which what it does cannot harm; none where that ends before it
/// has given them, or takes longer than limit_s.
std::optional<std::vector<double>> numbers_made_elsewhere(const std::function<std::vector<double>()>& make,
                                                          double limit_s);

/// The same of anything that numbers can tell (harness/numeric/number_archive.hpp).
template <class Make>
std::optional<std::invoke_result_t<Make>> made_elsewhere(const Make& make, double limit_s) {
  const auto numbers_of = [&] {
    auto made = make();
    NumberWriter writer;
    writer(made);
    return std::move(writer.numbers);
  };
  std::optional<std::invoke_result_t<Make>> found;
  const auto numbers = numbers_made_elsewhere(numbers_of, limit_s);
  if (!numbers) return found;
  NumberReader reader(*numbers);
  reader(found.emplace());
  return found;
}

/// The last of the battery's first histories, as the first of a process of its own; empty where that comes to nothing
/// within limit_s. For a process that has not called the model yet.
check::History history_elsewhere(const Material& material, const check::Effort& effort, double limit_s = 1);

/// The same of other parameters (harness/check/arrays.hpp), from a copy of the library whose first instance has these:
/// a library that was loaded before may keep what its first instance was. Empty, too, of a model that is no native
/// plug-in.
check::History history_of_others(const ResolvedMaterial& material, const check::Effort& effort, double limit_s = 1);

// Models behind a foreign interface.

/// The bridge of an instance; null of what is none to Abaqus' interfaces.
adapters::AbaqusBridge* bridge_of(const Material& material);

/// In the process of the check points have the element that its tests give them.
void keep_elements(const Material& material);

/// Where a variable of that name begins in the state; the size of the state where there is none.
std::size_t place_in_state(const assay_material& table, const std::string& name);

/// A model made as the tests need it: with keep_elements. Throws what Material does.
Material made_for_tests(const adapters::ForeignModel& model, const std::map<std::string, double>& parameters);

inline bool is_of(const ResolvedMaterial& material, adapters::ForeignInterface interface) {
  return material.foreign && material.foreign->interface == interface;
}

/// Whether it was a model of our own interface, to which its rules apply.
bool is_native(const CheckedMaterial& checked);

/// The battery of the same model by another description of it, or the test `only`; none where it cannot be made so.
std::optional<check::Report> battery_as(const adapters::ForeignModel& model, const ResolvedMaterial& material,
                                        const check::Effort& effort, const std::string& only = {});

/// How the author of the model declares things; of a native model as the ABI does.
check::Declarations declarations_of(const ResolvedMaterial& material);

/// What of a foreign model the tests leave as it is.
std::vector<std::string> foreign_not_tested(const ResolvedMaterial& material);

/// A test of its own, and what it adds to the report of a material.
struct ForeignFinding {
  check::TestResult test;
  std::vector<check::Diagnosis> causes = {};  ///< empty where it passes
  std::vector<Dependence> depends_on = {};    ///< which is no failure
};

// What a UMAT or VUMAT reads or writes beyond the arrays that it is handed: the same steps with other words around
// them.

/// What a look has found: each place once.
struct Beyonds {
  std::vector<adapters::GuardedArrays::Beyond> read, written;
  std::vector<std::ptrdiff_t> left_at_times = {};  ///< of stateNew: written in some steps, and not in others
  bool any = false;                                ///< of these, wherever
};

void fields(auto& archive, Beyonds& b) { archive(b.read, b.written, b.left_at_times, b.any); }

/// For a process that has not called the model yet, which is called in others alone. Nothing for an interface that
/// tells how much it hands over.
std::optional<ForeignFinding> goes_beyond(const ResolvedMaterial& material, const check::Effort& effort);

/// In the words of descriptions. may_be_F: nine numbers behind the state may be those of F, as with IHYPER of LS-DYNA.
ForeignFinding judged_beyond(const Beyonds& found, bool may_be_F = false);

/// "1:7", "1:4, 7": indices in order.
std::string ranges_of(const std::vector<std::ptrdiff_t>& indices);

// What it takes from its host beside its step and its state: counters, places, temperatures, lengths.

/// One thing that the host tells, and other values of it.
struct HostVariation {
  struct Value {
    std::string words;  ///< "at 10"
    std::function<void(adapters::HostValues&)> set;
  };
  std::string name;  ///< as the interface has it
  bool counts;       ///< how far the host is, by which no material can tell anything
  std::vector<Value> values;
  bool of_later_steps = counts;   ///< in a point's first step set-up code looks at it, and rightly
  bool is_a_combination = false;  ///< with counters that are tried alone: it tells nothing where one of these does
  bool of_an_output = false;      ///< which the material is to set, whatever it held
};

/// Of that interface, one after the other.
std::vector<HostVariation> host_variations(const adapters::ForeignModel& model);

/// strain, pressure: of the battery's histories. Nothing for other interfaces.
std::optional<ForeignFinding> depends_on_host(const ResolvedMaterial& material, double strain, double pressure);

// Which numbers of the state are tensors that nobody has declared.

/// Components one after the other, from STATEV(first + 1) on.
struct StateBlock {
  std::size_t first;
  adapters::ForeignVariable::Kind kind;
  bool operator==(const StateBlock&) const = default;
};

/// What the state is if it is turned with a loaded body, so that the next step has the turned stress.
struct StateGuess {
  std::vector<StateBlock> blocks;  ///< empty: nothing fits
  bool turns = false;              ///< whether the numbers are more than scalars
};

/// strain, pressure: of the battery's histories.
StateGuess guessed_blocks(const ResolvedMaterial& material, const adapters::ForeignModel& model, double strain,
                          double pressure);

/// The same model with these tensors declared, by the names "STATEV(1:6)".
adapters::ForeignModel with_blocks(const adapters::ForeignModel& model, const std::vector<StateBlock>& blocks);

// Rules behind the battery: each looks for what its report leaves open, and changes the report.

/// Of a UMAT whose tangent fails: whether it is right with the other value of `strain` in its description, or cannot be
/// judged beside a state that does not turn, by which DDSDDE is converted. Of a USERMAT too: whether its tangent is
/// right by another convention.
void judge_foreign_tangent(const ResolvedMaterial& material, check::Report& report);

/// Into the test `energy` of a VUMAT, which offers no energy otherwise: work of shears and of extensions must count
/// alike, whatever density the model divides it by. Nothing of one that counts none.
void judge_energies(const ResolvedMaterial& material, check::Report& report);

/// Of an MFront behaviour that cannot be loaded at all: a tensor that begins at zero for want of an initial value in
/// its description, as the elastic part of F must not.
void tell_initial_values(const ResolvedMaterial& material, check::Report& report);

/// Of a UMAT that does not turn with the body, as its battery found: whether it is such a tensor. The diagnosis is then
/// that of the model with the tensor declared, and says how to declare it.
void judge_state_blocks(const ResolvedMaterial& material, check::Report& report);

/// With which words advice on undeclared directions, and on an undeclared tensor of the state, follows a sentence.
inline constexpr const char *advice_on_symmetry = "; no symmetry is declared",
                            *advice_on_state = "; or, if the source is right";

/// For a model that is not isotropic and whose description says nothing of `symmetry`: that it was taken for isotropic,
/// and whether it passes as one that has directions of its own. For one that fails with fixed axes: whether it passes
/// with axes that turn with the body.
void hint_symmetry(const ResolvedMaterial& material, check::Report& report);

/// Of a USERMAT that does not turn with the body: whether it does with the other of its axes.
void hint_axes(const ResolvedMaterial& material, check::Report& report);

/// Of a model whose same step is not the same again: its cause, where that is a state by element: two bodies, each with
/// an element of its own, are as either of them alone, and with one for both are not.
void judge_elements(const ResolvedMaterial& material, check::Report& report);

/// Of a UMAT that fails, and whose description says nothing of `components`: whether four cure it, or bring another
/// defect to light; its diagnosis begins with that then, and if they cure it, it is the only one. One of plane stress
/// cannot be judged unless it is declared as such (components: [3]), even where it passes with four: `error`. Throws
/// Interrupted, SystemError.
void judge_components(CheckedMaterial& checked, const check::Effort& effort, const CheckProcesses& how);

// Whether it depends on the rate, of which its description says nothing.

/// Whether its description says nothing of `flags`, and the length of a step changes its answer.
bool may_depend_on_rate(const ResolvedMaterial& material, const check::Report& report);

/// The same model, with the flag. Throws what Material does.
ResolvedMaterial as_rate_dependent(const ResolvedMaterial& material);

/// Whether the battery finds less of the model with the flag than it did without, and nothing of its clock.
bool settles_rate(const check::Report& with_flag, const check::Report& without);

/// A remark on it in the test of the clock; what the last line says of it.
Dependence say_rate(check::Report& report, double effect);

}  // namespace assay::drivers
