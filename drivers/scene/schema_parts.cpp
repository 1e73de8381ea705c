// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/schema_parts.hpp"

#include <nlohmann/json.hpp>

#include "drivers/scene/scene_keys.hpp"

namespace assay::drivers::schema_parts {

Json text() { return {{"type", "string"}}; }

Json number() { return {{"type", "number"}}; }

Json described(Json schema, const std::string& doc) {
  schema["description"] = doc;
  return schema;
}

Json object(Json properties, const std::vector<std::string>& required) {
  properties[merge_name] = Json::object();
  Json out{{"type", "object"}, {"additionalProperties", false}, {"properties", properties}};
  if (!required.empty()) out["required"] = required;
  return out;
}

}  // namespace assay::drivers::schema_parts
