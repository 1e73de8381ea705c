// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/case_list.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

namespace {

std::string state_text(const PlannedCase& one, const CaseStore& store) {
  if (!one.invalid.empty()) return "n/a";
  constexpr const char* names[] = {"finished", "missing", "torn", "crashed", "stopped"};
  return names[static_cast<std::size_t>(store.state_of(one.key))];
}

}  // namespace

std::string list_text(const Plan& plan, const CaseStore& store) {
  std::string text;
  for (const PlannedCase& one : plan.cases) {
    text += std::to_string(one.number) + "\t" + (one.key.empty() ? "-" : one.key) + "\t" + state_text(one, store) +
            "\t" + std::to_string(std::llround(one.particle_steps)) + "\t" + one_line(one.label) + "\n";
  }
  return text;
}

std::string list_json(const Plan& plan, const CaseStore& store) {
  using Json = nlohmann::ordered_json;
  Json all = Json::array();
  for (const PlannedCase& one : plan.cases) {
    Json values = Json::object();
    for (const AxisValue& value : one.values) values[value.axis] = value.value;
    all.push_back(Json::object({{"number", one.number},
                                {"key", one.key.empty() ? Json(nullptr) : Json(one.key)},
                                {"state", state_text(one, store)},
                                {"threads", one.threads},
                                {"timed", one.timed},
                                {"particle_steps", one.particle_steps},
                                {"label", one.label},
                                {"values", values},
                                {"reason", one.invalid.empty() ? Json(nullptr) : Json(one.invalid)}}));
  }
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace assay::drivers
