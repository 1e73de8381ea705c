// SPDX-License-Identifier: BSD-3-Clause
// A first look at a model that nobody has run here yet.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "harness/assay_material.h"

namespace assay::adapters {

/// Loads a library in a process of its own first, with all that its tables say. Throws LibraryError where the library
/// ends the process or hangs; what else is wrong with it the others tell. Throws std::system_error where no process can
/// be made.
void try_library(const std::string& path);

/// The given ones, and the default of each other parameter; where there is none, a value well inside its bounds: their
/// geometric mean where both are positive, their mean, else the value nearest to 1.
std::map<std::string, double> probe_parameters(const assay_material& table, std::map<std::string, double> given = {});

/// How the complaint of a model begins that comes back and refuses to be at rest: soils may, without a pressure.
inline constexpr const char* refuses_rest = "refuses an undeformed point: ";

/// Creates the material and updates one undeformed point, in a process of its own that may crash or hang, which that of
/// a remote table is: why it must be refused in one sentence, nothing where stress and state are finite. `given`: as of
/// probe_parameters. Throws std::system_error where no process can be made.
std::optional<std::string> probe_defect(const assay_material* table, const std::map<std::string, double>& given);

/// Whether the stress of a small strain is another one in 1 ms and in 1 s, of a material that has passed the probe.
bool depends_on_duration(const assay_material* table, const std::map<std::string, double>& given);

}  // namespace assay::adapters
