// SPDX-License-Identifier: BSD-3-Clause
// Sentences and cells of tables on a terminal.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drivers/text/numbers.hpp"

namespace assay::drivers {

/// The words of a text on lines of at most `width` columns: `first` begins the first line, `rest` the others. Ends with
/// a newline. A word that is longer than a line stands alone on one.
std::string wrapped(const std::string& text, const std::string& first, const std::string& rest, std::size_t width = 80);

/// The beginning of a sentence, cut between words: where it is longer than `length`, " ..." follows.
std::string cut_text(const std::string& text, std::size_t length);

/// Of UTF-8.
inline std::size_t characters(const std::string& text) {
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins));
}

/// The text with blanks up to that width in characters.
inline std::string padded(std::string text, std::size_t width) {
  const std::size_t has = characters(text);
  text.append(std::max(has, width) - has, ' ');
  return text;
}

/// Two digits, "infinite", or "-" where there is none.
inline std::string measured_text(const std::optional<double>& value) {
  if (!value) return "-";
  return std::isinf(*value) ? "infinite" : rounded_text(*value, 2);
}

/// "1 test passed", "37 tests passed".
inline std::string tests_passed(std::int64_t count) {
  return std::to_string(count) + (count == 1 ? " test passed" : " tests passed");
}

/// A line of a table in Markdown.
inline std::string markdown_line(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

/// A line without blanks at its end.
inline std::string table_line(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

}  // namespace assay::drivers
