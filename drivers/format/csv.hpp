// SPDX-License-Identifier: BSD-3-Clause
// Separated values under a header line: numbers are written and strictly read, texts are written.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "drivers/format/csv_lines.hpp"
#include "drivers/format/number_rows.hpp"

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
  /// What has grown since it was last taken.
  std::string take() { return std::exchange(text_, {}); }

 private:
  std::size_t width_;
  std::string text_;
};

/// A number as the shortest text that reads back the same; empty where there is none, or it is not finite.
std::string csv_number(const std::optional<double>& value);

/// The same at the end of a text.
void append_csv_number(std::string& text, double value);

/// Reads lines: the first one names the columns in any order, each later one holds one finite number a column, with a
/// decimal point or, in all of the file, a decimal comma (in quotes where commas separate). Throws InputError with line
/// and column for a missing, unknown or repeated name, a wrong number of fields, what is no finite number, and a file
/// without rows.
class CsvRows final : public NumberRows {
 public:
  CsvRows(CsvLines lines, const std::vector<std::string>& required, const std::vector<std::string>& optional);

  bool next(std::vector<double>& row) override;
  double share() const override { return lines_.share(); }
  int line() const override { return lines_.line(); }

 private:
  [[noreturn]] void fail(int column, const std::string& what, const std::string& known = {}) const;
  [[noreturn]] void refuse_column(const CsvField& field) const;
  std::string separated() const;  ///< ", separated by a semicolon"
  void header(std::vector<CsvField> fields);
  bool plain_row(std::string_view line, std::vector<double>& row);
  void slow_row(std::vector<CsvField> fields, std::vector<double>& row);
  double number(const CsvField& field, const std::string& name);

  CsvLines lines_;
  std::vector<std::string> required_, known_;
  bool ends_with_separator_ = false;  ///< the header's line
  bool has_rows_ = false, seen_comma_ = false, seen_point_ = false;
};

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

/// All rows of a text, as CsvRows reads them. file: its name in messages.
CsvTable read_csv(std::string_view text, const std::string& file, const std::vector<std::string>& required,
                  const std::vector<std::string>& optional = {});

/// The bytes of a file; InputError where it cannot be read.
std::string read_input_file(const std::string& file);

}  // namespace assay::drivers
