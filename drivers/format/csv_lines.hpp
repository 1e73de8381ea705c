// SPDX-License-Identifier: BSD-3-Clause
// Tables as people export them, line by line and field by field, by one splitter.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/system/input_bytes.hpp"

namespace assay::drivers {

/// Whether a spreadsheet takes a text for a formula; an apostrophe before it keeps it a text.
inline bool begins_like_formula(std::string_view text) {
  return !text.empty() && std::string_view("=+-@\t\r").find(text[0]) != text.npos;
}

struct CsvField {
  std::string text;  ///< without blanks around it, its quotes, and the apostrophe before what looks like a formula
  int column = 1;    ///< of its first character, from 1
  bool quoted = false;
};

/// Lines that are neither empty nor a remark (#), LF, CRLF or CR, after a byte order mark. The first one decides what
/// separates fields: a semicolon where it holds one, else a tab, else a comma; "sep=;" before it, as Excel writes it,
/// decides too. Fields may stand in double quotes, with line breaks, and a doubled quote is one (RFC 4180).
class CsvLines {
 public:
  /// Both outlive the reader; `file` is the name in messages.
  CsvLines(std::string_view text, const std::string& file);
  /// Of a file of any size, of which little more than a line is held. It outlives the reader.
  explicit CsvLines(const InputBytes& input);

  /// The fields of the next line, nothing at the end. Throws InputError: a quote that is not closed, text behind one,
  /// UTF-16.
  std::optional<std::vector<CsvField>> next();
  /// The next line as it stands, until the line after it is asked for, and the fields of such a line.
  std::optional<std::string_view> next_line();
  std::vector<CsvField> fields(std::string_view line) const;
  const std::string& file() const { return file_; }
  int line() const { return line_; }  ///< of what next() gave, from 1
  double share() const { return input_ ? static_cast<double>(read_) / static_cast<double>(input_->size()) : 1; }
  char separator() const { return separator_; }
  /// "a comma".
  std::string separator_name() const;

 private:
  CsvField field(std::string_view line, std::size_t& at) const;

  bool read_more();
  std::size_t whole_line();

  const InputBytes* input_ = nullptr;  ///< null: all of the text is there
  std::uint64_t read_ = 0;             ///< bytes of the input that were read
  std::vector<char> held_;             ///< of which the rest is the end
  std::string_view rest_;
  const std::string& file_;
  int line_ = 0, broken_ = 0;  ///< breaks within the fields of the line
  char separator_ = 0;
};

}  // namespace assay::drivers
