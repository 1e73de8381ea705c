// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/fortran_columns.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t card_end = 80;  ///< the last column of a punched card

std::string without_blanks_around(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  return begin == text.npos ? "" : text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

std::optional<LongLine> beyond(const std::string& code, std::size_t column, int line) {
  if (code.size() <= column) return std::nullopt;
  std::string tail = without_blanks_around(code.substr(column));
  if (tail.empty()) return std::nullopt;
  return LongLine{line, std::move(tail), code.substr(0, column)};
}

struct CardNumber {
  std::string letters;
  std::int64_t number = 0;
};

/// Of a line whose code ends in column 80 at most: "00000010", "UMAT0010".
std::optional<CardNumber> card_number(const LongLine& line, std::size_t code_size) {
  const std::string& text = line.beyond;
  const auto digits = std::find_if(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c); });
  const bool letters_first = std::all_of(text.begin(), digits, [](unsigned char c) { return std::isalpha(c); });
  const bool digits_last = std::all_of(digits, text.end(), [](unsigned char c) { return std::isdigit(c); });
  if (code_size > card_end || !letters_first || !digits_last || digits == text.end()) return std::nullopt;
  return CardNumber{std::string(text.begin(), digits), parse_integer(std::string(digits, text.end())).value_or(0)};
}

/// Whether they rise; each routine may begin anew.
bool rise(const std::vector<std::optional<CardNumber>>& numbers) {
  constexpr int pairs_a_fall = 5;
  const CardNumber* last = nullptr;
  int pairs = 0, falls = 0;
  for (const auto& number : numbers) {
    if (!number) continue;
    if (last) ++pairs;
    if (last && last->letters == number->letters && last->number >= number->number) ++falls;
    last = &*number;
  }
  return pairs > 0 && falls * pairs_a_fall <= pairs;
}

/// Takes the numbers of cards out of `tails`.
std::vector<LongLine> taken_cards(std::vector<LongLine>& tails, const std::vector<std::optional<CardNumber>>& numbers) {
  std::vector<LongLine> cards, others;
  const bool rising = rise(numbers);
  const auto count = std::count_if(numbers.begin(), numbers.end(), [](const auto& each) { return each.has_value(); });
  for (std::size_t k = 0; k < tails.size(); ++k) {
    const LongLine& line = tails[k];
    const bool alone = count == 1 && numbers[k] && numbers[k]->letters.empty() && line.before.ends_with(' ') &&
                       line.beyond.size() == card_end - standard_columns;
    (numbers[k] && (rising || alone) ? cards : others).push_back(line);
  }
  tails = std::move(others);
  return cards;
}

/// "line 3", "5 lines: 3, 4, 7, ...".
std::string which(const std::vector<LongLine>& lines) {
  constexpr std::size_t shown = 6;
  if (lines.size() == 1) return "line " + std::to_string(lines.front().line);
  std::string text = std::to_string(lines.size()) + " lines: ";
  for (std::size_t k = 0; k < std::min(shown, lines.size()); ++k) {
    text += (k ? ", " : "") + std::to_string(lines[k].line);
  }
  return text + (lines.size() > shown ? ", ..." : "");
}

std::string begin_of(const std::vector<LongLine>& lines, const std::string& file) {
  return file + ":" + std::to_string(lines.front().line) + ": ";
}

/// The last word of the code, with what Abaqus sees behind it: "1.d000000010".
std::string joined_word(const LongLine& card) {
  std::string code = card.before;
  std::erase_if(code, [](char c) { return c == ' ' || c == '\t'; });
  std::size_t begin = code.size();
  const auto of_word = [](unsigned char c) { return std::isalnum(c) || c == '.' || c == '_'; };
  while (begin > 0 && of_word(static_cast<unsigned char>(code[begin - 1]))) --begin;
  return code.substr(begin) + card.beyond;
}

}  // namespace

ColumnReadings readings_of(const std::vector<std::string>& lines, FortranForm form) {
  ColumnReadings found;
  if (form == FortranForm::free) return found;
  std::vector<std::optional<CardNumber>> numbers;
  FortranCode abaqus(form, abaqus_columns), everything(form, all_columns);
  int number = 0;
  for (const std::string& line : lines) {
    ++number;
    const std::string code = abaqus.of(line), whole = everything.of(line);
    if (auto tail = beyond(whole, abaqus_columns, number)) found.cut.push_back(std::move(*tail));
    if (auto tail = beyond(code, standard_columns, number)) {
      numbers.push_back(card_number(*tail, whole.size()));
      found.tails.push_back(std::move(*tail));
    }
  }
  found.cards = taken_cards(found.tails, numbers);
  return found;
}

std::vector<std::string> column_sentences(const ColumnReadings& readings, const std::string& file) {
  constexpr std::size_t longest = 60;
  std::vector<std::string> all;
  if (!readings.cards.empty()) {
    const LongLine& first = readings.cards.front();
    all.push_back(begin_of(readings.cards, file) + "columns 73 to 80 hold the numbers of punched cards (" +
                  which(readings.cards) +
                  "), and Abaqus reads them as code, since it takes 132 columns: this line ends " + "in '" +
                  one_line(joined_word(first), longest) + "', here too; to remove them: " + card_remedy(file));
  }
  if (!readings.tails.empty()) {
    all.push_back(begin_of(readings.tails, file) + "code beyond column 72 (" + which(readings.tails) + "), here '" +
                  one_line(readings.tails.front().beyond, longest) +
                  "': Abaqus reads it, since it takes 132 columns, and so does assay; a compiler at its usual 72 " +
                  "columns drops it silently");
  }
  if (!readings.cut.empty()) {
    all.push_back(begin_of(readings.cut, file) + "code beyond column 132 (" + which(readings.cut) + "), here '" +
                  one_line(readings.cut.front().beyond, longest) +
                  "': Abaqus reads 132 columns and cuts this off silently, and so does assay");
  }
  return all;
}

std::vector<std::string> joined_line_sentences(const std::vector<std::string>& lines, FortranForm form,
                                               const std::string& file) {
  std::vector<std::string> all;
  FortranCode code(form, all_columns);
  for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
    const std::string& line = lines[k];
    const std::size_t last = line.find_last_not_of(" \t\r");
    const std::string of_line = code.of(line);
    if (last == std::string::npos || line[last] != '\\' || line.starts_with('#') ||
        of_line.find('\\') != std::string::npos)
      continue;
    all.push_back(file + ":" + std::to_string(k + 1) +
                  ": the comment ends in a backslash, by which the preprocessor makes the next line a part of it: "
                  "leave the backslash out, or put a full stop behind it");
  }
  return all;
}

std::string card_remedy(const std::string& file) {
  const std::filesystem::path path = std::filesystem::path(file).filename();
  return "cut -c1-72 " + path.string() + " > " + path.stem().string() + "_72" + path.extension().string();
}

}  // namespace assay::drivers
