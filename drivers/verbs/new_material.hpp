// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "drivers/text/verbosity.hpp"

namespace assay::drivers {

struct NewMaterialOptions {
  std::string name;
  std::string language;              ///< c, c++ or fortran
  std::string interface = "native";  ///< or umat, in Fortran
  std::string out;                   ///< the folder to be made; empty: the name
  Verbosity verbosity = Verbosity::normal;
};

/// Writes a project of a material. Returns 0. Throws InputError, SystemError.
int new_material(const NewMaterialOptions& options);

}  // namespace assay::drivers
