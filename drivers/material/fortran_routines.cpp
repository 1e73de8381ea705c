// SPDX-License-Identifier: BSD-3-Clause
// The routines in a Fortran source, their arguments and declarations.
#include "drivers/material/fortran_text.hpp"

#include <algorithm>
#include <iterator>

#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

bool of_name(char c) { return is_letter_or_digit(c) || c == '_' || c == '%'; }

bool is_name(const std::string& text) { return !text.empty() && std::all_of(text.begin(), text.end(), of_name); }

/// Where `word` stands outside of parentheses that open at `from` or behind it; npos: nowhere.
std::size_t find_outside(const std::string& text, std::string_view word, std::size_t from = 0) {
  int depth = 0;
  for (std::size_t k = from; k < text.size(); ++k) {
    depth += text[k] == '(' ? 1 : text[k] == ')' ? -1 : 0;
    if (depth == 0 && text.compare(k, word.size(), word) == 0) return k;
  }
  return std::string::npos;
}

/// Where the parenthesis that opens at `open` is closed; npos: nowhere.
std::size_t closing(const std::string& text, std::size_t open) { return find_outside(text, ")", open); }

/// The parts between commas that stand in no parentheses.
std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0, end = 0; !text.empty() && end != text.npos; begin = end + 1) {
    end = find_outside(text, ",", begin);
    parts.push_back(text.substr(begin, end - begin));
  }
  return parts;
}

/// "subroutineumat(a,b)", behind recursive, pure and the like.
bool begins_subroutine(std::string text, FortranRoutine& routine) {
  constexpr std::string_view prefixes[] = {"recursive", "pure", "impure", "elemental", "module"};
  const auto prefix = [&] {
    return std::ranges::find_if(prefixes, [&](std::string_view each) { return text.starts_with(each); });
  };
  for (auto found = prefix(); found != std::end(prefixes); found = prefix()) text.erase(0, found->size());
  constexpr std::string_view word = "subroutine";
  if (!text.starts_with(word)) return false;
  const std::size_t open = std::min(text.find('('), text.size());
  routine.name = text.substr(word.size(), open - word.size());
  if (!is_name(routine.name)) return false;
  const std::size_t close = open < text.size() ? closing(text, open) : open;
  if (close == std::string::npos) return false;
  if (close > open) routine.arguments = parts_of(text.substr(open + 1, close - open - 1));
  return true;
}

bool ends_routine(const std::string& text) {
  return text == "end" || text == "contains" || text.starts_with("endsubroutine") || text.starts_with("endfunction");
}

/// The type with which a statement begins; empty: none.
std::string type_of(const std::string& text) {
  for (const char* type : {"integer", "real", "doubleprecision", "character", "logical", "complex"}) {
    if (text.starts_with(type)) return type;
  }
  return {};
}

/// "*8", "(8)", "(kind=8)" behind a type: its bytes, 0 where they are no number; `at` goes behind it.
int bytes_behind(const std::string& text, const std::string& type, std::size_t& at) {
  std::string kind;
  if (at < text.size() && text[at] == '*') {
    const std::size_t end = std::min(text.find_first_not_of("0123456789", at + 1), text.size());
    kind = text.substr(at + 1, end - at - 1);
    at = end;
  } else if (at < text.size() && text[at] == '(' && closing(text, at) != std::string::npos) {
    const std::size_t end = closing(text, at);
    kind = text.substr(at + 1, end - at - 1);
    if (kind.starts_with("kind=")) kind.erase(0, 5);
    at = end + 1;
  } else {
    return type == "doubleprecision" ? 8 : 4;
  }
  return static_cast<int>(parse_integer(kind).value_or(0));
}

/// The index of one use: a number, "1:6", or what is none; 0 for the latter.
int constant_index(const std::string& inside) {
  const std::vector<std::string> indices = parts_of(inside);
  if (indices.empty()) return 0;
  const std::string& last = indices.back();
  const std::size_t colon = last.find(':');
  const auto begin = parse_integer(last.substr(0, colon));
  const auto end = colon == last.npos ? begin : parse_integer(last.substr(colon + 1));
  constexpr std::int64_t most = 1000000;
  return begin && end && *end > 0 && *end <= most ? static_cast<int>(*end) : 0;
}

void note_use(const std::string& text, std::size_t at, std::size_t end, ArrayUse& use) {
  use.used = true;
  const std::size_t close = end < text.size() && text[end] == '(' ? closing(text, end) : std::string::npos;
  if (close == std::string::npos) {
    use.whole = false;
    return;
  }
  const std::string inside = text.substr(end + 1, close - end - 1);
  const int index = constant_index(inside);
  use.largest = std::max(use.largest, index);
  const char before = at > 0 ? text[at - 1] : ' ', after = close + 1 < text.size() ? text[close + 1] : ' ';
  const bool argument = (before == '(' || before == ',') && (after == ')' || after == ',');
  const bool call = text.starts_with("call") || text.find(")call") != text.npos;
  if (index == 0 || (call && argument && inside.find(':') == inside.npos)) use.whole = false;  // more may be behind it
}

/// Calls `found(text, begin, end)` for every place of a name in statements that are executed.
void for_each_use(std::span<const FortranStatement> statements, const std::string& name, const auto& found) {
  for (const auto& [line, text] : statements) {
    FortranRoutine head;
    if (declares(text) || begins_subroutine(text, head)) continue;
    for (std::size_t at = 0; (at = text.find(name, at)) != text.npos; at += name.size()) {
      const std::size_t end = at + name.size();
      if ((at == 0 || !of_name(text[at - 1])) && (end == text.size() || !of_name(text[end]))) found(text, at, end);
    }
  }
}

}  // namespace

bool declares(const std::string& text) {
  for (const char* word : {"implicit", "dimension", "common", "parameter(", "save", "external", "intrinsic", "data",
                           "include", "intent(", "pointer", "allocatable", "use", "import"}) {
    if (text.starts_with(word) && find_outside(text, "=") == text.npos) return true;
  }
  return find_outside(text, "::") != text.npos || (!type_of(text).empty() && find_outside(text, "=") == text.npos);
}

std::vector<FortranRoutine> subroutines_of(const std::vector<FortranStatement>& statements) {
  std::vector<FortranRoutine> all;
  bool inside = false;
  for (const FortranStatement& statement : statements) {
    FortranRoutine routine;
    if (begins_subroutine(statement.text, routine)) {
      routine.line = routine.last_line = statement.line;
      all.push_back(std::move(routine));
      inside = true;
    } else if (inside) {
      all.back().last_line = statement.line;
      inside = !ends_routine(statement.text);
      if (inside) all.back().statements.push_back(statement);
    }
  }
  return all;
}

std::vector<FortranVariable> variables_of(std::span<const FortranStatement> statements) {
  std::vector<FortranVariable> all;
  for (const FortranStatement& statement : statements) {
    const std::string& text = statement.text;
    const std::string type = type_of(text);
    if (type.empty() || !declares(text)) continue;
    std::size_t at = type.size();
    const int bytes = bytes_behind(text, type, at);
    const std::size_t colons = find_outside(text, "::");
    for (const std::string& part : parts_of(text.substr(colons == text.npos ? at : colons + 2))) {
      const std::string name = part.substr(0, part.find_first_of("(*="));
      if (is_name(name)) all.push_back({type, bytes, name, statement.line});
    }
  }
  return all;
}

bool uses(std::span<const FortranStatement> statements, const std::string& variable) {
  bool found = false;
  for_each_use(statements, variable, [&](const std::string&, std::size_t, std::size_t) { found = true; });
  return found;
}

ArrayUse use_of(std::span<const FortranStatement> statements, const std::string& array) {
  ArrayUse use;
  for_each_use(statements, array,
               [&](const std::string& text, std::size_t at, std::size_t end) { note_use(text, at, end, use); });
  return use;
}

std::vector<FortranInclude> includes_of(const std::vector<std::string>& lines, FortranForm form) {
  std::vector<FortranInclude> all;
  FortranCode reader(form);
  int number = 0;
  for (const std::string& line : lines) {
    ++number;
    std::string code = reader.of(line);
    if (line.starts_with('#')) code = line;
    const std::size_t first = code.find_first_not_of(" \t#");
    if (first == code.npos) continue;
    const std::string word = small_letters(code.substr(first, std::string_view("include").size()));
    const std::size_t open = word == "include" ? code.find_first_of("'\"<", first + word.size()) : code.npos;
    if (open == code.npos || code.find_first_not_of(" \t", first + word.size()) != open) continue;
    const std::size_t close = code.find(code[open] == '<' ? '>' : code[open], open + 1);
    if (close != code.npos) all.push_back({code.substr(open + 1, close - open - 1), number});
  }
  return all;
}

}  // namespace assay::drivers
