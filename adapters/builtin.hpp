// SPDX-License-Identifier: BSD-3-Clause
// The models that are part of the program.
#pragma once

#include <string>
#include <vector>

#include "harness/assay_material.h"

namespace assay::adapters {

/// All of them, sorted by name.
const std::vector<const assay_material*>& builtin_tables();

/// Null where there is none of that name.
const assay_material* builtin_table(const std::string& name);

}  // namespace assay::adapters
