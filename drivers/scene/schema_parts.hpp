// SPDX-License-Identifier: BSD-3-Clause
// Pieces of the JSON Schemas that are written by hand: those of studies and of paths.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace assay::drivers::schema_parts {

using Json = nlohmann::ordered_json;

Json text();
Json number();
Json described(Json schema, const std::string& doc);

/// A map with these keys and no others, but those that are merged into it.
Json object(Json properties, const std::vector<std::string>& required = {});

}  // namespace assay::drivers::schema_parts
