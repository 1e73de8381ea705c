// SPDX-License-Identifier: BSD-3-Clause
// What `check` says of a model that a description declares, in the words of descriptions.
#pragma once

#include "drivers/check/check_report.hpp"
#include "drivers/material/material_choice.hpp"
#include "harness/check/battery.hpp"

namespace assay::drivers {

/// The test of that id, where it fails; null otherwise.
check::TestResult* failed_test(check::Report& report, const char* id);

/// Another sentence, with the test's cause, in the diagnosis too.
void say_instead(check::Report& report, check::TestResult& test, const std::string& sentence);

/// More words behind a sentence, wherever it stands.
void say_also(check::Report& report, const std::string& sentence, const std::string& more);

/// In the process of the check points have the element that its tests give them.
void keep_elements(const Material& material);

/// Where a variable of that name begins in the state; the size of the state where there is none.
std::size_t place_in_state(const assay_material& table, const std::string& name);

/// A model made as the tests need it: with keep_elements. Throws what Material does.
Material made_for_tests(const adapters::ForeignModel& model, const std::map<std::string, double>& parameters);

/// Those of the ABI for a native model.
check::Declarations declarations_of(const ResolvedMaterial& material);

/// Of a UMAT whose tangent fails: whether it is right with the other value of `strain` in its description, or cannot be
/// judged beside a state that does not turn, by which DDSDDE is converted.
void judge_foreign_tangent(const ResolvedMaterial& material, check::Report& report);

/// Of an MFront behaviour that cannot be loaded at all: a tensor that begins at zero for want of an initial value in
/// its description, as the elastic part of F must not.
void tell_initial_values(const ResolvedMaterial& material, check::Report& report);

/// What of a foreign model the tests leave as it is.
std::vector<std::string> foreign_not_tested(const ResolvedMaterial& material);

/// Whether it was a model of our own interface, to which its rules apply.
bool is_native(const CheckedMaterial& checked);

}  // namespace assay::drivers
