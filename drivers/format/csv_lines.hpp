// SPDX-License-Identifier: BSD-3-Clause
// Tables as people export them, line by line and field by field: the one splitter of all that is read as CSV.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

/// A spreadsheet takes a text for a formula that begins with one of these; an apostrophe before it keeps it a text.
inline constexpr std::string_view formula_marks = "=+-@\t\r";

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

  /// The fields of the next line, nothing at the end. Throws InputError: a quote that is not closed, text behind one,
  /// UTF-16.
  std::optional<std::vector<CsvField>> next();
  int line() const { return line_; }  ///< of what next() gave, from 1
  char separator() const { return separator_; }
  /// "a comma".
  std::string separator_name() const;

 private:
  std::vector<CsvField> split(std::string_view line) const;
  CsvField field(std::string_view line, std::size_t& at) const;

  std::string_view rest_;
  const std::string& file_;
  int line_ = 0, broken_ = 0;  ///< breaks within the fields of the line
  char separator_ = 0;
};

/// A number of a field, with a decimal comma in place of the point where `comma` says so; nothing for what is none.
std::optional<double> csv_value(const std::string& field, bool comma = false);

}  // namespace assay::drivers
