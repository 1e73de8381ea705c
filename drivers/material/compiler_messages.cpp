// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/compiler_messages.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <sstream>

#include "drivers/text/lookalikes.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

/// "./model.f:4:72: Error: Syntax error in argument list at (1)".
struct CompilerMessage {
  Location where;
  std::string text;
};

std::optional<CompilerMessage> message_of(const std::string& line, const std::vector<std::string>& kinds) {
  for (const std::string& word : kinds) {
    const std::size_t at = line.find(word);
    if (at == line.npos) continue;
    CompilerMessage message{{line.substr(0, at)}, line.substr(at + word.size())};
    std::string& file = message.where.file;
    for (int* number : {&message.where.column, &message.where.line}) {
      const std::size_t colon = file.rfind(':');
      const auto value = colon == file.npos ? std::nullopt : parse_integer(file.substr(colon + 1));
      if (!value) break;
      *number = static_cast<int>(*value);
      file.resize(colon);
    }
    return message;
  }
  return std::nullopt;
}

constexpr const char *error_mark = ": Error: ", *fatal_mark = ": Fatal Error: ";

/// Its own words without the marks of the compiler's drawing.
std::string plain_message(std::string text) {
  for (const std::string mark : {" at (1)", " at (2)", " (1)", "(1)"}) {
    if (text.ends_with(mark)) text.resize(text.size() - mark.size());
  }
  return text;
}

/// "foo" of the linker's "cannot find -lfoo: No such file or directory"; or empty.
std::string library_not_found(const std::string& said) {
  const std::string words = "cannot find -l";
  const std::size_t at = said.find(words);
  if (at == said.npos) return {};
  const std::size_t begin = at + words.size();
  return said.substr(begin, said.find_first_of(": \n", begin) - begin);
}

/// Where the source includes a file that this program provides, and that lies nowhere for a user to see.
std::optional<Location> place_of_own_include(const FortranSource& source, const std::string& file) {
  const std::string name = fs::path(file).filename().string();
  if (abaqus_include(name).empty() || fs::exists(fs::path(source.file).parent_path() / name)) return std::nullopt;
  const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
  const auto has_it = [&](const std::string& line) {
    return std::search(line.begin(), line.end(), name.begin(), name.end(), same) != line.end();
  };
  const auto line = std::find_if(source.lines.begin(), source.lines.end(), has_it);
  if (line == source.lines.end()) return std::nullopt;
  return Location{source.file, static_cast<int>(line - source.lines.begin()) + 1, 1};
}

/// Fortran has no characters beyond ASCII. For one of those, gfortran names its first byte alone: "Invalid character
/// 0xC2". The character is named too.
std::string with_character_named(const FortranSource& source, int line, const std::string& text) {
  if (!text.starts_with("Invalid character 0x") || line < 1 || static_cast<std::size_t>(line) > source.lines.size())
    return text;
  const std::string& code = source.lines[static_cast<std::size_t>(line) - 1];
  const std::string unseen = unseen_note(with_unseen_written(code)), other = lookalike(code);
  return text + (!unseen.empty() ? ": the line " + unseen : other.empty() ? "" : ": " + other);
}

}  // namespace

bool names_a_line(const std::string& said) {
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);) {
    const auto message = message_of(line, {error_mark, fatal_mark});
    if (message && message->where.line > 0) return true;
  }
  return false;
}

std::vector<std::string> warnings_in(const std::string& said) {
  // indices above a bound of 1 are an old way to declare arguments
  constexpr const char* seldom_meant[] = {"Missing actual argument", "Type mismatch ", "used uninitialized",
                                          "Integer division truncated", "out of bounds (0 < "};
  constexpr const char* own_variable = "'__";  // of the compiler's
  std::vector<std::string> warnings;
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);) {
    const auto message = message_of(line, {": Warning: "});
    const auto is_in = [&](const char* words) { return message->text.find(words) != std::string::npos; };
    if (!message || std::none_of(std::begin(seldom_meant), std::end(seldom_meant), is_in)) continue;
    if (message->text.starts_with(own_variable)) continue;
    std::string text = message->text.substr(0, message->text.find(" [-W"));
    for (const std::string mark : {" at (1)", " at (2)"}) {
      if (const std::size_t at = text.find(mark); at != text.npos) text.erase(at, mark.size());
    }
    const std::string& file = message->where.file;
    const std::string whole =
        file.substr(file.starts_with("./") ? 2 : 0) + ":" + std::to_string(message->where.line) + ": " + text;
    if (std::find(warnings.begin(), warnings.end(), whole) == warnings.end()) warnings.push_back(whole);
  }
  return warnings;
}

InputError refusal_of_compiler(const FortranSource& source, const std::string& version, const std::string& said) {
  std::istringstream lines(said);
  std::string line, text;
  std::optional<CompilerMessage> first;
  int errors = 0;
  while (std::getline(lines, line)) {
    const auto message = message_of(line, {error_mark, fatal_mark});
    if (!message) continue;
    if (!first) first = message;
    if (text.empty()) text = plain_message(message->text);
    if (!plain_message(message->text).empty()) ++errors;
  }
  if (const std::string absent = library_not_found(said); !absent.empty()) {
    return InputError({source.file}, "link",
                      "the linker finds no library '" + one_line(absent, 80) + "': its lib" + one_line(absent, 80) +
                          ".so or .a must be in a folder of the linker, or give the file");
  }
  if (!first) return InputError({source.file}, "", "does not compile: " + one_line(said, 300));
  if (first->where.line == 0) first->where.file = source.file;  // the compiler names itself
  if (first->where.file.starts_with("./") || first->where.file.find('/') == std::string::npos) {
    first->where.file = (fs::path(source.file).parent_path() / first->where.file).lexically_normal().string();
  }
  if (first->where.file == source.file) text = with_character_named(source, first->where.line, text);
  const bool fixed = source.form.form == FortranForm::fixed;
  if (const auto place = place_of_own_include(source, first->where.file)) {
    const std::string name = fs::path(first->where.file).filename().string();
    first->where = *place;
    text += "; " + name + " holds IMPLICIT REAL*8(A-H,O-Z), beside which there is no IMPLICIT NONE";
  }
  std::string more = errors > 1 ? "; " + std::to_string(errors - 1) + " more" : "";
  if (source.has_cards) {
    more +=
        "; columns 73 to 80 hold the numbers of punched cards, which Abaqus reads as code: " + card_remedy(source.file);
  } else if (source.cut_line > 0) {
    more += "; what stands beyond column 132, as in line " + std::to_string(source.cut_line) + ", is cut";
  } else if (!source.form.why.empty()) {
    more += std::string("; it was taken for ") + (fixed ? "fixed" : "free") + " form " + source.form.why;
  }
  return {first->where, "", "does not compile: " + text + more + " (" + version + ")"};
}

}  // namespace assay::drivers
