// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/study_json.hpp"

#include <nlohmann/json.hpp>

#include "drivers/result/json_fields.hpp"
#include "drivers/study/clock.hpp"

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Json load_json(const StudyFindings& findings) { return JsonFields<Json>::of(load_of(findings)); }

std::string study_json(const StudyFindings& findings) {
  Json out{{"format", study_format}, {"version", study_version}};
  out.update(JsonFields<Json>::of(findings));
  // Unlike result.json, the file has them behind the material.
  Json& origin = out["provenance"];
  for (const char* key : {"libraries", "scene_sha256"}) {
    Json value = origin[key];
    origin.erase(key);
    origin[key] = std::move(value);
  }
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace assay::drivers
