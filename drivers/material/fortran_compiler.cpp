// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/fortran_compiler.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <sstream>

#include "adapters/process/shortage.hpp"
#include "drivers/material/fortran_messages.hpp"
#include "drivers/material/source_entry.hpp"
#include "drivers/material/tool_process.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/whole_file.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

bool is_short_of_file_size() {
  rlimit size = {};
  return ::getrlimit(RLIMIT_FSIZE, &size) == 0 && size.rlim_cur < 1 << 20;
}

/// Asked once by each process.
std::string version_of_compiler(const std::string& program) {
  static std::mutex guard;
  static std::map<std::string, std::string> known;
  const std::lock_guard lock(guard);
  if (const auto at = known.find(program); at != known.end()) return at->second;
  const ToolEnd asked = run_tool({.program = program, .arguments = {"--version"}, .limit_s = 20});
  const std::string version = one_line(split(asked.said, '\n').front(), 200);
  if (asked.status != 0 || version.find("Fortran") == std::string::npos) {
    throw SystemError("'" + program + "' is no gfortran that works: " +
                      (!version.empty() ? version
                       : is_short_of_file_size()
                           ? "it says nothing, and the size of files is limited to less than 1 MiB (ulimit -f)"
                           : "it says nothing and ends with status " + std::to_string(asked.status)));
  }
  return known[program] = version;
}

/// The word after the last blank of "GNU Fortran (Debian 12.2.0-14) 12.2.0".
int major_version(const FortranCompiler& compiler) {
  const std::string word = compiler.version.substr(compiler.version.rfind(' ') + 1);
  return static_cast<int>(parse_integer(word.substr(0, word.find('.'))).value_or(0));
}

/// The files that Abaqus has, and those of the source's folder under the names that the source has for them.
void provide_includes(const FortranSource& source, const fs::path& folder) {
  for (const IncludedFile& include : source.includes) {
    const fs::path name = fs::path(include.name).lexically_normal(), place = folder / name;
    std::error_code code;
    if (name.empty() || name.is_absolute() || *name.begin() == ".." || fs::exists(place, code)) continue;
    fs::create_directories(place.parent_path(), code);
    if (code) fail(place.parent_path(), "cannot be made", code);
    if (include.path.empty() || !include.adapted.empty()) {
      write_bytes(place, include.adapted.empty() ? include.bytes : include.adapted, O_CREAT | O_EXCL);
    } else if (fs::path(include.path).filename() != name.filename()) {
      fs::create_symlink(include.path, place, code);
    }
  }
}

/// Whether gfortran is given another text than that of the files.
bool is_adapted(const FortranSource& source) {
  const auto has_other_text = [](const IncludedFile& each) { return !each.adapted.empty(); };
  return !source.adapted.empty() || std::ranges::any_of(source.includes, has_other_text);
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
  if (include_of_host(name).empty() || fs::exists(fs::path(source.file).parent_path() / name)) return std::nullopt;
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

/// Whether the compiler has something to say of a line of the source; else it failed by itself.
bool names_a_line(const std::string& said) {
  const std::vector<CompilerMessage> all = errors_in(said);
  return std::any_of(all.begin(), all.end(), [](const CompilerMessage& each) { return each.where.line > 0; });
}

/// In the description that names it; else the source.
Location place_of_link(const FortranSource& source, const std::string& library) {
  const std::size_t at = index_of(library, source.link);
  return at < source.link_where.size() ? source.link_where[at] : Location{source.file};
}

/// The first error that it names, at its place in the source or in what that includes; version: the compiler's.
InputError refusal_of_compiler(const FortranSource& source, const std::string& version, const std::string& said) {
  const std::vector<CompilerMessage> all = errors_in(said);
  std::vector<std::string> texts = mapped(all, [](const CompilerMessage& each) { return plain_message(each.text); });
  std::erase(texts, "");
  if (const std::string absent = library_not_found(said); !absent.empty()) {
    return InputError(place_of_link(source, absent), "link",
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
    const bool is_implicit = include_of_host(name).find("implicit") != std::string::npos;
    text += "; " + name +
            (is_implicit ? " holds IMPLICIT REAL*8(A-H,O-Z), beside which there is no IMPLICIT NONE"
                         : " is assay's own, since there is none beside the source");
  }
  std::string more = texts.size() > 1 ? "; " + std::to_string(texts.size() - 1) + " more" : "";
  if (source.has_cards) {
    more += "; columns 73 to 80 hold the numbers of punched cards, which are read as code: " + card_remedy(source.file);
  } else if (source.cut_line > 0) {
    more += "; what stands beyond column 132, as in line " + std::to_string(source.cut_line) + ", is cut";
  } else if (!source.form.why.empty()) {
    more += std::string("; it was taken for ") + word_of(source.form.form) + " form " + source.form.why;
  }
  return {where, "", "does not compile: " + text + more + " (" + version + ")"};
}

}  // namespace

FortranCompiler find_fortran_compiler(const std::string& file) {
  std::istringstream words(environment_value("FC"));
  std::string choice;
  words >> choice;
  FortranCompiler compiler;
  if (fs::path(choice).filename().string().find("gfortran") != std::string::npos) {
    compiler.program = choice.find('/') != choice.npos ? fs::absolute(choice).string() : tool_in_path(choice);
    if (compiler.program.empty() || !fs::exists(compiler.program))
      throw SystemError(file + ": is Fortran source, and $FC names '" + one_line(choice, 200) +
                        "', which is not there");
    for (std::string option; words >> option;) compiler.options.push_back(option);
  }
  if (compiler.program.empty()) compiler.program = tool_in_path("gfortran");
  if (compiler.program.empty()) {
    throw SystemError(file + ": is Fortran source, and there is no gfortran in $PATH to compile it: install one " +
                      "(Debian: apt install gfortran), or give a library that is built elsewhere");
  }
  compiler.version = version_of_compiler(compiler.program);
  return compiler;
}

std::vector<std::string> flags_for(const FortranSource& source, const FortranCompiler& compiler) {
  const bool fixed = source.form.form == FortranForm::fixed;
  std::vector<std::string> flags{"-shared",
                                 "-fPIC",
                                 "-O2",
                                 "-ffp-contract=off",
                                 "-frecursive",  // local variables on the stack, as by Abaqus' -auto
                                 "-std=legacy",
                                 "-fdec",
                                 "-Wuninitialized",
                                 "-Winteger-division",
                                 "-Wdo-subscript",
                                 "-Wconversion",
                                 "-fno-diagnostics-show-caret"};
  constexpr int first_strict_version = 10;  // which takes arguments that do not match for errors
  if (major_version(compiler) >= first_strict_version) {
    append_all(flags, {"-fallow-argument-mismatch", "-fallow-invalid-boz"});
  }
  append_all(flags, {fixed ? "-ffixed-form" : "-ffree-form",
                     fixed ? "-ffixed-line-length-" + std::to_string(abaqus_columns) : "-ffree-line-length-none", "-x",
                     source.preprocessed ? "f95-cpp-input" : "f95"});
  if (source.preprocessed) append_all(flags, {"-DABQ_LNX86_64", "-DABQ_FORTRAN"});          // as Abaqus does on Linux
  if (is_of_lsdyna(source)) append_all(flags, {"-fdefault-real-8", "-fdefault-double-8"});  // its double precision
  append_all(flags, compiler.options);
  return flags;
}

std::vector<std::string> compile_library(const FortranSource& source, const FortranCompiler& compiler,
                                         const std::string& folder, const std::string& library) {
  const fs::path place(folder), file(source.file);
  provide_includes(source, place / "include");
  ToolCall call{.program = compiler.program, .arguments = flags_for(source, compiler)};
  call.folder = file.parent_path().string();  // where it is called by its name: no path of it gets into the library
  call.temporary = folder;
  if (is_adapted(source)) {
    call.folder = folder;
    write_bytes(place / file.filename(), source.adapted.empty() ? source.bytes : source.adapted, O_CREAT | O_EXCL);
  }
  append_all(call.arguments, {"-I" + (place / "include").string(), "-I" + file.parent_path().string(), "-J" + folder,
                              "./" + file.filename().string(), "-x", "none", "-o", library});
  for (const std::string& word : source.link) append_all(call.arguments, link_arguments(word));
  call.arguments.emplace_back("-lm");
  const ToolEnd end = run_tool(call);
  if (end.stopped) {
    throw SystemError(source.file + ": its compilation takes longer than " + number_text(call.limit_s) + " s");
  }
  std::error_code code;
  if (end.status == 0 && fs::is_regular_file(library, code)) {
    std::vector<std::string> warnings = truncations_in(end.said, source);
    append_all(warnings, warnings_in(end.said));
    return warnings;
  }
  const std::string tight = adapters::tight_limits();
  if (!tight.empty() && !names_a_line(end.said))
    throw SystemError(source.file + ": its compilation fails, and " + tight + ": that may be why");
  if (end.status > 2) {
    throw SystemError(source.file + ": '" + compiler.program + "' ended with status " + std::to_string(end.status) +
                      ": " + one_line(end.said, 300));
  }
  throw refusal_of_compiler(source, compiler.version, end.said);
}

}  // namespace assay::drivers
