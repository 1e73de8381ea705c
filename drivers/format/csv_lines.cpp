// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/csv_lines.hpp"

#include <algorithm>

#include "drivers/format/yaml_lines.hpp"
#include "drivers/system/input_error.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t longest_quote = std::size_t{1} << 20;  ///< text with line breaks between quotes [bytes]

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
  std::size_t plain = 0;
  while (plain < text.size() && text[plain] != '\n' && text[plain] != '\r') ++plain;
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == text.npos || text[first] == '#' || text.substr(0, plain).find('"') == text.npos) return plain;
  bool quoted = false;
  for (std::size_t at = 0; at < std::min(text.size(), longest_quote); ++at) {
    if (text[at] == '"') quoted = !quoted;
    if (!quoted && (text[at] == '\n' || text[at] == '\r')) return at;
  }
  return quoted ? plain : text.size();
}

/// What is written before a text that a spreadsheet would take for a formula is none of the text.
std::string unguarded(std::string text) {
  const bool guarded = text.size() > 1 && text[0] == '\'' && begins_like_formula(std::string_view(text).substr(1));
  return guarded ? text.substr(1) : text;
}

}  // namespace

CsvLines::CsvLines(std::string_view text, const std::string& file) : rest_(text), file_(file) {
  if (is_utf16(text)) throw InputError({file, 1, 1}, "", "UTF-16 text: save it as UTF-8");
  if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
}

CsvLines::CsvLines(const InputBytes& input) : input_(&input), file_(input.file()) {
  read_more();
  if (is_utf16(rest_)) throw InputError({file_, 1, 1}, "", "UTF-16 text: save it as UTF-8");
  if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
}

/// Another piece behind the rest. False: there is none.
bool CsvLines::read_more() {
  constexpr std::size_t piece = std::size_t{1} << 20;
  if (!input_ || read_ >= input_->size()) return false;
  held_.erase(held_.begin(), held_.end() - static_cast<std::ptrdiff_t>(rest_.size()));
  const std::size_t before = held_.size();
  held_.resize(before + piece);
  const std::size_t more = input_->read(read_, held_.data() + before, piece);
  held_.resize(before + more);
  read_ += more;
  rest_ = {held_.data(), held_.size()};
  return more > 0;
}

/// Where the line ends that begins the rest. Nothing behind it can say otherwise.
std::size_t CsvLines::whole_line() {
  for (;;) {
    const std::size_t end = end_of_line(rest_);
    // a break of two characters may be cut between them, and a quote that is open may close later
    const bool cut =
        end + 1 >= rest_.size() || (rest_.size() < longest_quote && rest_.substr(0, end).find('"') != rest_.npos);
    if (!cut || !read_more()) return end;
  }
}

std::optional<std::vector<CsvField>> CsvLines::next() {
  const auto line = next_line();
  if (!line) return std::nullopt;
  return fields(*line);
}

std::optional<std::string_view> CsvLines::next_line() {
  while (!rest_.empty() || read_more()) {
    line_ += 1 + broken_;
    const std::size_t end = whole_line();
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
    return line;
  }
  return std::nullopt;
}

std::vector<CsvField> CsvLines::fields(std::string_view line) const {
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
