// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/yaml_lines.hpp"

#include <algorithm>

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

std::string_view stripped(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == text.npos ? std::string_view() : text.substr(first, last - first + 1);
}

std::size_t key_colon(std::string_view text, std::size_t from) {
  for (std::size_t at = text.find(':', from); at != text.npos; at = text.find(':', at + 1)) {
    if (at + 1 == text.size() || text[at + 1] == ' ' || text[at + 1] == '\t') return at;
  }
  return text.npos;
}

bool has_key(std::string_view line) { return key_colon(line) != line.npos; }

}  // namespace assay::drivers
