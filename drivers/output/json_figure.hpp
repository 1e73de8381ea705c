// SPDX-License-Identifier: BSD-3-Clause
// What a JSON file says where there is nothing: null.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace assay::drivers {

/// JSON has no infinity and no NaN: null, as where there is no value.
inline nlohmann::ordered_json json_figure(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return *value;
}

/// Null where it is empty.
inline nlohmann::ordered_json json_text(const std::string& text) {
  if (text.empty()) return nullptr;
  return text;
}

}  // namespace assay::drivers
