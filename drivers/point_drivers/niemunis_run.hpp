// SPDX-License-Identifier: BSD-3-Clause
// A loading file of Niemunis' incremental driver taken along.
#pragma once

#include <string>

#include "drivers/findings/run_options.hpp"

namespace assay::drivers {

/// Whether a file's name ends as those of the incremental driver do: .inp.
bool is_niemunis(const std::string& file);

/// Takes the material through the steps of the file, from the stress and state in initialconditions.inp beside it.
/// Leaves path.csv and result.json. Returns the exit status. Throws InputError.
int tabulate_niemunis(const SceneOptions& options, const std::string& material);

}  // namespace assay::drivers
