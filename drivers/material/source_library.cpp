// SPDX-License-Identifier: BSD-3-Clause
// From a source to a library: compiled once, kept by what it was made of.

#include <filesystem>
#include <fstream>

#include "adapters/elf_symbols.hpp"
#include "adapters/library.hpp"
#include "drivers/material/fortran_compiler.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/whole_file.hpp"
#include "drivers/text/sha256.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

constexpr const char* library_signature = "assay source 3\n";
constexpr std::size_t digits_of_hash = 20;

/// A folder for what is made on the way; gone with this object, and swept by others where this process is killed.
class MakingFolder {
 public:
  explicit MakingFolder(const fs::path& parent) : path_(parent / hidden_name()) {
    std::error_code code;
    fs::create_directories(parent, code);
    if (!code) sweep_dead(parent);
    if (!code) fs::create_directory(path_, code);
    if (code) fail(parent, "cannot keep the library of a source ($ASSAY_CACHE_HOME names another folder)", code);
  }
  ~MakingFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  MakingFolder(const MakingFolder&) = delete;
  MakingFolder& operator=(const MakingFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// What no file name should hold becomes '_'.
std::string plain_stem(std::string stem) {
  for (char& c : stem) {
    if (!is_letter_or_digit(c) && c != '-') c = '_';
  }
  constexpr std::size_t longest = 60;
  return stem.substr(0, longest);
}

std::string counted(const std::string& text) { return std::to_string(text.size()) + ":" + text; }

std::string key_of(const FortranSource& source, const FortranCompiler& compiler) {
  std::string key = library_signature + counted(compiler.version);
  for (const std::string& flag : flags_for(source, compiler)) key += counted(flag);
  for (const IncludedFile& include : source.includes) key += counted(include.name) + counted(include.bytes);
  for (const std::string& word : source.link) key += counted(link_content(word));
  return sha256_hex(key + source.bytes).substr(0, digits_of_hash);
}

bool is_whole_library(const fs::path& file) {
  std::error_code code;
  if (!fs::is_regular_file(file, code)) return false;
  try {
    return !adapters::exported_symbols(file.string()).empty();
  } catch (const adapters::LibraryError&) {
    return false;
  }
}

/// Beside the library, so that they are said again where nothing is compiled.
fs::path warnings_of(const fs::path& library) { return fs::path(library).replace_extension(".warnings"); }

std::vector<std::string> kept_warnings(const fs::path& library, const FortranSource& source) {
  constexpr std::size_t most = 5;
  std::vector<std::string> warnings;
  std::ifstream file(warnings_of(library));
  std::size_t more = 0;
  for (std::string line; std::getline(file, line);) {
    if (warnings.size() == most)
      ++more;
    else
      warnings.push_back((fs::path(source.file).parent_path() / line).string());
  }
  if (more > 0) warnings.push_back(source.file + ": " + std::to_string(more) + " more warnings of the compiler");
  return warnings;
}

}  // namespace

std::string source_folder() {
  const std::string home = cache_home();
  if (!home.empty()) return home + "/sources";
  throw SystemError(
      "the library of a source cannot be kept: none of ASSAY_CACHE_HOME, XDG_CACHE_HOME, HOME leads to a folder");
}

SourceLibrary library_of_source(const FortranSource& source) {
  const fs::path folder = source_folder();
  const FortranCompiler compiler = find_fortran_compiler(source.file);
  const std::string stem = plain_stem(fs::path(source.file).stem().string());
  const fs::path library = folder / (stem + "-" + key_of(source, compiler) + ".so");
  const auto found = [&] { return SourceLibrary{library.string(), compiler.version, kept_warnings(library, source)}; };
  if (is_whole_library(library)) return found();
  const MakingFolder making(folder);
  const fs::path made = making.path() / (stem + ".so");
  std::string warnings;
  for (const std::string& line : compile_library(source, compiler, making.path().string(), made.string()))
    warnings += line + "\n";
  if (!warnings.empty()) write_file(warnings_of(library), warnings);
  sync_path(made);  // before its name does
  std::error_code code;
  fs::rename(made, library, code);
  if (code) fail(library, "cannot be put in place", code);
  return found();
}

bool is_made_of_source(const std::string& library) {
  const fs::path path(library);
  const std::string stem = path.stem().string();
  if (path.extension() != ".so" || stem.size() <= digits_of_hash) return false;
  const std::string hash = stem.substr(stem.size() - digits_of_hash - 1);
  return hash[0] == '-' && hash.find_first_not_of("0123456789abcdef", 1) == hash.npos;
}

std::string kept_description(const std::string& stem, const std::string& text) {
  const fs::path folder = source_folder();
  const fs::path file = folder / (plain_stem(stem) + "-" + sha256_hex(text).substr(0, digits_of_hash) + ".yaml");
  std::error_code code;
  fs::create_directories(folder, code);
  if (code) fail(folder, "cannot be made", code);
  if (!fs::exists(file, code)) write_file(file, text);
  return file.string();
}

}  // namespace assay::drivers
