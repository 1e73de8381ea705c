// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/compiler_messages.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "drivers/text/lookalikes.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

/// "./model.f:4:72: Error: Syntax error in argument list at (1)".
struct CompilerMessage {
  Location where;
  std::string text;
};

const std::vector<std::string> of_errors{": Error: ", ": Fatal Error: "}, of_warnings{": Warning: "};

/// Those of one of these kinds.
std::vector<CompilerMessage> messages_in(const std::string& said, const std::vector<std::string>& kinds) {
  std::vector<CompilerMessage> messages;
  for (const std::string& line : split(said, '\n')) {
    const auto kind =
        std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return line.find(k) != line.npos; });
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
  const auto line = std::find_if(source.lines.begin(), source.lines.end(), [&](const std::string& each) {
    return small_letters(each).find(small_letters(name)) != each.npos;
  });
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
  const std::vector<CompilerMessage> all = messages_in(said, of_errors);
  return std::any_of(all.begin(), all.end(), [](const CompilerMessage& each) { return each.where.line > 0; });
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
    const std::string whole = place_text(where.file.substr(where.file.starts_with("./") ? 2 : 0), where.line) + text;
    if (!is_one_of(whole, warnings)) warnings.push_back(whole);
  }
  return warnings;
}

InputError refusal_of_compiler(const FortranSource& source, const std::string& version, const std::string& said) {
  const std::vector<CompilerMessage> all = messages_in(said, of_errors);
  std::vector<std::string> texts;
  for (const CompilerMessage& each : all) texts.push_back(plain_message(each.text));
  std::erase(texts, "");
  if (const std::string absent = library_not_found(said); !absent.empty()) {
    return InputError({source.file}, "link",
                      "the linker finds no library '" + one_line(absent, 80) + "': its lib" + one_line(absent, 80) +
                          ".so or .a must be in a folder of the linker, or give the file");
  }
  if (all.empty()) return InputError({source.file}, "", "does not compile: " + one_line(said, 300));
  Location where = all.front().where;
  std::string text = texts.empty() ? "" : texts.front();
  if (where.line == 0) where.file = source.file;  // the compiler names itself
  if (where.file.starts_with("./") || where.file.find('/') == std::string::npos) {
    where.file = (fs::path(source.file).parent_path() / where.file).lexically_normal().string();
  }
  if (where.file == source.file) text = with_character_named(source, where.line, text);
  if (const auto place = place_of_own_include(source, where.file)) {
    const std::string name = fs::path(where.file).filename().string();
    where = *place;
    text += "; " + name + " holds IMPLICIT REAL*8(A-H,O-Z), beside which there is no IMPLICIT NONE";
  }
  std::string more = texts.size() > 1 ? "; " + std::to_string(texts.size() - 1) + " more" : "";
  if (source.has_cards) {
    more +=
        "; columns 73 to 80 hold the numbers of punched cards, which Abaqus reads as code: " + card_remedy(source.file);
  } else if (source.cut_line > 0) {
    more += "; what stands beyond column 132, as in line " + std::to_string(source.cut_line) + ", is cut";
  } else if (!source.form.why.empty()) {
    more += std::string("; it was taken for ") + word_of(source.form.form) + " form " + source.form.why;
  }
  return {where, "", "does not compile: " + text + more + " (" + version + ")"};
}

}  // namespace assay::drivers
