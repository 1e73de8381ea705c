// SPDX-License-Identifier: BSD-3-Clause
// What `assay check` is asked to check.
#pragma once

#include <map>
#include <string>

#include "drivers/check/check.hpp"
#include "drivers/material/material_choice.hpp"

namespace assay::drivers {

/// "E=1e3,nu=0.3": names and numbers. Throws InputError.
std::map<std::string, double> parameters_in(const std::string& list);

/// The material of a scene, a source, a description, a library or a name, made in a worker. Throws InputError.
ResolvedMaterial material_to_check(const CheckOptions& options);

/// At what its author shows it, where its parameters have no default; `given` before all, as far as it takes them.
ResolvedMaterial registered_material(const std::string& name, const std::map<std::string, double>& given);

}  // namespace assay::drivers
