// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "drivers/text/verbosity.hpp"

namespace assay::drivers {

struct ExplainOptions {
  std::string scene;
  std::vector<std::string> sets;
  bool json = false;
  Verbosity verbosity = Verbosity::normal;
};

/// Prints what a run of the scene consists of. Returns 1 where the material fails. Throws InputError, SystemError.
int explain(const ExplainOptions& options);

}  // namespace assay::drivers
