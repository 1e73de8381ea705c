// SPDX-License-Identifier: BSD-3-Clause
// JSON that others may have written: how deep it goes, before it is parsed. Parsing, copying and freeing are recursive.
#pragma once

#include <string_view>

namespace assay::drivers {

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
