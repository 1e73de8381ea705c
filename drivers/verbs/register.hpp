// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "drivers/material/source_options.hpp"

namespace assay::drivers {

struct RegisterOptions {
  std::string file;    ///< library, `library:name`, description, source or deck; empty with `remove`
  std::string name;    ///< empty: the material's own, or the description's file name
  std::string remove;  ///< name to take out of the registry; empty: none
  Verbosity verbosity = Verbosity::normal;
  SourceOptions source = {};
};

/// Gives a material a name in the user's registry, or removes one. Returns 0. Throws InputError, SystemError.
int register_material(const RegisterOptions& options);

}  // namespace assay::drivers
