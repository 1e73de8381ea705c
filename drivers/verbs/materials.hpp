// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "drivers/text/verbosity.hpp"

namespace assay::drivers {

struct MaterialsOptions {
  std::string name = {};  ///< registered name, library or description; empty: all that is registered
  bool json = false;
  bool names = false;  ///< of all that is registered, without a look into the libraries
  Verbosity verbosity = Verbosity::normal;
};

/// Prints what is registered, or one material. Returns 0. Throws InputError, SystemError.
int materials(const MaterialsOptions& options);

}  // namespace assay::drivers
