// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/result/json_figure.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace assay::drivers {

nlohmann::ordered_json json_figure(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return *value;
}

std::string json_document(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

nlohmann::ordered_json json_text(const std::string& text) {
  if (text.empty()) return nullptr;
  return text;
}

}  // namespace assay::drivers
