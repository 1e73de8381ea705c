// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/csv.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "drivers/input_error.hpp"
#include "drivers/output/numbers.hpp"
#include "drivers/scene/yaml_reader.hpp"

namespace assay::drivers {

namespace {

struct Field {
  std::string_view text;
  int column = 1;  ///< of its first character
};

bool blank(char c) { return c == ' ' || c == '\t'; }

std::vector<Field> split(std::string_view line) {
  std::vector<Field> fields;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = std::min(line.find(',', begin), line.size());
    std::size_t first = begin, last = comma;
    while (first < last && blank(line[first])) ++first;
    while (last > first && blank(line[last - 1])) --last;
    fields.push_back({line.substr(first, last - first), static_cast<int>(first) + 1});
    if (comma == line.size()) return fields;
    begin = comma + 1;
  }
}

/// For a message: control characters and overlong text do not reach the terminal.
std::string quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text.substr(0, 40)) out += static_cast<unsigned char>(c) < 32 || c == 127 ? '?' : c;
  return out + (text.size() > 40 ? "...'" : "'");
}

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

class Reader {
 public:
  Reader(const std::string& file, const std::vector<std::string>& required, const std::vector<std::string>& optional)
      : required_(required), known_(required) {
    table_.file = file;
    known_.insert(known_.end(), optional.begin(), optional.end());
  }

  CsvTable read(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    while (!text.empty()) {
      ++line_;
      const std::size_t end = std::min(text.find('\n'), text.size());
      std::string_view line = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      if (line.ends_with('\r')) line.remove_suffix(1);
      const std::size_t first = line.find_first_not_of(" \t");
      if (first == std::string_view::npos || line[first] == '#') continue;
      if (table_.names.empty()) {
        header(split(line));
      } else {
        row(split(line));
      }
    }
    if (table_.names.empty()) fail(line_, 0, "the file holds no header line with the columns " + joined(required_));
    if (table_.rows() == 0) fail(line_, 0, "the file holds no row of numbers");
    return std::move(table_);
  }

 private:
  [[noreturn]] void fail(int line, int column, const std::string& what, const std::string& known = {}) const {
    throw InputError(Location{table_.file, line, column}, {}, what, known);
  }

  void header(const std::vector<Field>& fields) {
    table_.header_line = line_;
    for (const Field& field : fields) {
      if (!contains(known_, field.text))
        fail(line_, field.column, "unknown column " + quoted(field.text), joined(known_));
      if (contains(table_.names, field.text)) fail(line_, field.column, "column " + quoted(field.text) + " twice");
      table_.names.emplace_back(field.text);
    }
    for (const std::string& name : required_) {
      if (!contains(table_.names, name)) fail(line_, 1, "column '" + name + "' is missing", joined(known_));
    }
    table_.columns.resize(table_.names.size());
  }

  void row(const std::vector<Field>& fields) {
    if (fields.size() != table_.names.size()) {
      fail(line_, fields.back().column,
           std::to_string(fields.size()) + " fields where the header names " + std::to_string(table_.names.size()));
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const auto value = parse_number(fields[i].text);
      if (!value || !std::isfinite(*value)) {
        fail(line_, fields[i].column, table_.names[i] + ": " + quoted(fields[i].text) + " is no finite number");
      }
      table_.columns[i].push_back(*value);
    }
    table_.lines.push_back(line_);
  }

  const std::vector<std::string>& required_;
  std::vector<std::string> known_;
  CsvTable table_;
  int line_ = 0;
};

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
    if (fields[i].find_first_of(",\"\r\n") == std::string::npos) {
      text_ += fields[i];
      continue;
    }
    text_ += '"';
    for (const char c : fields[i]) text_ += c == '"' ? std::string(2, c) : std::string(1, c);
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
  return Reader(file, required, optional).read(text);
}

std::string read_input_file(const std::string& file) {
  constexpr std::size_t limit = std::size_t{256} << 20;  // some millions of points
  return read_bytes(file, limit);
}

}  // namespace assay::drivers
