// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/input_error.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>

namespace assay::drivers {

namespace {

std::string line_of(const Location& where, const std::string& key, const std::string& what, const std::string& known) {
  std::string line = where.text();
  if (!line.empty() && !key.empty()) line += where.file == set_option ? " " : ": ";
  line += key;
  if (!line.empty()) line += ": ";
  line += what;
  if (!known.empty()) line += "; known: " + known;
  return one_line(line);
}

/// Optimal string alignment: insertions, deletions, substitutions and swaps of neighbours cost one each.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last[b.size()];
}

/// Length of the UTF-8 character at `at` and its code point; 0 where there is none.
std::size_t decode(std::string_view text, std::size_t at, std::uint32_t& code) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : (first & 0xF0u) == 0xE0       ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  if (length == 0 || at + length > text.size()) return 0;
  code = length == 1 ? first : first & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xC0u) != 0x80u) return 0;
    code = code << 6 | (byte(at + i) & 0x3Fu);
  }
  return length;
}

/// Control characters, and those that turn the direction of writing or break lines.
bool hidden(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || (code >= 0x200E && code <= 0x200F) ||
         (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

/// Hidden characters become blanks, what is no UTF-8 becomes a question mark.
std::string printable(std::string_view text) {
  std::string line;
  for (std::size_t at = 0; at < text.size();) {
    std::uint32_t code = 0;
    const std::size_t length = decode(text, at, code);
    if (length == 0)
      line += '?';
    else if (hidden(code))
      line += ' ';
    else
      line += text.substr(at, length);
    at += std::max<std::size_t>(length, 1);
  }
  return line;
}

}  // namespace

std::string Location::text() const {
  std::string text = file;
  if (line > 0) text += ":" + std::to_string(line);
  if (line > 0 && column > 0) text += ":" + std::to_string(column);
  return text;
}

void throw_system_error(const char* call) { throw SystemError(std::string(call) + ": " + std::strerror(errno)); }

InputError::InputError(const std::string& what) : std::runtime_error(one_line(what)) {}

InputError::InputError(const Location& where, const std::string& key, const std::string& what, const std::string& known)
    : std::runtime_error(line_of(where, key, what, known)) {}

std::string one_line(std::string_view text, std::size_t limit) {
  std::string line(text.substr(0, limit));
  if (text.size() > limit) {
    while (!line.empty() && (static_cast<unsigned char>(line.back()) & 0xC0u) == 0x80u) line.pop_back();
    if (!line.empty() && (static_cast<unsigned char>(line.back()) & 0x80u) != 0) line.pop_back();  // no half character
    line += "...";
  }
  return printable(line);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string nearest(const std::string& word, const std::vector<std::string>& known) {
  if (word.empty() || word.size() > 200) return {};
  std::string best;
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < least) least = distance, best = candidate;
  }
  if (!best.empty()) return best;
  const auto begins = std::find_if(known.begin(), known.end(), [&](const auto& k) { return k.starts_with(word); });
  return begins == known.end() ? std::string() : *begins;
}

std::string unknown(const std::string& kind, const std::string& word, const std::vector<std::string>& known) {
  const std::string near = nearest(word, known);
  return "unknown " + kind + (near.empty() ? std::string() : " (nearest: " + near + ")");
}

}  // namespace assay::drivers
