// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/fortran_text.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t statement_column = 6;  ///< from 0: behind label and continuation mark
constexpr const char* blanks = " \t";

/// `open`: the mark of a character constant that is open behind c; 0 for none.
void note_mark(char c, char& open) {
  const bool is_mark = c == '\'' || c == '"';
  if (open == 0 ? is_mark : c == open) open = open == 0 ? c : '\0';
}

void trim_end(std::string& text) { text.erase(text.find_last_not_of(blanks) + 1); }

/// A tab among the first six columns leads to the seventh, or to the sixth where a digit follows: a continuation.
std::string written_out(const std::string& line) {
  const std::size_t tab = line.find('\t');
  if (tab == line.npos || tab >= statement_column) return line;
  const char next = tab + 1 < line.size() ? line[tab + 1] : ' ';
  const std::size_t column = next >= '1' && next <= '9' ? statement_column - 1 : statement_column;
  return line.substr(0, tab) + std::string(column - tab, ' ') + line.substr(tab + 1);
}

bool is_comment_in_fixed_form(const std::string& line) {
  const std::size_t first = line.find_first_not_of(blanks);
  if (first == line.npos) return true;
  if (line[first] == '!' && first != statement_column - 1) return true;
  return std::string_view("cC*dD#").find(line[0]) != std::string_view::npos;
}

/// Where a comment begins, or the text's size; `open` is the mark of a character constant that is not closed.
std::size_t end_of_code(const std::string& text, std::size_t begin, char& open) {
  for (std::size_t k = begin; k < text.size(); ++k) {
    if (open == 0 && text[k] == '!') return k;
    note_mark(text[k], open);
  }
  return text.size();
}

/// Adds code to a statement: small letters, no blanks, no text of character constants.
void append_code(std::string& statement, std::string_view code, char& open) {
  for (const char c : code) {
    const char before = open;
    note_mark(c, open);
    if (open != before || (open == 0 && c != ' ' && c != '\t')) statement += small_letter(c);
  }
}

constexpr std::size_t card_end = 80;  ///< the last column of a punched card

std::optional<LongLine> beyond(const std::string& code, std::size_t column, int line) {
  const std::string tail(stripped(std::string_view(code).substr(std::min(column, code.size()))));
  return tail.empty() ? std::nullopt : std::optional(LongLine{line, tail, code.substr(0, column)});
}

struct CardNumber {
  std::string letters;
  std::int64_t number = 0;
};

/// Of a line whose code ends in column 80 at most: "00000010", "UMAT0010".
std::optional<CardNumber> card_number(const LongLine& line, std::size_t code_size) {
  const std::string& text = line.beyond;
  const auto digits = std::find_if(text.begin(), text.end(), is_digit);
  const bool letters_first = std::all_of(text.begin(), digits, is_letter);
  const bool digits_last = std::all_of(digits, text.end(), is_digit);
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
  constexpr std::size_t most = 6;
  if (lines.size() == 1) return "line " + std::to_string(lines.front().line);
  std::vector<std::string> numbers;
  for (std::size_t k = 0; k < std::min(most, lines.size()); ++k) numbers.push_back(std::to_string(lines[k].line));
  if (lines.size() > most) numbers.emplace_back("...");
  return std::to_string(lines.size()) + " lines: " + joined(numbers);
}

/// The last word of the code, with what Abaqus sees behind it: "1.d000000010".
std::string joined_word(const LongLine& card) {
  std::string code = card.before;
  std::erase_if(code, [](char c) { return c == ' ' || c == '\t'; });
  const auto of_word = [](char c) { return is_letter_or_digit(c) || c == '.' || c == '_'; };
  const auto begin = std::find_if_not(code.rbegin(), code.rend(), of_word).base();
  return std::string(begin, code.end()) + card.beyond;
}

}  // namespace

std::vector<std::string> lines_of_source(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  std::vector<std::string> lines = split(bytes, '\n');
  if (lines.back().empty()) lines.pop_back();
  for (std::string& line : lines) std::erase(line, '\r');
  return lines;
}

bool continues_in_fixed_form(const std::string& code) {
  if (code.size() < statement_column || code.find_first_not_of(' ') < statement_column - 1) return false;
  return code[statement_column - 1] != ' ' && code[statement_column - 1] != '0';
}

std::string FortranCode::of(const std::string& line) {
  if (form_ == FortranForm::free) {
    const bool directive = line.starts_with('#');
    std::string code = directive ? std::string() : line.substr(0, end_of_code(line, 0, open_));
    trim_end(code);
    if (!code.ends_with('&') && !code.empty()) open_ = 0;
    return code;
  }
  std::string code = written_out(line);
  if (is_comment_in_fixed_form(code)) return {};
  code.resize(std::min(code.size(), columns_));
  if (!continues_in_fixed_form(code)) open_ = 0;
  code.resize(end_of_code(code, std::min(code.size(), statement_column), open_));
  trim_end(code);
  return code;
}

std::string place_text(const std::string& file, int line) { return file + ":" + std::to_string(line) + ": "; }

std::string few_names(const std::vector<std::string>& names) {
  constexpr std::size_t shown = 4;
  const std::vector<std::string> first(names.begin(),
                                       names.begin() + static_cast<std::ptrdiff_t>(std::min(shown, names.size())));
  return joined(first) + (names.size() > shown ? " and " + std::to_string(names.size() - shown) + " others" : "");
}

std::vector<FortranStatement> statements_of(const std::vector<std::string>& lines, FortranForm form) {
  std::vector<FortranStatement> all;
  FortranCode reader(form);
  std::string text;
  int begin = 0, number = 0;
  char open = 0;
  bool goes_on = false;  // of free form: the last line of code ends with '&'
  const auto finish = [&] {
    for (std::string& part : split(text, ';')) {
      if (!part.empty()) all.push_back({begin, std::move(part)});
    }
    text.clear();
    open = 0;
  };
  for (const std::string& line : lines) {
    ++number;
    std::string code = reader.of(line);
    if (code.empty()) continue;
    std::size_t from = 0;
    bool continues = goes_on;
    if (form == FortranForm::fixed) {
      continues = continues_in_fixed_form(code);
      from = std::min(code.size(), statement_column);
    } else {
      goes_on = code.ends_with('&');
      if (goes_on) code.pop_back();
      from = std::min(code.find_first_not_of(blanks), code.size());
      if (continues && from < code.size() && code[from] == '&') ++from;
      if (!continues) from = std::min(code.find_first_not_of("0123456789 \t", from), code.size());
    }
    if (!continues) {
      finish();
      begin = number;
    }
    append_code(text, std::string_view(code).substr(from), open);
  }
  finish();
  return all;
}

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

std::vector<std::string> column_sentences(const ColumnReadings& readings, const std::string& file, bool by_abaqus) {
  struct Row {
    const std::vector<LongLine>& lines;
    const char *what, *code;  ///< before the first line's own word
    std::string more;         ///< behind it
  };
  const Row rows[] = {{readings.cards, "columns 73 to 80 hold the numbers of punched cards (",
                       by_abaqus ? "), and Abaqus reads them as code, since it takes 132 columns: this line ends in '"
                                 : "), and assay reads them as code, since it takes 132 columns: this line ends in '",
                       std::string(by_abaqus ? "', here too" : "'") + "; to remove them: " + card_remedy(file)},
                      {readings.tails, "code beyond column 72 (", "), here '",
                       std::string(by_abaqus ? "': Abaqus reads it, since it takes 132 columns, and so does assay"
                                             : "': assay reads it, since it takes 132 columns") +
                           "; a compiler at its usual 72 columns drops it silently"},
                      {readings.cut, "code beyond column 132 (", "), here '",
                       by_abaqus ? "': Abaqus reads 132 columns and cuts this off silently, and so does assay"
                                 : "': assay reads 132 columns and cuts this off"}};
  std::vector<std::string> all;
  for (const auto& [lines, what, code, more] : rows) {
    if (lines.empty()) continue;
    constexpr std::size_t longest = 60;
    const LongLine& first = lines.front();
    all.push_back(place_text(file, first.line) + what + which(lines) + code +
                  one_line(&lines == &readings.cards ? joined_word(first) : first.beyond, longest) + more);
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
    all.push_back(place_text(file, static_cast<int>(k) + 1) +
                  "the comment ends in a backslash, by which the preprocessor makes the next line a part of it: "
                  "leave the backslash out, or put a full stop behind it");
  }
  return all;
}

std::string card_remedy(const std::string& file) {
  const std::filesystem::path path = std::filesystem::path(file).filename();
  return "cut -c1-72 " + path.string() + " > " + path.stem().string() + "_72" + path.extension().string();
}

}  // namespace assay::drivers
