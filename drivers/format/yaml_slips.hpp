// SPDX-License-Identifier: BSD-3-Clause
// What a user may have done where a text is no YAML, or YAML of another meaning than was meant; quotes that swallow
// what follows, which a parser does not mind.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace assay::drivers {

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
