// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/csv.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

#include "drivers/format/number_slips.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

/// A number of a field, with a decimal point or comma; nothing for what is none.
std::optional<double> csv_value(const std::string& field) {
  if (field.find(',') == field.npos) return parse_number(field);
  if (field.find('.') != field.npos) return std::nullopt;
  std::string with_point = field;
  with_point[field.find(',')] = '.';
  return parse_number(with_point);
}

/// For a message: what cannot be seen is written out, overlong text does not reach the terminal.
std::string quoted_text(std::string_view text) { return "'" + shown(text, 40) + "'"; }

std::string csv_remedy(const std::string& text) {
  if (text.find('#') != text.npos) return ": only a line that begins with '#' is a remark";
  return text.empty() ? ": a field of each row must have one" : number_remedy(text);
}

std::string guarded(const std::string& field) {
  const bool formula = begins_like_formula(field);
  return formula && !parse_number(field) ? "'" + field : field;
}

}  // namespace

void CsvText::row(std::span<const double> values) {
  assert(values.size() == width_);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text_ += ',';
    append_csv_number(text_, values[i]);
  }
  text_ += '\n';
}

void CsvText::row(const std::vector<std::string>& fields) {
  assert(fields.size() == width_);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) text_ += ',';
    const std::string field = guarded(without_commands(fields[i], "<U+", ">"));
    if (field.find_first_of(",;\"\t\r\n") == std::string::npos) {
      text_ += field;
      continue;
    }
    text_ += '"';
    for (const char c : field) text_ += c == '"' ? std::string(2, c) : std::string(1, c);
    text_ += '"';
  }
  text_ += '\n';
}

void append_csv_number(std::string& text, double value) {
  if (!std::isfinite(value)) return;
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

std::string csv_number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? number_text(*value) : std::string();
}

const std::vector<double>* CsvTable::column(std::string_view name) const {
  const std::size_t at = index_of(name, names);
  return at == names.size() ? nullptr : &columns[at];
}

CsvRows::CsvRows(CsvLines lines, const std::vector<std::string>& required, const std::vector<std::string>& optional)
    : lines_(std::move(lines)), required_(required), known_(required) {
  append_all(known_, optional);
  auto fields = lines_.next();
  if (!fields) fail(0, "the file holds no header line with the columns " + joined(required_));
  header(std::move(*fields));
}

bool CsvRows::next(std::vector<double>& row) {
  const auto line = lines_.next_line();
  if (!line && !has_rows_) fail(0, "the file holds no row of numbers");
  if (!line) return false;
  has_rows_ = true;
  row.resize(names_.size());
  if (!plain_row(*line, row)) slow_row(lines_.fields(*line), row);
  return true;
}

void CsvRows::fail(int column, const std::string& what, const std::string& known) const {
  throw InputError(Location{lines_.file(), lines_.line(), column}, {}, what, known);
}

std::string CsvRows::separated() const { return ", separated by " + lines_.separator_name(); }

/// Some programs end each line with a separator.
void CsvRows::header(std::vector<CsvField> fields) {
  header_line_ = lines_.line();
  ends_with_separator_ = fields.size() > 1 && fields.back().text.empty();
  if (ends_with_separator_) fields.pop_back();
  for (const CsvField& field : fields) {
    if (!is_one_of(field.text, known_)) refuse_column(field);
    if (is_one_of(field.text, names_)) fail(field.column, "column " + quoted_text(field.text) + " twice");
    names_.emplace_back(field.text);
  }
  std::vector<std::string> missing;
  for (const std::string& name : required_) {
    if (!is_one_of(name, names_)) missing.push_back(quoted_text(name));
  }
  if (!missing.empty()) {
    fail(1,
         (missing.size() == 1 ? "no column " : "no columns ") + joined(missing) + "; columns are separated by " +
             lines_.separator_name() + " in this file",
         joined(known_));
  }
}

void CsvRows::refuse_column(const CsvField& field) const {
  if (csv_value(field.text)) {
    fail(field.column, "a number where names of columns belong, found " + quoted_text(field.text), joined(known_));
  }
  if (field.text.empty()) fail(field.column, "a column without a name: two separators, or more than one at the end");
  const std::size_t unit = field.text.find_first_of("[(");
  const std::string name(stripped(std::string_view(field.text).substr(0, unit)));
  if (unit != field.text.npos && is_one_of(name, known_))
    fail(field.column,
         "column " + quoted_text(field.text) + ": the name alone, " + quoted_text(name) + ", without its unit");
  const bool blanks = field.text.find_first_of(" \t|:") != std::string::npos;
  const bool others = field.text.find_first_of(",;") != std::string::npos;
  fail(field.column,
       unknown("column " + quoted_text(field.text), field.text, known_) +
           (others   ? separated() + " in this file"
            : blanks ? ": columns are separated by a comma, a semicolon or a tab"
                     : ""),
       joined(known_));
}

/// Finite numbers as nearly all tables have them: without quotes, signs of plus and decimal commas. False for any other
/// row, whatever was filled in.
bool CsvRows::plain_row(std::string_view line, std::vector<double>& row) {
  if (seen_comma_) return false;
  const char separator = lines_.separator();
  const char *at = line.data(), *const end = at + line.size();
  const auto skip_blanks = [&] {
    while (at < end && (*at == ' ' || *at == '\t') && *at != separator) ++at;
  };
  bool point = false;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0 && (at == end || *at++ != separator)) return false;
    skip_blanks();
    const auto [behind, error] = std::from_chars(at, end, row[i]);
    if (error != std::errc() || !std::isfinite(row[i])) return false;
    point = point || std::find(at, behind, '.') != behind;
    at = behind;
    skip_blanks();
  }
  seen_point_ = seen_point_ || (at == end && point);
  return at == end;
}

void CsvRows::slow_row(std::vector<CsvField> fields, std::vector<double>& row) {
  if (ends_with_separator_ && fields.size() == names_.size() + 1 && fields.back().text.empty()) fields.pop_back();
  if (fields.size() != names_.size()) {
    const std::string found = std::to_string(fields.size()) + (fields.size() == 1 ? " field" : " fields");
    const bool commas = lines_.separator() == ',' && fields.size() == 2 * names_.size();
    fail(fields.back().column, found + separated() + ", where the header names " + std::to_string(names_.size()) +
                                   (commas ? ": with decimal commas, separate by semicolons" : ""));
  }
  for (std::size_t i = 0; i < fields.size(); ++i) row[i] = number(fields[i], names_[i]);
}

/// With a decimal point or a comma, in all of the file the same.
double CsvRows::number(const CsvField& field, const std::string& name) {
  const bool comma = field.text.find(',') != std::string::npos, point = field.text.find('.') != std::string::npos;
  if (comma && point)
    fail(field.column, name + ": " + quoted_text(field.text) + " has a comma and a point: thousands are not separated");
  if ((comma && seen_point_) || (point && seen_comma_))
    fail(field.column, name + ": " + quoted_text(field.text) + ": a decimal comma and a decimal point in one file");
  const auto value = csv_value(field.text);
  if (!value || !std::isfinite(*value))
    fail(field.column,
         name + ": " + quoted_text(field.text) + " is no finite number" +
             (field.text.find_first_of(",;\t|") == std::string::npos ? csv_remedy(field.text) : separated()));
  seen_comma_ = seen_comma_ || comma;
  seen_point_ = seen_point_ || point;
  return *value;
}

CsvTable read_csv(std::string_view text, const std::string& file, const std::vector<std::string>& required,
                  const std::vector<std::string>& optional) {
  CsvRows rows(CsvLines(text, file), required, optional);
  CsvTable table{file, rows.names(), std::vector<std::vector<double>>(rows.names().size()), rows.header_line(), {}};
  for (std::vector<double> row; rows.next(row);) {
    for (std::size_t i = 0; i < row.size(); ++i) table.columns[i].push_back(row[i]);
    table.lines.push_back(rows.line());
  }
  return table;
}

std::string read_input_file(const std::string& file) {
  constexpr std::size_t limit = std::size_t{256} << 20;  // some millions of points
  return read_bytes(file, limit);
}

}  // namespace assay::drivers
