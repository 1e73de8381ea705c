// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "drivers/text/verbosity.hpp"

namespace assay::drivers {

struct TabulateOptions {
  std::string scene;
  std::string out;  ///< folder, as in RunOptions
  std::vector<std::string> sets;
  std::string points;  ///< CSV of xi,t; empty: none
  bool json = false;
  Verbosity verbosity = Verbosity::normal;
};

/// Leaves the sheet of a scene's material, its slope and its curve in the folder. Returns the exit status, as run().
/// Throws InputError, SystemError.
int tabulate(const TabulateOptions& options);

}  // namespace assay::drivers
