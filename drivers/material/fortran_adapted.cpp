// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/fortran_adapted.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "drivers/material/fortran_form.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t mark_column = 5;  ///< from 0: of a continuation in fixed form

/// The word behind '#', in small letters.
std::string directive_word(const std::string& line) {
  const std::size_t begin = std::min(line.find_first_not_of(" \t", line.find('#') + 1), line.size());
  const auto end = std::find_if_not(line.begin() + static_cast<std::ptrdiff_t>(begin), line.end(),
                                    [](unsigned char c) { return std::isalpha(c); });
  std::string word(line.begin() + static_cast<std::ptrdiff_t>(begin), end);
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
  return word;
}

std::string plain_directive(const std::string& line) {
  const std::string word = directive_word(line);
  const std::size_t behind = line.find_first_not_of(" \t", line.find('#') + 1) + word.size();
  std::string rest = line.substr(behind);
  if (word == "include") std::replace(rest.begin(), rest.end(), '\'', '"');
  return "#" + word + rest;
}

/// Without the ampersand at the end of its code; a comment behind it goes, too.
std::string without_ampersand(const std::string& line, FortranCode& reader) {
  std::string code = reader.of(line);
  if (reader.is_open() || !code.ends_with('&') || code.size() <= mark_column + 1) return line;
  code.pop_back();
  return code;
}

}  // namespace

std::vector<FortranForm> forms_of_lines(const std::vector<std::string>& lines, FortranForm by_name) {
  std::vector<FortranForm> forms;
  FortranForm form = by_name;
  for (const std::string& line : lines) {
    if (const auto said = form_by_directive(line)) form = *said;
    forms.push_back(form);
  }
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
      const bool blank = line.find_first_not_of(" \t") == line.npos;
      if (!blank && line[0] != ' ' && line[0] != '\t') all.back()[0] = '!';
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
  const std::string word = directive_word(line);
  constexpr const char* words[] = {"include", "define", "undef", "if", "ifdef", "ifndef", "else", "elif", "endif"};
  return std::any_of(std::begin(words), std::end(words), [&](const char* each) { return word == each; });
}

std::vector<std::string> adapted_lines(const std::vector<std::string>& lines, const std::vector<FortranForm>& forms) {
  std::vector<std::string> all;
  FortranCode reader(FortranForm::fixed);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (is_preprocessor_line(lines[k], forms[k])) {
      all.push_back(plain_directive(lines[k]));
    } else {
      all.push_back(forms[k] == FortranForm::fixed ? without_ampersand(lines[k], reader) : lines[k]);
    }
  }
  return all;
}

}  // namespace assay::drivers
