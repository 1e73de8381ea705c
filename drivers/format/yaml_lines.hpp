// SPDX-License-Identifier: BSD-3-Clause
// A YAML text as it was typed: what is checked of it before a parser sees it, and its lines, for what is said of slips.
#pragma once

#include <cstddef>
#include <optional>
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

// What a user may have done where a text is no YAML, or YAML of another meaning than was meant.

struct YamlSlip {
  int line = 0, column = 0;  ///< from 1
  std::string what;          ///< the cause, and what to write instead
};

/// The slip behind a parser's complaint at a line and a column, from 1; nothing where none is known.
std::optional<YamlSlip> yaml_slip(std::string_view text, int line, int column);

struct BracketedList {
  std::size_t back = 0;  ///< bytes from the place that was asked of to the bracket
  std::string what;      ///< the cause, and what to write instead
};

/// Around a byte of a line: numbers in other brackets than those of a list, "(2, 2)".
std::optional<BracketedList> list_in_other_brackets(std::string_view text, std::size_t byte);

/// To follow what is said of a text that stands where a key, or a map of keys, belongs: ": a blank belongs after ':'";
/// empty for a text without such a slip.
std::string key_remedy(const std::string& text);

/// What is wrong with the quoted scalar whose event is at a byte, not counting a byte order mark: it is not closed, or
/// a later quote closes it and lines that are keys would be its text. Nothing where all is well, and where no quote
/// stands there.
std::optional<YamlSlip> quote_slip(std::string_view text, std::size_t byte);

}  // namespace assay::drivers
