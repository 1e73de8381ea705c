// SPDX-License-Identifier: BSD-3-Clause
// Problems made ready to be exported, for tests.
#pragma once

#include <string>

#include "drivers/export/export.hpp"
#include "drivers/format/csv.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers {

inline const std::string plane_vortex = tree_folder() + "/configs/library/plane_vortex.yaml";

inline ExportOptions export_options(const std::string& target, const std::string& grids,
                                    const std::string& scene = plane_vortex,
                                    const std::vector<std::string>& sets = {}) {
  ExportOptions options;
  options.scene = scene, options.target = target, options.grids = grids, options.sets = sets;
  options.verbosity = Verbosity::quiet;
  return options;
}

inline ExportedProblem exported(const ExportOptions& options) {
  return export_problem(options, target_of(options.target));
}

/// All files by their paths.
inline std::map<std::string, std::string> exported_files(const ExportOptions& options) {
  return folder_of(exported(options), target_of(options.target));
}

}  // namespace assay::drivers
