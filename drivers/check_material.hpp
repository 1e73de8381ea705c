// SPDX-License-Identifier: BSD-3-Clause
// What `check` does with one material, in a process of its own.
#pragma once

#include "drivers/check_process.hpp"
#include "drivers/material/material_choice.hpp"

namespace assay::drivers {

struct CheckSettings {
  bool quick = false;
  std::string only = {};    ///< id of the one test that is wanted; empty: all
  std::string folder = {};  ///< of the replay files, one for each failure; empty: none is written
};

/// The battery and the vortex. name: as the material was asked for.
CheckedMaterial check_material(const ResolvedMaterial& material, const std::string& name, const CheckSettings& settings,
                               const CheckReporter& reporter);

/// A replay file for a failure in which the process ended; `material` of the parent's own. Throws SystemError.
void leave_replay_of_the_end(CheckedMaterial& checked, const CheckSettings& settings);

}  // namespace assay::drivers
