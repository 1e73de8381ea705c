// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/yaml_lines.hpp"

#include <algorithm>

#include "drivers/format/yaml_reader.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

std::vector<std::string_view> yaml_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(line);
    begin = end + 1;
  }
  return lines;
}

std::size_t indent_of(std::string_view line) { return std::min(line.find_first_not_of(' '), line.size()); }

Bare bare(std::string_view line) {
  Bare out{std::string(line), std::string::npos};
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    const bool begins = i == 0 || std::string_view(" \t[{,").find(line[i - 1]) != std::string_view::npos;
    if (c == '#' && begins) {
      out.text.erase(i);
      return out;
    }
    if ((c != '"' && c != '\'') || !begins) continue;
    std::size_t end = i + 1;
    while (end < line.size() && line[end] != c) end += c == '"' && line[end] == '\\' ? 2 : 1;
    if (end >= line.size()) {
      out.open = i;
      return out;
    }
    for (std::size_t k = i + 1; k < end; ++k) out.text[k] = '_';
    i = end;
  }
  return out;
}

std::size_t key_colon(std::string_view text, std::size_t from) {
  for (std::size_t at = text.find(':', from); at != text.npos; at = text.find(':', at + 1)) {
    if (at + 1 == text.size() || text[at + 1] == ' ' || text[at + 1] == '\t') return at;
  }
  return text.npos;
}

bool has_key(std::string_view line) { return key_colon(line) != line.npos; }

bool is_utf16(std::string_view text) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return true;
  const auto is_zero = [&](std::size_t i) { return text[i] == '\0'; };
  return text.size() >= 4 && is_zero(0) == is_zero(2) && is_zero(1) == is_zero(3) && is_zero(0) != is_zero(1);
}

void check_text(std::string_view text, const std::string& name, std::size_t limit) {
  if (text.size() > limit) throw InputError({name, 0, 0}, "", "longer than " + std::to_string(limit) + " bytes");
  const bool in_file = name != set_option;
  Location where{name, in_file ? 1 : 0, in_file ? 1 : 0};
  if (text.starts_with("\x7f"
                       "ELF"))
    throw InputError(where, "",
                     "this is a library, not a text: a scene names it by material.adapter, and `assay check` takes it");
  if (is_utf16(text)) throw InputError(where, "", "UTF-16 text: save it as UTF-8");
  bool indenting = true;
  for (std::size_t i = 0; i < text.size();) {
    std::uint32_t code = 0;
    const std::size_t size = character_size(text.substr(i), code);
    const auto byte = static_cast<unsigned char>(text[i]);
    if (size == 0) throw InputError(where, "", "not UTF-8 text");
    if ((byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r') || byte == 0x7f) {
      throw InputError(where, "", "a control character, " + shown(text.substr(i, 1), 1) + "; not a text file?");
    }
    if (indenting && byte == '\t') {
      const std::size_t word = text.find_first_not_of(" \t\r", i);
      if (word != text.npos && text[word] != '\n' && text[word] != '#') {
        throw InputError(where, "", "a tab in the indentation; YAML needs spaces");
      }
    }
    if (byte != ' ' && byte != '\t') indenting = false;
    if (in_file) ++where.column;
    if (byte == '\n') {
      indenting = true;
      if (in_file) ++where.line, where.column = 1;
    }
    i += size;
  }
}

namespace {

/// Where the quote stands: behind the scalar's anchor, if it has one; npos for none.
std::size_t quote_at(std::string_view text, std::size_t at) {
  while (at < text.size() && (text[at] == '&' || text[at] == '!')) {
    at = std::min(text.find_first_of(" \t\r\n", at), text.size());
    at = std::min(text.find_first_not_of(" \t\r\n", at), text.size());
  }
  return at < text.size() && (text[at] == '"' || text[at] == '\'') ? at : text.npos;
}

/// Where it is closed; npos: nowhere.
std::size_t quote_end(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  for (std::size_t i = begin + 1; i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (text[i] == quote) {
      if (quote == '"' || i + 1 >= text.size() || text[i + 1] != quote) return i;
      ++i;
    }
  }
  return text.npos;
}

/// The column of the key or of the dash that a quote in a line belongs to: more lines of its text are indented deeper.
std::size_t column_of_owner(const std::vector<std::string_view>& lines, std::size_t line, std::size_t quote) {
  std::size_t first = indent_of(lines[line]), dash = std::string::npos;
  while (lines[line].substr(first).starts_with("- ")) {
    dash = first;
    first = std::min(lines[line].find_first_not_of(' ', first + 1), lines[line].size());
  }
  if (first != quote) return first;
  if (dash != std::string::npos) return dash;
  while (line-- > 0) {
    const std::string above = bare(lines[line]).text;
    if (stripped(above).empty()) continue;
    return stripped(above).ends_with(':') ? std::min(indent_of(above), first) : first;
  }
  return first;
}

}  // namespace

std::optional<YamlSlip> quote_slip(std::string_view text, std::size_t byte) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  const std::size_t begin = quote_at(text, byte);
  if (begin == text.npos) return std::nullopt;
  const std::size_t end = quote_end(text, begin);
  if (text.substr(begin, end - begin).find('\n') == text.npos && end != text.npos) return std::nullopt;
  const auto lines = yaml_lines(text.substr(0, end));
  const std::string_view before = text.substr(0, begin);
  const auto at = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  const std::size_t column = begin - (before.rfind('\n') + 1);
  YamlSlip slip{static_cast<int>(at) + 1, static_cast<int>(column) + 1, "a quote that is not closed"};
  if (end == text.npos) return slip;
  const std::size_t owner = column_of_owner(lines, at, column);
  for (std::size_t i = at + 1; i < lines.size(); ++i) {
    if (indent_of(lines[i]) > owner || !(has_key(lines[i]) || stripped(lines[i]).starts_with("- "))) continue;
    slip.what += " in its line: line " + std::to_string(i + 1) +
                 " would be part of the text; lines of a text are indented deeper than its key";
    return slip;
  }
  return std::nullopt;
}

}  // namespace assay::drivers
