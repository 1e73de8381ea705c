// SPDX-License-Identifier: BSD-3-Clause
// The keys of a description that is not native: what a UMAT, a VUMAT or an MFront behaviour does not say of itself.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "adapters/foreign/foreign_model.hpp"
#include "drivers/format/yaml_reader.hpp"
#include "drivers/format/yaml_values.hpp"

namespace assay::drivers {

/// native, umat, vumat, mfront.
const std::vector<std::string>& interface_names();

/// Keys of a description beside those of a native one.
const std::vector<std::string>& foreign_keys();
/// Those of them that an MFront behaviour has no use for.
const std::vector<std::string>& keys_of_abaqus();
/// Keys that would have no effect with an interface other than native.
std::vector<std::string> keys_without_effect(const std::string& interface);

/// Of a description whose `interface` is one of those. `library` is absolute, `name` that of the table where the file
/// gives none. The place of every key goes to `where`. Throws InputError.
adapters::ForeignModel read_foreign(const Tree& root, const std::string& interface, const std::string& library,
                                    const std::string& name, std::map<std::string, Location>& where);

/// Lines of YAML that read back to the same.
std::string foreign_yaml(const adapters::ForeignModel& model);

constexpr int most_foreign_components = 10000;

/// Of keys of a description.
using Places = std::map<std::string, Location>;

/// Each puts what it reads behind what the model has; its place goes to `where`, under "properties.NAME".
YamlRow properties_row(adapters::ForeignModel& model, Places& where);
YamlRow state_row(adapters::ForeignModel& model, Places& where);

}  // namespace assay::drivers
