// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/fortran_messages.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

const std::vector<std::string> of_errors{": Error: ", ": Fatal Error: "}, of_warnings{": Warning: "};

/// Those of one of these kinds.
std::vector<CompilerMessage> messages_in(const std::string& said, const std::vector<std::string>& kinds) {
  std::vector<CompilerMessage> messages;
  for (const std::string& line : split(said, '\n')) {
    const auto kind = std::ranges::find_if(kinds, [&](const auto& k) { return line.find(k) != line.npos; });
    if (kind == kinds.end()) continue;
    const std::size_t at = line.find(*kind);
    Location where{line.substr(0, at)};
    std::string& file = where.file;
    for (int* number : {&where.column, &where.line}) {
      const std::size_t colon = file.rfind(':');
      const auto value = colon == file.npos ? std::nullopt : parse_integer(file.substr(colon + 1));
      if (!value) break;
      *number = static_cast<int>(*value);
      file.resize(colon);
    }
    messages.push_back({where, line.substr(at + kind->size())});
  }
  return messages;
}

/// As it is named from the folder of the source.
std::string plain_file(const std::string& file) { return file.substr(file.starts_with("./") ? 2 : 0); }

bool is_truncation(const std::string& text) {
  const std::size_t conversion = text.find("hange of value in conversion from ");
  return conversion != text.npos && text.find("REAL(", conversion) < text.find("INTEGER(", conversion);
}

/// What a statement gives a value to, behind "if(...)"; empty: it is no assignment.
std::string assigned_name(std::string text) {
  const auto behind_parentheses = [&text](std::size_t open) {
    int depth = 0;
    for (std::size_t k = open; k < text.size(); ++k) {
      depth += text[k] == '(' ? 1 : text[k] == ')' ? -1 : 0;
      if (depth == 0) return k + 1;
    }
    return text.size();
  };
  if (text.starts_with("if(")) text.erase(0, behind_parentheses(2));
  const auto of_name = [](char c) { return is_letter_or_digit(c) || c == '_'; };
  const auto end = static_cast<std::size_t>(std::ranges::find_if_not(text, of_name) - text.begin());
  const std::size_t at = end < text.size() && text[end] == '(' ? behind_parentheses(end) : end;
  const bool assigns = at < text.size() && text[at] == '=' && text.substr(at, 2) != "==";
  return assigns ? text.substr(0, end) : std::string();
}

/// Statements in which a name of that line may be declared: of its routine, or of the whole source where names of
/// another scope may be meant.
std::vector<FortranStatement> scope_of(const FortranSource& source, int line) {
  const auto looks_elsewhere = [](const FortranStatement& each) {
    return each.text == "contains" || each.text.starts_with("use");
  };
  if (std::ranges::any_of(source.statements, looks_elsewhere)) return source.statements;
  for (const FortranRoutine& routine : source.routines()) {
    if (line >= routine.line && line <= routine.last_line) return routine.statements;
  }
  return source.statements;
}

/// Of the source's own statements, those that stand in that line, whatever lines they go on in.
std::vector<std::string> statements_at(const std::vector<FortranStatement>& statements, int line) {
  int begin = 0;
  for (const FortranStatement& each : statements) begin = each.line <= line ? std::max(begin, each.line) : begin;
  std::vector<std::string> texts;
  for (const FortranStatement& each : statements) {
    if (each.line == begin) texts.push_back(each.text);
  }
  return texts;
}

/// Names that such a line gives a value to, and that nothing declares.
std::vector<std::string> undeclared_at(const FortranSource& source, int line) {
  const std::vector<FortranVariable> declared = variables_of(scope_of(source, line));
  std::vector<std::string> names;
  for (const std::string& text : statements_at(statements_of(source.lines, source.form.form), line)) {
    const std::string name = assigned_name(text);
    if (name.empty() || name[0] < 'i' || name[0] > 'n') continue;
    if (std::ranges::count(declared, name, &FortranVariable::name) == 0) names.push_back(name);
  }
  return names;
}

}  // namespace

std::vector<CompilerMessage> errors_in(const std::string& said) { return messages_in(said, of_errors); }

std::string plain_message(std::string text) {
  for (const std::string mark : {" at (1)", " at (2)", " (1)", "(1)"}) {
    if (text.ends_with(mark)) text.resize(text.size() - mark.size());
  }
  return text;
}

std::vector<std::string> warnings_in(const std::string& said) {
  // indices above a bound of 1 are an old way to declare arguments
  constexpr const char* seldom_meant[] = {"Missing actual argument", "Type mismatch ", "used uninitialized",
                                          "Integer division truncated", "out of bounds (0 < "};
  constexpr const char* own_variable = "'__";  // of the compiler's
  std::vector<std::string> warnings;
  for (const auto& [where, message] : messages_in(said, of_warnings)) {
    const auto is_in = [&text = message](const char* words) { return text.find(words) != std::string::npos; };
    if (std::none_of(std::begin(seldom_meant), std::end(seldom_meant), is_in)) continue;
    if (message.starts_with(own_variable)) continue;
    std::string text = message.substr(0, message.find(" [-W"));
    for (const std::string mark : {" at (1)", " at (2)"}) {
      if (const std::size_t at = text.find(mark); at != text.npos) text.erase(at, mark.size());
    }
    const std::string whole = place_text(plain_file(where.file), where.line) + text;
    if (!is_one_of(whole, warnings)) warnings.push_back(whole);
  }
  return warnings;
}

std::vector<std::string> truncations_in(const std::string& said, const FortranSource& source) {
  const std::string own = std::filesystem::path(source.file).filename().string();
  std::vector<std::string> names;
  int first = 0;
  for (const auto& [where, message] : messages_in(said, of_warnings)) {
    if (!is_truncation(message) || plain_file(where.file) != own) continue;
    for (const std::string& name : mapped(undeclared_at(source, where.line), capital_letters)) {
      if (is_one_of(name, names)) continue;
      if (names.empty()) first = where.line;
      names.push_back(name);
    }
  }
  if (names.empty()) return {};
  return {place_text(own, first) + few_names(names) +
          (names.size() > 1 ? " are integers by their first letter, and take real numbers"
                            : " is an integer by its first letter, and takes a real number") +
          ": digits after the decimal point are lost (if this is intended, write INT)"};
}

}  // namespace assay::drivers
