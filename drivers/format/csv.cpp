// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/csv.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "drivers/format/number_slips.hpp"
#include "drivers/format/yaml_lines.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

/// A spreadsheet takes a text for a formula that begins with one of these; an apostrophe before it keeps it a text.
constexpr std::string_view formula_marks = "=+-@\t\r";

/// A number of a field, with a decimal point or comma; nothing for what is none.
std::optional<double> csv_value(const std::string& field) {
  if (field.find(',') == field.npos) return parse_number(field);
  if (field.find('.') != field.npos) return std::nullopt;
  std::string with_point = field;
  with_point[field.find(',')] = '.';
  return parse_number(with_point);
}

/// For a message: what cannot be seen is written out, overlong text does not reach the terminal.
std::string quoted(std::string_view text) { return "'" + shown(text, 40) + "'"; }

std::string csv_remedy(const std::string& text) {
  if (text.find('#') != text.npos) return ": only a line that begins with '#' is a remark";
  return text.empty() ? ": a field of each row must have one" : number_remedy(text);
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& file, const std::vector<std::string>& required,
         const std::vector<std::string>& optional)
      : lines_(text, file), required_(required), known_(required) {
    table_.file = file;
    append_all(known_, optional);
  }

  CsvTable read() {
    while (const auto fields = lines_.next()) table_.names.empty() ? header(*fields) : row(*fields);
    if (table_.names.empty()) fail(0, "the file holds no header line with the columns " + joined(required_));
    if (table_.rows() == 0) fail(0, "the file holds no row of numbers");
    return std::move(table_);
  }

 private:
  [[noreturn]] void fail(int column, const std::string& what, const std::string& known = {}) const {
    throw InputError(Location{table_.file, lines_.line(), column}, {}, what, known);
  }

  /// ", separated by a semicolon".
  std::string separated() const { return ", separated by " + lines_.separator_name(); }

  /// Some programs end each line with a separator.
  void header(std::vector<CsvField> fields) {
    table_.header_line = lines_.line();
    ends_with_separator_ = fields.size() > 1 && fields.back().text.empty();
    if (ends_with_separator_) fields.pop_back();
    for (const CsvField& field : fields) {
      if (!is_one_of(field.text, known_)) refuse_column(field);
      if (is_one_of(field.text, table_.names)) fail(field.column, "column " + quoted(field.text) + " twice");
      table_.names.emplace_back(field.text);
    }
    std::vector<std::string> missing;
    for (const std::string& name : required_) {
      if (!is_one_of(name, table_.names)) missing.push_back(quoted(name));
    }
    if (!missing.empty()) {
      fail(1,
           (missing.size() == 1 ? "no column " : "no columns ") + joined(missing) + "; columns are separated by " +
               lines_.separator_name() + " in this file",
           joined(known_));
    }
    table_.columns.resize(table_.names.size());
  }

  [[noreturn]] void refuse_column(const CsvField& field) const {
    if (csv_value(field.text)) {
      fail(field.column, "a number where names of columns belong, found " + quoted(field.text), joined(known_));
    }
    if (field.text.empty()) fail(field.column, "a column without a name: two separators, or more than one at the end");
    const std::size_t unit = field.text.find_first_of("[(");
    const std::string name(stripped(std::string_view(field.text).substr(0, unit)));
    if (unit != field.text.npos && is_one_of(name, known_))
      fail(field.column, "column " + quoted(field.text) + ": the name alone, " + quoted(name) + ", without its unit");
    const bool blanks = field.text.find_first_of(" \t|:") != std::string::npos;
    const bool others = field.text.find_first_of(",;") != std::string::npos;
    fail(field.column,
         unknown("column " + quoted(field.text), field.text, known_) +
             (others   ? separated() + " in this file"
              : blanks ? ": columns are separated by a comma, a semicolon or a tab"
                       : ""),
         joined(known_));
  }

  void row(std::vector<CsvField> fields) {
    if (ends_with_separator_ && fields.size() == table_.names.size() + 1 && fields.back().text.empty())
      fields.pop_back();
    if (fields.size() != table_.names.size()) {
      const std::string found = std::to_string(fields.size()) + (fields.size() == 1 ? " field" : " fields");
      const bool commas = lines_.separator() == ',' && fields.size() == 2 * table_.names.size();
      fail(fields.back().column, found + separated() + ", where the header names " +
                                     std::to_string(table_.names.size()) +
                                     (commas ? ": with decimal commas, separate by semicolons" : ""));
    }
    for (std::size_t i = 0; i < fields.size(); ++i) table_.columns[i].push_back(number(fields[i], table_.names[i]));
    table_.lines.push_back(lines_.line());
  }

  /// With a decimal point or a comma, in all of the file the same.
  double number(const CsvField& field, const std::string& name) {
    const bool comma = field.text.find(',') != std::string::npos, point = field.text.find('.') != std::string::npos;
    if (comma && point)
      fail(field.column, name + ": " + quoted(field.text) + " has a comma and a point: thousands are not separated");
    if ((comma && seen_point_) || (point && seen_comma_))
      fail(field.column, name + ": " + quoted(field.text) + ": a decimal comma and a decimal point in one file");
    const auto value = csv_value(field.text);
    if (!value || !std::isfinite(*value))
      fail(field.column,
           name + ": " + quoted(field.text) + " is no finite number" +
               (field.text.find_first_of(",;\t|") == std::string::npos ? csv_remedy(field.text) : separated()));
    seen_comma_ = seen_comma_ || comma;
    seen_point_ = seen_point_ || point;
    return *value;
  }

  CsvLines lines_;
  const std::vector<std::string>& required_;
  std::vector<std::string> known_;
  CsvTable table_;
  bool ends_with_separator_ = false;  ///< the header's line
  bool seen_comma_ = false, seen_point_ = false;
};

std::string guarded(const std::string& field) {
  const bool formula = !field.empty() && formula_marks.find(field[0]) != formula_marks.npos;
  return formula && !parse_number(field) ? "'" + field : field;
}

char separator_in(std::string_view header) {
  bool quoted = false;
  bool semicolon = false, tab = false;
  for (const char c : header.substr(0, header.find_last_not_of(" \t") + 1)) {
    if (c == '"') quoted = !quoted;
    semicolon = semicolon || (!quoted && c == ';');
    tab = tab || (!quoted && c == '\t');
  }
  const bool comma = header.find(',') != header.npos;
  return semicolon ? ';' : tab && !comma ? '\t' : ',';
}

/// Where the line ends that begins the text: a break in quotes belongs to its field.
std::size_t end_of_line(std::string_view text) {
  const std::size_t plain = std::min(text.find_first_of("\r\n"), text.size());
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == text.npos || text[first] == '#' || text.substr(0, plain).find('"') == text.npos) return plain;
  bool quoted = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '"') quoted = !quoted;
    if (!quoted && (text[at] == '\n' || text[at] == '\r')) return at;
  }
  return quoted ? plain : text.size();
}

/// What is written before a text that a spreadsheet would take for a formula is none of the text.
std::string unguarded(std::string text) {
  const bool guarded = text.size() > 1 && text[0] == '\'' && formula_marks.find(text[1]) != formula_marks.npos;
  return guarded ? text.substr(1) : text;
}

}  // namespace

void CsvText::row(std::span<const double> values) {
  assert(values.size() == width_);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text_ += ',';
    text_ += csv_number(values[i]);
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

std::string csv_number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? number_text(*value) : std::string();
}

const std::vector<double>* CsvTable::column(std::string_view name) const {
  const std::size_t at = index_of(name, names);
  return at == names.size() ? nullptr : &columns[at];
}

CsvTable read_csv(std::string_view text, const std::string& file, const std::vector<std::string>& required,
                  const std::vector<std::string>& optional) {
  return Reader(text, file, required, optional).read();
}

std::string read_input_file(const std::string& file) {
  constexpr std::size_t limit = std::size_t{256} << 20;  // some millions of points
  return read_bytes(file, limit);
}

CsvLines::CsvLines(std::string_view text, const std::string& file) : rest_(text), file_(file) {
  if (is_utf16(text)) throw InputError({file, 1, 1}, "", "UTF-16 text: save it as UTF-8");
  if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
}

std::optional<std::vector<CsvField>> CsvLines::next() {
  while (!rest_.empty()) {
    line_ += 1 + broken_;
    const std::size_t end = end_of_line(rest_);
    const std::string_view line = rest_.substr(0, end);
    broken_ = static_cast<int>(std::count(line.begin(), line.end(), '\n'));
    const bool both = rest_.substr(end).starts_with("\r\n");
    rest_.remove_prefix(std::min(end + (both ? 2 : 1), rest_.size()));
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == line.npos || line[first] == '#') continue;
    if (separator_ == 0 && line.size() == 5 && line.starts_with("sep=")) {
      separator_ = line[4];
      continue;
    }
    if (separator_ == 0) separator_ = separator_in(line);
    return split(line);
  }
  return std::nullopt;
}

std::vector<CsvField> CsvLines::split(std::string_view line) const {
  std::vector<CsvField> fields;
  for (std::size_t at = 0;; ++at) {
    fields.push_back(field(line, at));
    fields.back().text = unguarded(std::move(fields.back().text));
    if (at >= line.size()) return fields;
  }
}

/// From `at`, which is left at the separator behind the field or at the line's end.
CsvField CsvLines::field(std::string_view line, std::size_t& at) const {
  const auto is_blank = [&](std::size_t i) { return (line[i] == ' ' || line[i] == '\t') && line[i] != separator_; };
  std::size_t first = at;
  while (first < line.size() && is_blank(first)) ++first;
  CsvField found{{}, static_cast<int>(first) + 1, first < line.size() && line[first] == '"'};
  if (!found.quoted) {
    at = std::min(line.find(separator_, first), line.size());
    std::size_t last = at;
    while (last > first && is_blank(last - 1)) --last;
    found.text = line.substr(first, last - first);
    return found;
  }
  for (at = first + 1;; ++at) {
    const std::size_t quote = line.find('"', at);
    if (quote == line.npos)
      throw InputError({file_, line_, found.column}, "", "a quote that is not closed in its line");
    found.text += line.substr(at, quote - at);
    at = quote + 1;
    if (at >= line.size() || line[at] != '"') break;
    found.text += '"';
  }
  while (at < line.size() && is_blank(at)) ++at;
  if (at < line.size() && line[at] != separator_)
    throw InputError({file_, line_, static_cast<int>(at) + 1}, "", "text behind a closing quote");
  return found;
}

std::string CsvLines::separator_name() const {
  return separator_ == ','    ? "a comma"
         : separator_ == ';'  ? "a semicolon"
         : separator_ == '\t' ? "a tab"
                              : "'" + std::string(1, separator_) + "'";
}

}  // namespace assay::drivers
