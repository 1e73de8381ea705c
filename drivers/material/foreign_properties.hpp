// SPDX-License-Identifier: BSD-3-Clause
// The constants of a foreign model, PROPS of a UMAT, as a description gives them: names, numbers, or a map of both.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "adapters/foreign/foreign_model.hpp"
#include "drivers/format/yaml_reader.hpp"

namespace assay::drivers {

/// A scalar that reads as a number.
std::optional<double> number_in(const Tree& tree);

/// "p1" of the first.
std::string numbered(const std::string& stem, std::size_t k);

/// Behind those that the model has; where each stands goes to `where`, under "properties.NAME". Throws InputError.
void read_properties(const Tree& tree, adapters::ForeignModel& model, std::map<std::string, Location>& where);

}  // namespace assay::drivers
