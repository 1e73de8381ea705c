// SPDX-License-Identifier: BSD-3-Clause
// The external state variables of an MTest file as fields of a material.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "drivers/point_drivers/mtest_file.hpp"
#include "drivers/scene/scene.hpp"
#include "harness/material/material.hpp"

namespace assay::drivers {

struct MtestFields {
  std::map<std::string, FieldOfTime> values;  ///< by the name of the model's field
  std::vector<std::string> notes;             ///< sentences on variables that the model does not take
};

/// Lets the fields of the choice vary that the file names. A temperature that a model does not take is left out, as
/// MTest does. Throws InputError: what cannot be served, and what find_material() throws.
MtestFields mtest_fields(const MtestFile& file, MaterialChoice& choice);

/// The strain of the properties ThermalExpansion, or ThermalExpansion1, 2, 3 along the material's axes, which MTest
/// takes off the strain that it gives to a behaviour of small strain. None where there is none.
std::optional<Tensor> thermal_strain(const MtestFile& file, double t);

}  // namespace assay::drivers
