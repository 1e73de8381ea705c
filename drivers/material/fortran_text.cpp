// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/fortran_text.hpp"

#include <algorithm>

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

}  // namespace assay::drivers
