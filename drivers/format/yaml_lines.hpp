// SPDX-License-Identifier: BSD-3-Clause
// Lines of a YAML text as they were typed, for what is said of slips in it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drivers/text/words.hpp"

namespace assay::drivers {

/// Without their ends.
std::vector<std::string_view> yaml_lines(std::string_view text);

/// The blanks before its first character.
std::size_t indent_of(std::string_view line);

/// A line as its characters outside of quotes and remarks; what is inside is blanked. `open`: the quote that the line
/// leaves open, npos without one.
struct Bare {
  std::string text;
  std::size_t open = std::string::npos;
};

Bare bare(std::string_view line);

/// Where a colon ends a key: before a blank, a bracket that closes or the end.
std::size_t key_colon(std::string_view text, std::size_t from = 0);

bool has_key(std::string_view line);

}  // namespace assay::drivers
