// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/fortran_compiler.hpp"

#include <fcntl.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <sstream>

#include "adapters/process/shortage.hpp"
#include "drivers/material/compiler_messages.hpp"
#include "drivers/material/linked.hpp"
#include "drivers/material/tool_process.hpp"
#include "drivers/system/whole_file.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

std::string first_line_of(const std::string& text) { return text.substr(0, text.find('\n')); }

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
  const std::string version = one_line(first_line_of(asked.said), 200);
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
  return !source.adapted.empty() || std::any_of(source.includes.begin(), source.includes.end(),
                                                [](const IncludedFile& each) { return !each.adapted.empty(); });
}

}  // namespace

FortranCompiler find_fortran_compiler(const std::string& file) {
  const char* named = std::getenv("FC");
  std::istringstream words(named ? named : "");
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
                                 "-fno-diagnostics-show-caret"};
  constexpr int first_strict_version = 10;  // which takes arguments that do not match for errors
  if (major_version(compiler) >= first_strict_version) {
    flags.insert(flags.end(), {"-fallow-argument-mismatch", "-fallow-invalid-boz"});
  }
  flags.emplace_back(fixed ? "-ffixed-form" : "-ffree-form");
  flags.push_back(fixed ? "-ffixed-line-length-" + std::to_string(abaqus_columns) : "-ffree-line-length-none");
  flags.insert(flags.end(), {"-x", source.preprocessed ? "f95-cpp-input" : "f95"});
  if (source.preprocessed) flags.insert(flags.end(), {"-DABQ_LNX86_64", "-DABQ_FORTRAN"});  // as Abaqus does on Linux
  flags.insert(flags.end(), compiler.options.begin(), compiler.options.end());
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
  for (const std::string& word :
       {"-I" + (place / "include").string(), "-I" + file.parent_path().string(), "-J" + folder,
        "./" + file.filename().string(), std::string("-x"), std::string("none"), std::string("-o"), library}) {
    call.arguments.push_back(word);
  }
  for (const std::string& word : source.link) {
    for (const std::string& argument : link_arguments(word)) call.arguments.push_back(argument);
  }
  call.arguments.emplace_back("-lm");
  const ToolEnd end = run_tool(call);
  if (end.stopped) {
    throw SystemError(source.file + ": its compilation takes longer than " + number_text(call.limit_s) + " s");
  }
  std::error_code code;
  if (end.status == 0 && fs::is_regular_file(library, code)) return warnings_in(end.said);
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
