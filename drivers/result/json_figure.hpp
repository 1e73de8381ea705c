// SPDX-License-Identifier: BSD-3-Clause
// What a JSON file says where there is nothing: null.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace assay::drivers {

/// JSON has no infinity and no NaN: null, as where there is no value.
nlohmann::ordered_json json_figure(const std::optional<double>& value);

/// Indented, with a newline at the end; what is no UTF-8 is replaced.
std::string json_document(const nlohmann::ordered_json& json);

/// Null where it is empty.
nlohmann::ordered_json json_text(const std::string& text);

}  // namespace assay::drivers
