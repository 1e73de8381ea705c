// SPDX-License-Identifier: BSD-3-Clause
// A material in words.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "drivers/material/registry.hpp"

namespace assay::drivers {

/// What it is, where it comes from, its parameters and state; lines of at most 80 columns where its own words allow.
std::string material_text(const std::string& name, const MaterialSource& source);

/// The name, padded to that width, and the beginning of what it is: one line of at most 80 columns.
std::string material_line(const std::string& name, const MaterialSource& source, std::size_t width);

/// A registered name that leads nowhere.
std::string broken_text(const std::string& name, const std::string& reason);

std::span<const assay_parameter> parameters_of(const assay_material& table);
std::span<const assay_state_variable> state_variables_of(const assay_material& table);
std::string kind_name(std::int32_t kind);
std::string role_name(std::int32_t role);

/// "isotropic", "smooth", "rate-independent", "thread-safe", "uses total F", ...
std::vector<std::string> flag_names(const assay_material& table);

}  // namespace assay::drivers
