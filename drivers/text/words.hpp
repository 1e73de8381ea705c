// SPDX-License-Identifier: BSD-3-Clause
// Letters, ends and parts of texts, and lists of words.
#pragma once

#include <algorithm>
#include <cctype>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace assay::drivers {

inline char small_letter(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

inline std::string small_letters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), small_letter);
  return text;
}

inline std::string capital_letters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

inline bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
inline bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
inline bool is_letter_or_digit(char c) { return is_letter(c) || is_digit(c); }

/// As the name of a model: small letters and digits, '_' for all else.
inline std::string as_name(std::string text) {
  for (char& c : text) c = is_letter_or_digit(c) ? small_letter(c) : '_';
  return text;
}

/// Without blanks at its ends.
inline std::string_view stripped(std::string_view text, std::string_view blanks = " \t") {
  const std::size_t first = text.find_first_not_of(blanks);
  return first == text.npos ? std::string_view() : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

/// What stands between separators: one part more than there are of them.
inline std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0, end = 0; end != text.npos; begin = end + 1) {
    end = text.find(separator, begin);
    parts.emplace_back(text.substr(begin, end - begin));
  }
  return parts;
}

inline bool is_one_of(std::string_view word, const std::vector<std::string>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The place of a word in a list, from 0; the size of the list where it is not there.
inline std::size_t index_of(std::string_view word, const std::vector<std::string>& words) {
  return static_cast<std::size_t>(std::find(words.begin(), words.end(), word) - words.begin());
}

/// The names of an enumeration, as names_of() beside it lists them.
template <class Enum>
std::vector<std::string> words_of() {
  const auto names = names_of(Enum{});
  return {names.begin(), names.end()};
}

/// The name of one of its values.
std::string word_of(auto value) { return names_of(value)[static_cast<std::size_t>(value)]; }

/// As a word of the shell, in quotes where it has more than letters, digits and what is `plain`.
inline std::string shell_word(const std::string& word, std::string_view plain = "_./=:,+-") {
  const auto is_plain = [&](char c) { return is_letter_or_digit(c) || plain.find(c) != plain.npos; };
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

/// "virtual_stress" as "virtual stress".
inline std::string in_plain_words(std::string text) {
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

/// What `of` makes of each, in their order: a function of one, or a member.
template <class Of>
auto mapped(const auto& list, const Of& of) {
  std::vector<std::decay_t<std::invoke_result_t<const Of&, decltype(*std::begin(list))>>> all;
  for (const auto& each : list) all.push_back(std::invoke(of, each));
  return all;
}

/// "a, b, c".
inline std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// The same of what `of` makes of each.
std::string joined(const auto& list, const auto& of) { return joined(mapped(list, of)); }

/// Behind what is there already.
template <class T>
void append_all(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace assay::drivers
