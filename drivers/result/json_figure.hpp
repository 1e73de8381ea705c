// SPDX-License-Identifier: BSD-3-Clause
// What a JSON file says where there is nothing: null. And JSON that others may have written: how deep it goes, before
// it is parsed, for parsing, copying and freeing are recursive.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace assay::drivers {

/// JSON has no infinity and no NaN: null, as where there is no value.
nlohmann::ordered_json json_figure(const std::optional<double>& value);

/// Indented, with a newline at the end; what is no UTF-8 is replaced.
std::string json_document(const nlohmann::ordered_json& json);

/// Null where it is empty.
nlohmann::ordered_json json_text(const std::string& text);

/// Whether lists and maps stand in one another more than 100 deep, which nothing of ours does.
inline bool is_nested_deeply(std::string_view text) {
  constexpr int most = 100;
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c == '\\') ++i;
      quoted = c != '"';
    } else if (c == '"') {
      quoted = true;
    } else if (c == '[' || c == '{') {
      if (++depth > most) return true;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

}  // namespace assay::drivers
