// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with the parts of a table, beside `defect_of` of the whole; for tables that are made of something else.
#pragma once

#include <optional>
#include <string>

#include "harness/assay_material.h"

namespace assay {

std::optional<std::string> defect_of_parameters(const assay_material& table);
std::optional<std::string> defect_of_state(const assay_material& table);

/// Of a parameter's or a variable's name: a scene and `--props` can set it, it can head a column of results.
bool can_be_a_key(const std::string& name);

}  // namespace assay
