// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/fortran_form.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>

namespace assay::drivers {

namespace {

std::string in_small_letters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// A letter among the first five columns of what is no comment there, or a line that goes on by an ampersand alone.
bool is_free_only(const std::string& line, const std::string& fixed_code, const std::string& fixed_before) {
  if (fixed_before.ends_with('&') && !fixed_code.empty() && !continues_in_fixed_form(fixed_code)) return true;
  if (line.empty() || std::string_view("cC*dD!#").find(line[0]) != std::string_view::npos) return false;
  const std::size_t first = line.find_first_not_of(" 0123456789");
  return first != line.npos && first < 5 && is_letter(line[first]);
}

/// A comment by its first column ("C words", "****", "C"), or a mark in the sixth that begins no statement of free
/// form.
bool is_fixed_only(const std::string& line, const std::string& code_before) {
  if (line.empty()) return false;
  const bool free_goes_on = code_before.ends_with('&');
  const bool open_end =
      !code_before.empty() && std::string_view(",(+-=").find(code_before.back()) != std::string_view::npos;
  if (open_end && line.find_first_not_of(' ') == 5) return true;  // it was not at its end, and did not say so
  if (line[0] == '*') return !free_goes_on;
  if (line[0] == 'C' || line[0] == 'c') {
    const std::size_t next = line.find_first_not_of(" \t", 1);
    if (next == line.npos) return true;
    return next > 1 && std::string_view("=(%").find(line[next]) == std::string_view::npos;
  }
  if (free_goes_on || line.size() < 7 || line.find_first_not_of(' ') != 5) return false;
  return std::string_view("&+*$.#>@").find(line[5]) != std::string_view::npos;
}

/// Where there are directives that say another form than the name.
std::optional<FoundForm> form_by_directives(const std::string& file, const std::vector<std::string>& lines) {
  const FortranForm by_name = form_by_name(file);
  FortranForm form = by_name;
  int number = 0, first = 0;
  bool has_fixed = false, has_free = false;
  for (const std::string& line : lines) {
    ++number;
    const auto said = form_by_directive(line);
    if (said && *said != by_name && first == 0) first = number;
    if (said) form = *said;
    if (said || line.find_first_not_of(" \t") == line.npos || line[line.find_first_not_of(" \t")] == '!') continue;
    (form == FortranForm::free ? has_free : has_fixed) = true;
  }
  if (first == 0) return std::nullopt;
  if (has_fixed && has_free) {
    return FoundForm{FortranForm::free, true, "that changes by directives, as in line " + std::to_string(first)};
  }
  return FoundForm{form, false, "by its directive in line " + std::to_string(first)};
}

}  // namespace

std::optional<FortranForm> form_by_directive(const std::string& line) {
  if (line.empty() || std::string_view("cC!*").find(line[0]) == std::string_view::npos) return std::nullopt;
  std::string text = in_small_letters(line.substr(1));
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t'; });
  if (!text.starts_with("dir$") && !text.starts_with("dec$")) return std::nullopt;
  text.erase(0, 4);
  if (text.starts_with("freeform")) return FortranForm::free;
  if (text.starts_with("nofreeform") || text.starts_with("fixedform")) return FortranForm::fixed;
  return std::nullopt;
}

FortranForm form_by_name(const std::string& file) {
  const std::string ending = in_small_letters(std::filesystem::path(file).extension().string());
  const bool named_free = ending.size() == 4 && (ending[2] == '9' || ending[2] == '0' || ending[2] == '1');
  return named_free ? FortranForm::free : FortranForm::fixed;
}

FoundForm form_of_source(const std::string& file, const std::vector<std::string>& lines) {
  if (const auto directed = form_by_directives(file, lines)) return *directed;
  const FortranForm by_name = form_by_name(file);
  int number = 0, fixed = 0, free = 0, first_fixed = 0, first_free = 0;
  FortranCode reader(FortranForm::free), fixed_reader(FortranForm::fixed);
  std::string before, fixed_before;
  for (const std::string& line : lines) {
    ++number;
    if (is_fixed_only(line, before) && ++fixed == 1) first_fixed = number;
    const std::string fixed_code = fixed_reader.of(line);
    if (is_free_only(line, fixed_code, fixed_before) && ++free == 1) first_free = number;
    if (!fixed_code.empty()) fixed_before = fixed_code;
    if (std::string code = reader.of(line); !code.empty()) before = std::move(code);
  }
  const bool named_free = by_name == FortranForm::free;
  const int against = named_free ? fixed : free, in_favour = named_free ? free : fixed;
  if (against == 0 || in_favour > 0) return {by_name, false, ""};
  return {named_free ? FortranForm::fixed : FortranForm::free, false,
          "by its text, as in line " + std::to_string(named_free ? first_fixed : first_free)};
}

}  // namespace assay::drivers
