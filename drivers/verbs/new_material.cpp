// SPDX-License-Identifier: BSD-3-Clause
// `assay new-material`: a small project of a material that builds, passes `check` and runs the vortex.
#include "drivers/verbs/verbs.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>

#include "adapters/builtin.hpp"
#include "drivers/command_line/project_templates.hpp"
#include "drivers/command_line/verb.hpp"
#include "drivers/material/tool_process.hpp"
#include "drivers/output/output_folder.hpp"
#include "drivers/result/result.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

struct Flavour {
  const char *language, *interface;
  const char* folder;  ///< of drivers/templates
  const char* source;
  const char* material;  ///< as the scene names it
  const char* run;       ///< the command that finds the library
  const char* what;
};

constexpr const char* run_native = "assay run vortex.yaml";

constexpr std::array<Flavour, 4> flavours{{
    {"c", "native", "c", "NAME.c", "./build/NAME.so", run_native, "neo-Hookean elasticity in C"},
    {"c++", "native", "c++", "NAME.cpp", "./build/NAME.so", run_native, "a Maxwell solid with its rate form in C++"},
    {"fortran", "native", "fortran", "NAME.f90", "./build/NAME.so", run_native, "neo-Hookean elasticity in Fortran"},
    {"fortran", "umat", "umat", "NAME.f90", "NAME.yaml", "ASSAY_MATERIAL_PATH=build assay run vortex.yaml",
     "linear elasticity as a UMAT, and its description"},
}};

void refuse_bad_name(const std::string& name) {
  constexpr std::size_t longest = 60;
  const auto letter = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto fits = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  const std::string quoted = "'" + one_line(name, 80) + "' ";
  if (name.empty() || name.size() > longest || !letter(name[0]) || !std::ranges::all_of(name, fits)) {
    throw InputError({}, "NAME",
                     quoted + "is no name for a material: small letters, digits and '_', a letter first, at most " +
                         std::to_string(longest));
  }
  if (adapters::builtin_table(name)) throw InputError({}, "NAME", quoted + "is the name of a built-in material");
  for (const char* taken : {"all", "clean", "depend", "edit_cache", "help", "install", "list_install_components",
                            "package", "package_source", "preinstall", "rebuild_cache", "test"}) {
    if (name == taken) throw InputError({}, "NAME", quoted + "is a target that CMake has already");
  }
  if (name == "vortex") throw InputError({}, "NAME", quoted + "is the name of the project's scene");
}

const Flavour& flavour_of(const NewMaterialOptions& options) {
  std::vector<std::string> languages;
  for (const Flavour& each : flavours) {
    if (each.language == options.language && each.interface == options.interface) return each;
    if (languages.empty() || languages.back() != each.language) languages.emplace_back(each.language);
  }
  if (options.language == "umat")
    throw InputError({}, "--language", "umat is an interface: --language fortran --interface umat", joined(languages));
  if (std::ranges::find(languages, options.language) == languages.end()) {
    throw InputError({}, "--language",
                     unknown("language '" + one_line(options.language, 60) + "'", options.language, languages),
                     joined(languages));
  }
  if (options.interface == "umat")
    throw InputError({}, "--interface", "umat goes with --language fortran, found " + options.language);
  throw InputError(
      {}, "--interface",
      unknown("interface '" + one_line(options.interface, 60) + "'", options.interface, {"native", "umat"}),
      "native, umat");
}

std::string replaced(std::string text, const std::string& word, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(word, at)) != text.npos; at += by.size()) text.replace(at, word.size(), by);
  return text;
}

/// The project's files by their names.
std::map<std::string, std::string> files_of(const Flavour& flavour, const std::string& name) {
  const auto named = [&](std::string_view text) { return replaced(std::string(text), "NAME", name); };
  const std::string version = build_information().version;
  std::map<std::string, std::string> files;
  for (const ProjectTemplate& each : project_templates()) {
    if (each.flavour != "common" && each.flavour != flavour.folder) continue;
    std::string text = replaced(std::string(each.text), "@NAME@", name);
    text = replaced(text, "@SOURCE@", named(flavour.source));
    text = replaced(text, "@MATERIAL@", named(flavour.material));
    text = replaced(text, "@WHAT@", flavour.what);
    text = replaced(text, "@RUN@", flavour.run);
    files[named(each.file)] = replaced(text, "@VERSION@", version.substr(0, version.rfind('.')));
  }
  return files;
}

void write_project(const fs::path& folder, const std::map<std::string, std::string>& files) {
  std::error_code code;
  if (fs::exists(fs::symlink_status(folder, code)))
    throw InputError({folder.string()}, "", "exists, and a project goes into a new folder; choose another with -o");
  watch_interrupts();
  OutputFolder out(folder, mapped(files, [](const auto& file) { return file.first; }));
  for (const auto& [name, text] : files) out.write(name, text);
  out.commit();
}

constexpr const char* program_name = "assay";

/// CMake's prefix of a folder with programs.
fs::path prefix_of(const fs::path& folder) { return folder.filename() == "bin" ? folder.parent_path() : folder; }

/// Whether CMake finds the package below that prefix.
bool holds_package(const fs::path& prefix) {
  std::error_code ignored;
  const auto is_there = [&](const fs::path& folder) { return fs::exists(folder / "assay-config.cmake", ignored); };
  if (is_there(prefix / "cmake")) return true;
  for (const char* folder : {"lib", "lib64", "share"}) {
    if (is_there(prefix / folder / "cmake" / program_name)) return true;
  }
  for (fs::directory_iterator at(prefix / "lib", ignored), end; !ignored && at != end; at.increment(ignored)) {
    if (is_there(at->path() / "cmake" / program_name)) return true;  // of an architecture
  }
  return false;
}

/// A path, as a word of the shell.
std::string path_word(const std::string& path) { return shell_word(path, "_./+"); }

/// The commands that build and run a new project, as they work from where their reader stands, a line each: into the
/// folder, configure, build, test, run. CMake finds this program's package by itself where the program is the one on
/// PATH and its package lies there; else the line says where it is. `run` is the last command, in which "assay" stands
/// for the program.
std::string next_steps(const std::string& folder, const std::string& run) {
  std::error_code error;
  const fs::path here = fs::read_symlink("/proc/self/exe", error), there = tool_in_path(program_name);
  const bool on_path = !there.empty() && fs::equivalent(there, here, error);
  std::string configure = "cmake -B build";
  if (!on_path || !holds_package(prefix_of(there.parent_path()))) {
    const fs::path prefix = prefix_of(here.parent_path());
    configure += holds_package(prefix) ? " -D CMAKE_PREFIX_PATH=" + path_word(prefix.string())
                                       : "   # with -D CMAKE_PREFIX_PATH=(where assay is installed)";
  }
  const std::string command = on_path ? run : replaced(run, "assay run", path_word(here.string()) + " run");
  // A name that begins with a hyphen would be an option.
  return "  cd " + one_line(path_word(folder.starts_with('-') ? "./" + folder : folder)) + "\n  " + configure +
         "\n  cmake --build build\n  ctest --test-dir build  # assay check\n  " + command + "\n";
}

Act add_new_material_arguments(VerbArguments& verb) {
  const auto given = std::make_shared<NewMaterialOptions>();
  add_value(verb, "NAME", given->name, "", "name of the material")->required();
  add_value(verb, "--language", given->language, "LANGUAGE", "c, c++ or fortran", "c c++ fortran")->required();
  add_value(verb, "--interface", given->interface, "INTERFACE", "native (default), or umat in Fortran", "native umat");
  add_out(verb, given->out, "DIR", "folder for the project, a new one (default: NAME)");
  return act_of(given, new_material);
}

}  // namespace

int new_material(const NewMaterialOptions& options) {
  const Flavour& flavour = flavour_of(options);
  refuse_bad_name(options.name);
  const fs::path folder = options.out.empty() ? options.name : options.out;
  const auto files = files_of(flavour, options.name);
  write_project(folder, files);
  if (options.verbosity == Verbosity::quiet) return 0;
  std::string names;
  for (const auto& [name, text] : files) names += name + " ";
  print(wrapped(options.name + ": " + flavour.what + ", to be made yours", "", "  ") + wrapped(names, "  ", "  ") +
        "next:\n" + next_steps(folder.string(), flavour.run));
  return 0;
}

Verb verb_new_material() {
  return {40, "write a project that builds a material model",
          "assay new-material clay --language c++\n"
          "  assay new-material clay --language fortran --interface umat",
          add_new_material_arguments};
}

}  // namespace assay::drivers
