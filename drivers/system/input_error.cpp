// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/input_error.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <utility>

#include "drivers/system/input_file.hpp"
#include "drivers/text/unseen.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t longest_line = 4096;  // [bytes]

std::string line_of(const Location& where, const std::string& key, const std::string& what, const std::string& known) {
  std::string line = where.text();
  if (!line.empty() && !key.empty()) line += where.file == set_option ? " " : ": ";
  line += key;
  if (!line.empty()) line += ": ";
  line += what;
  const std::string note = unseen_note(with_unseen_written(key + " " + what));
  if (!note.empty()) line += "; " + note;
  if (!known.empty()) line += "; known: " + known;
  return with_unseen_written(cut(line, longest_line));
}

/// What other codes call by this name, in the words of a scene; empty where that is not known.
std::string name_elsewhere(const std::string& word) {
  static const std::pair<const char*, std::vector<std::string>> names[] = {
      {"density", {"rho", "rho0"}},
      {"parameters", {"properties"}},
      {"adapter", {"model", "name"}},
      {"spacing", {"h", "dx", "cell_size", "resolution"}},
      {"courant", {"cfl", "timestep_multiplier"}},
      {"step", {"dt"}},
      {"end", {"end_time", "t_end", "maxtime"}},
      {"basis", {"shape_function", "interpolator"}},
      {"per_cell", {"ppc", "particles_per_cell"}},
      {"type", {"kind"}},
      {"inner", {"ri"}},
      {"outer", {"ro"}},
      {"e", {"youngs_modulus"}},
      {"nu", {"poisson", "poissons_ratio"}}};
  const auto found = std::ranges::find_if(names, [&](const auto& each) { return is_one_of(word, each.second); });
  return found == std::end(names) ? std::string() : found->first;
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
  std::string text = file == standard_stream ? "standard input" : file;
  if (line > 0) text += ":" + std::to_string(line);
  if (line > 0 && column > 0) text += ":" + std::to_string(column);
  return text;
}

void throw_system_error(const char* call) { throw SystemError(std::string(call) + ": " + std::strerror(errno)); }

InputError::InputError(const std::string& what) : std::runtime_error(line_of({}, {}, what, {})) {}

InputError::InputError(const Location& where, const std::string& key, const std::string& what, const std::string& known)
    : std::runtime_error(line_of(where, key, what, known)), where_(where), key_(key) {}

std::string one_line(std::string_view text, std::size_t limit) { return printable(cut(text, limit)); }

std::string nearest(const std::string& mistyped, const std::vector<std::string>& known) {
  const std::string word = as_meant(without_unseen(mistyped));
  if (word.empty() || word.size() > 200) return {};
  const std::string small = small_letters(word);
  const auto same = [&](const std::string& name) {
    return [&](const std::string& candidate) { return candidate == word || small_letters(candidate) == name; };
  };
  for (const std::string& name : {small, name_elsewhere(small)}) {
    const auto found = std::find_if(known.begin(), known.end(), same(name));
    if (found != known.end()) return *found;
  }
  std::string best;
  const std::size_t most = word.size() == 1 ? 0 : word.size() < 4 ? 1 : std::max<std::size_t>(2, word.size() / 3);
  std::size_t least = most + 1;
  for (const std::string& candidate : known) {
    const std::size_t distance =
        std::min(edit_distance(word, candidate), edit_distance(small, small_letters(candidate)));
    if (distance < least) least = distance, best = candidate;
  }
  if (!best.empty()) return best;
  constexpr std::size_t stem = 4;  // of an abbreviation, "params"
  for (const std::string& beginning : {word, word.size() > stem ? word.substr(0, stem) : word}) {
    const auto begins = std::ranges::find_if(known, [&](const auto& k) { return k.starts_with(beginning); });
    if (begins != known.end()) return *begins;
  }
  return {};
}

std::string known_words(const std::string& word, const std::vector<std::string>& known, const std::string& source) {
  constexpr std::size_t most = 40, few = 6;
  if (known.size() <= most) return joined(known);
  std::vector<std::pair<std::size_t, std::string>> ranked;
  for (const std::string& each : known)
    ranked.emplace_back(word.size() > 200 ? 0 : each.starts_with(word) ? 0 : edit_distance(word, each), each);
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> nearest_ones;
  for (std::size_t i = 0; i < few; ++i) nearest_ones.push_back(ranked[i].second);
  return joined(nearest_ones) + " and " + std::to_string(known.size() - few) + " more, which " + source + " lists";
}

std::string nearest_words(const std::string& word, const std::vector<std::string>& known) {
  const std::string near = nearest(word, known);
  const std::string other = lookalike(word, near);
  return (near.empty() ? std::string() : " (nearest: " + near + ")") + (other.empty() ? "" : ", " + other);
}

std::string unknown(const std::string& kind, const std::string& word, const std::vector<std::string>& known) {
  return "unknown " + kind + nearest_words(word, known);
}

}  // namespace assay::drivers
