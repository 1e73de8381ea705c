// SPDX-License-Identifier: BSD-3-Clause
// Separated values under a header line: numbers are written and strictly read, texts are written. Tables as people
// export them are read line by line and field by field, by one splitter.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

/// Grows row by row. Numbers are the shortest text that reads back the same, what is not finite an empty field. Texts
/// with a separator, a quote or a line break stand in quotes (RFC 4180). One that a spreadsheet would take for a
/// formula, because it begins with = + - or @ and is no number, gets an apostrophe.
class CsvText {
 public:
  explicit CsvText(const std::vector<std::string>& names) : width_(names.size()) { row(names); }
  /// As many fields as there are names.
  void row(std::span<const double> values);
  void row(const std::vector<std::string>& fields);
  const std::string& text() const { return text_; }

 private:
  std::size_t width_;
  std::string text_;
};

/// A number as the shortest text that reads back the same; empty where there is none, or it is not finite.
std::string csv_number(const std::optional<double>& value);

struct CsvTable {
  std::string file;
  std::vector<std::string> names;            ///< as in the file's header
  std::vector<std::vector<double>> columns;  ///< one a name, all of one length; finite
  int header_line = 0;                       ///< from 1
  std::vector<int> lines;                    ///< line of each row, from 1
  std::size_t rows() const { return lines.size(); }
  /// Null where the file has no such column.
  const std::vector<double>* column(std::string_view name) const;
};

/// Reads text (`file` is its name in messages), split as CsvLines has it: the first line names the columns in any
/// order, each later one holds one finite number a column, with a decimal point or, in all of the file, a decimal comma
/// (in quotes where commas separate). Throws InputError with line and column for a missing, unknown or repeated name, a
/// wrong number of fields, what is no finite number, and a file without rows.
CsvTable read_csv(std::string_view text, const std::string& file, const std::vector<std::string>& required,
                  const std::vector<std::string>& optional = {});

/// The bytes of a file; InputError where it cannot be read.
std::string read_input_file(const std::string& file);

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

}  // namespace assay::drivers
