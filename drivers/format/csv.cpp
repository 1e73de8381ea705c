// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/csv.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "drivers/format/number_slips.hpp"
#include "drivers/format/yaml_lines.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace {

/// For a message: what cannot be seen is written out, overlong text does not reach the terminal.
std::string quoted(std::string_view text) { return "'" + shown(text, 40) + "'"; }

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

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
    known_.insert(known_.end(), optional.begin(), optional.end());
  }

  CsvTable read() {
    while (const auto fields = lines_.next()) {
      if (table_.names.empty()) {
        header(*fields);
      } else {
        row(*fields);
      }
    }
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
      if (!contains(known_, field.text)) refuse_column(field);
      if (contains(table_.names, field.text)) fail(field.column, "column " + quoted(field.text) + " twice");
      table_.names.emplace_back(field.text);
    }
    std::vector<std::string> missing;
    for (const std::string& name : required_) {
      if (!contains(table_.names, name)) missing.push_back(quoted(name));
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
    if (csv_value(field.text, true)) {
      fail(field.column, "a number where names of columns belong, found " + quoted(field.text), joined(known_));
    }
    if (field.text.empty()) fail(field.column, "a column without a name: two separators, or more than one at the end");
    const std::size_t unit = field.text.find_first_of("[(");
    const std::string name(stripped(std::string_view(field.text).substr(0, unit)));
    if (unit != field.text.npos && contains(known_, name))
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
    const auto value = csv_value(field.text, true);
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

}  // namespace

CsvText::CsvText(const std::vector<std::string>& names) : width_(names.size()) {
  for (std::size_t i = 0; i < names.size(); ++i) text_ += (i ? "," : "") + names[i];
  text_ += '\n';
}

void CsvText::row(std::span<const double> values) {
  assert(values.size() == width_);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text_ += ',';
    if (std::isfinite(values[i])) text_ += number_text(values[i]);
  }
  text_ += '\n';
}

void CsvFields::row(const std::vector<std::string>& fields) {
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
  const auto at = std::find(names.begin(), names.end(), name);
  return at == names.end() ? nullptr : &columns[static_cast<std::size_t>(at - names.begin())];
}

CsvTable read_csv(std::string_view text, const std::string& file, const std::vector<std::string>& required,
                  const std::vector<std::string>& optional) {
  return Reader(text, file, required, optional).read();
}

std::string read_input_file(const std::string& file) {
  constexpr std::size_t limit = std::size_t{256} << 20;  // some millions of points
  return read_bytes(file, limit);
}

}  // namespace assay::drivers
