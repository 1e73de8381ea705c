// SPDX-License-Identifier: BSD-3-Clause
// Whether a Fortran source is in fixed or free form.
#include "drivers/material/fortran_text.hpp"

#include <filesystem>
#include <optional>

#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t mark_column = 5;  ///< from 0: of a continuation in fixed form

bool is_any_of(char c, std::string_view characters) { return characters.find(c) != characters.npos; }

/// A letter among the first five columns of what is no comment there, or a line that goes on by an ampersand alone.
bool is_free_only(const std::string& line, const std::string& fixed_code, const std::string& fixed_before) {
  if (fixed_before.ends_with('&') && !fixed_code.empty() && !continues_in_fixed_form(fixed_code)) return true;
  if (line.empty() || is_any_of(line[0], "cC*dD!#")) return false;
  const std::size_t first = line.find_first_not_of(" 0123456789");
  return first < mark_column && is_letter(line[first]);
}

/// A comment by its first column ("C words", "****", "C"), or a mark in the sixth that begins no statement of free
/// form.
bool is_fixed_only(const std::string& line, const std::string& code_before) {
  if (line.empty()) return false;
  const bool free_goes_on = code_before.ends_with('&'),
             is_indented_as_mark = line.find_first_not_of(' ') == mark_column;
  const bool open_end = !code_before.empty() && is_any_of(code_before.back(), ",(+-=");
  if (open_end && is_indented_as_mark) return true;  // it was not at its end, and did not say so
  if (line[0] == '*') return !free_goes_on;
  if (line[0] == 'C' || line[0] == 'c') {
    const std::size_t next = line.find_first_not_of(" \t", 1);
    return next == line.npos || (next > 1 && !is_any_of(line[next], "=(%"));
  }
  return !free_goes_on && line.size() > mark_column + 1 && is_indented_as_mark &&
         is_any_of(line[mark_column], "&+*$.#>@");
}

/// Where there are directives that say another form than the name.
std::optional<FoundForm> form_by_directives(const std::string& file, const std::vector<std::string>& lines) {
  const FortranForm by_name = form_by_name(file);
  FortranForm form = by_name;
  std::size_t first = 0;
  bool has_fixed = false, has_free = false;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const auto said = form_by_directive(lines[k]);
    if (said && *said != by_name && first == 0) first = k + 1;
    if (said) form = *said;
    if (said || stripped(lines[k]).empty() || stripped(lines[k]).starts_with('!')) continue;
    (form == FortranForm::free ? has_free : has_fixed) = true;
  }
  if (first == 0) return std::nullopt;
  if (has_fixed && has_free) {
    return FoundForm{FortranForm::free, true, "that changes by directives, as in line " + std::to_string(first)};
  }
  return FoundForm{form, false, "by its directive in line " + std::to_string(first)};
}

/// The word behind '#', in small letters, and what follows it.
struct PreprocessorLine {
  std::string word, rest;
  explicit PreprocessorLine(const std::string& line) {
    const std::size_t begin = std::min(line.find_first_not_of(" \t", line.find('#') + 1), line.size());
    std::size_t end = begin;
    while (end < line.size() && is_letter(line[end])) ++end;
    word = small_letters(line.substr(begin, end - begin));
    rest = line.substr(end);
  }
};

std::string plain_directive(const std::string& line) {
  PreprocessorLine directive(line);
  if (directive.word == "include") std::replace(directive.rest.begin(), directive.rest.end(), '\'', '"');
  return "#" + directive.word + directive.rest;
}

/// Without the ampersand at the end of its code; a comment behind it goes, too.
std::string without_ampersand(const std::string& line, FortranCode& reader) {
  std::string code = reader.of(line);
  if (reader.is_open() || !code.ends_with('&') || code.size() <= mark_column + 1) return line;
  code.pop_back();
  return code;
}

}  // namespace

std::optional<FortranForm> form_by_directive(const std::string& line) {
  if (line.empty() || !is_any_of(line[0], "cC!*")) return std::nullopt;
  std::string text = small_letters(line.substr(1));
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t'; });
  if (!text.starts_with("dir$") && !text.starts_with("dec$")) return std::nullopt;
  text.erase(0, 4);
  if (text.starts_with("freeform")) return FortranForm::free;
  if (text.starts_with("nofreeform") || text.starts_with("fixedform")) return FortranForm::fixed;
  return std::nullopt;
}

FortranForm form_by_name(const std::string& file) {
  const std::string ending = small_letters(std::filesystem::path(file).extension().string());
  return ending.size() == 4 && is_any_of(ending[2], "901") ? FortranForm::free : FortranForm::fixed;
}

FoundForm form_of_source(const std::string& file, const std::vector<std::string>& lines) {
  if (const auto directed = form_by_directives(file, lines)) return *directed;
  const FortranForm by_name = form_by_name(file);
  std::size_t first_fixed = 0, first_free = 0;  // lines from 1; 0: none
  FortranCode reader(FortranForm::free), fixed_reader(FortranForm::fixed);
  std::string before, fixed_before;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (first_fixed == 0 && is_fixed_only(lines[k], before)) first_fixed = k + 1;
    const std::string fixed_code = fixed_reader.of(lines[k]);
    if (first_free == 0 && is_free_only(lines[k], fixed_code, fixed_before)) first_free = k + 1;
    if (!fixed_code.empty()) fixed_before = fixed_code;
    if (std::string code = reader.of(lines[k]); !code.empty()) before = std::move(code);
  }
  const bool named_free = by_name == FortranForm::free;
  const std::size_t against = named_free ? first_fixed : first_free, in_favour = named_free ? first_free : first_fixed;
  if (against == 0 || in_favour > 0) return {by_name, false, ""};
  return {named_free ? FortranForm::fixed : FortranForm::free, false,
          "by its text, as in line " + std::to_string(against)};
}

std::vector<FortranForm> forms_of_lines(const std::vector<std::string>& lines, FortranForm by_name) {
  std::vector<FortranForm> forms;
  FortranForm form = by_name;
  for (const std::string& line : lines) forms.push_back(form = form_by_directive(line).value_or(form));
  return forms;
}

std::vector<std::string> in_free_form(const std::vector<std::string>& lines, const std::vector<FortranForm>& forms) {
  std::vector<std::string> all;
  std::size_t last = 0;  // line of code
  FortranCode reader(FortranForm::fixed);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::string& line = lines[k];
    all.push_back(line);
    if (form_by_directive(line)) all.back()[0] = '!';
    if (forms[k] == FortranForm::free || line.starts_with('#')) continue;
    const std::string code = reader.of(line);
    if (code.empty()) {  // a comment, or nothing
      if (!stripped(line).empty() && line[0] != ' ' && line[0] != '\t') all.back()[0] = '!';
      continue;
    }
    all.back() = code;
    if (continues_in_fixed_form(code)) {
      all[last] += '&';  // at once, and behind it at once: a word may go on
      all.back()[mark_column] = '&';
    }
    last = k;
  }
  return all;
}

bool is_preprocessor_line(const std::string& line, FortranForm form) {
  const std::size_t at = line.find_first_not_of(" \t");
  if (at == line.npos || line[at] != '#') return false;
  if (at == 0) return true;
  if (form == FortranForm::fixed && at == mark_column) return false;  // a continuation
  return is_one_of(PreprocessorLine(line).word,
                   {"include", "define", "undef", "if", "ifdef", "ifndef", "else", "elif", "endif"});
}

std::vector<std::string> adapted_lines(const std::vector<std::string>& lines, const std::vector<FortranForm>& forms) {
  std::vector<std::string> all;
  FortranCode reader(FortranForm::fixed);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    all.push_back(is_preprocessor_line(lines[k], forms[k]) ? plain_directive(lines[k])
                  : forms[k] == FortranForm::fixed         ? without_ampersand(lines[k], reader)
                                                           : lines[k]);
  }
  return all;
}

}  // namespace assay::drivers
