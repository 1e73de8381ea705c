// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/input_error.hpp"

#include <algorithm>

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

}  // namespace

std::string Location::text() const {
  std::string text = file;
  if (line > 0) text += ":" + std::to_string(line);
  if (line > 0 && column > 0) text += ":" + std::to_string(column);
  return text;
}

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
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return line;
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
