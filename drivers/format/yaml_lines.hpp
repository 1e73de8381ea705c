// SPDX-License-Identifier: BSD-3-Clause
// A YAML text as it was typed: what is checked of it before a parser sees it, and its lines, for what is said of slips.
#pragma once

#include <cstddef>
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

/// Throws InputError with the place of the first fault: longer than `limit` bytes, bad UTF-8, a control character, a
/// tab in the indentation. `name` stands for the file.
void check_text(std::string_view text, const std::string& name, std::size_t limit);

/// Whether it is text of two bytes a character, with a mark of that or without.
bool is_utf16(std::string_view text);

}  // namespace assay::drivers
