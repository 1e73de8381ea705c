// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "drivers/text/verbosity.hpp"

namespace assay::drivers {

struct EvalOptions {
  std::string scene;
  std::string points;  ///< CSV of X,Y,t
  std::string out;     ///< CSV file; empty: standard output
  std::vector<std::string> sets;
  Verbosity verbosity = Verbosity::normal;
};

/// Writes the exact fields of a motion at the points. Returns 1 where the material fails. Throws InputError,
/// SystemError.
int eval(const EvalOptions& options);

}  // namespace assay::drivers
