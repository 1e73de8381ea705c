// SPDX-License-Identifier: BSD-3-Clause
// What a description lists of a foreign model, in the model's order: PROPS and STATEV of a UMAT.
#pragma once

#include <map>
#include <string>

#include "adapters/foreign/foreign_model.hpp"
#include "drivers/format/yaml_values.hpp"

namespace assay::drivers {

constexpr int most_foreign_components = 10000;

/// Of keys of a description.
using Places = std::map<std::string, Location>;

/// Each puts what it reads behind what the model has; its place goes to `where`, under "properties.NAME".
YamlRow properties_row(adapters::ForeignModel& model, Places& where);
YamlRow state_row(adapters::ForeignModel& model, Places& where);

}  // namespace assay::drivers
