// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/csv.hpp"

#include <algorithm>

#include "drivers/format/text_check.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

bool blank(char c) { return c == ' ' || c == '\t'; }

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
  const auto is_blank = [&](std::size_t i) { return blank(line[i]) && line[i] != separator_; };
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
  switch (separator_) {
    case ',':
      return "a comma";
    case ';':
      return "a semicolon";
    case '\t':
      return "a tab";
    default:
      return "'" + std::string(1, separator_) + "'";
  }
}

std::optional<double> csv_value(const std::string& field, bool comma) {
  if (!comma || field.find(',') == field.npos) return parse_number(field);
  if (field.find('.') != field.npos) return std::nullopt;
  std::string with_point = field;
  with_point[field.find(',')] = '.';
  return parse_number(with_point);
}

}  // namespace assay::drivers
