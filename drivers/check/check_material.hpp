// SPDX-License-Identifier: BSD-3-Clause
// One material in a process of the check's own: what it is judged by, in this order.
#pragma once

#include "drivers/check/check_process.hpp"
#include "drivers/material/material_choice.hpp"

namespace assay::drivers {

/// What the model does to the process that runs it; a whole run with it.
inline constexpr const char *process_test = "calls.process", *vortex_test = "vortex";

/// Those of the battery, and beyond.
std::vector<std::string> tests_of_check();

struct CheckSettings {
  check::Effort effort = {};
  std::string only = {};        ///< id of the one test that is wanted; empty: all
  std::string folder = {};      ///< of the replay files, one for each failure; empty: none is written
  std::string place = {};       ///< that folder wherever a process stands
  std::string without = {};     ///< id of a test that is left out
  bool well_aligned = false;    ///< of calls.arrays: as check::Options has it
  bool rate_dependent = false;  ///< what its description leaves open is settled: it depends on the rate
};

/// The same with its code where this is called, which is to be a process that may die.
ResolvedMaterial in_this_process(const ResolvedMaterial& apart);

/// The battery and the vortex. name: as the material was asked for.
CheckedMaterial check_material(const ResolvedMaterial& material, const std::string& name, const CheckSettings& settings,
                               const CheckReporter& reporter);

/// Of that, the battery, and around it what a foreign interface leaves open. Into `checked`: the report, and what the
/// answer depends on. What the material was taken for instead, where its description leaves open what the answers
/// settle.
std::optional<ResolvedMaterial> judge(const ResolvedMaterial& material, const CheckSettings& settings,
                                      const CheckReporter& reporter, CheckedMaterial& checked);

/// The error of a whole run with the material against that of neo-Hookean elasticity of the same stiffness at rest:
/// stress, state and batches as a particle code uses them. Not applicable where the vortex is no test of the material.
/// ellipticity: the battery's measure, null where it has none.
check::TestResult end_to_end_vortex(const ResolvedMaterial& material, std::optional<double> ellipticity);

/// Of a native model, which is not to print: much is a defect, in calls.process; a little is a remark there.
void judge_printing(CheckedMaterial& checked);

/// A replay file for a failure that the process of the check could not leave: its end, or what it printed. Throws
/// SystemError.
void leave_replay_of_the_end(CheckedMaterial& checked, const CheckSettings& settings);

}  // namespace assay::drivers
