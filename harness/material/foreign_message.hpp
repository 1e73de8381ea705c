// SPDX-License-Identifier: BSD-3-Clause
// What a material says, for messages of one line.
#pragma once

#include <algorithm>
#include <string>

namespace assay {

/// On one line; null: none.
inline std::string one_line_of(const char* message) {
  std::string line = message ? message : "";
  std::replace_if(
      line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return line;
}

}  // namespace assay
