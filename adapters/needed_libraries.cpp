// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/needed_libraries.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>

#include "adapters/elf_symbols.hpp"
#include "adapters/library.hpp"

namespace assay::adapters {

namespace {

namespace fs = std::filesystem;
using Folders = std::vector<std::string>;

/// The folders of "A:B", $ORIGIN for that of the library; an empty one is where the process stands.
Folders folders_in(const std::string& list, const std::string& origin) {
  Folders folders;
  std::istringstream parts(list);
  for (std::string part; std::getline(parts, part, ':');) {
    for (const std::string_view word : {"$ORIGIN", "${ORIGIN}"}) {
      if (const auto at = part.find(word); at != part.npos) part.replace(at, word.size(), origin);
    }
    folders.push_back(part.empty() ? "." : part);
  }
  return folders;
}

bool is_of_system(const std::string& path) {
  for (const char* folder : {"/lib/", "/lib64/", "/usr/lib/", "/usr/lib64/"}) {
    if (path.starts_with(folder)) return true;
  }
  return false;
}

/// Those of the loader's own list.
Folders configured_folders() {
  std::error_code code;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator("/etc/ld.so.conf.d", code)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  files.emplace_back("/etc/ld.so.conf");
  Folders folders;
  for (const fs::path& each : files) {
    std::ifstream file(each);
    for (std::string line; std::getline(file, line);) {
      if (line.starts_with("/")) folders.push_back(line);
    }
  }
  return folders;
}

/// Empty: none of the folders has it.
std::string file_in(const Folders& folders, const std::string& name) {
  std::error_code code;
  for (const std::string& folder : folders) {
    const fs::path file = fs::absolute(fs::path(folder) / name).lexically_normal();
    if (fs::is_regular_file(file, code)) return file.string();
  }
  return {};
}

/// A file that is no library needs none: the loader complains.
ElfNeeds needs_of(const std::string& library) {
  try {
    return elf_needs(library);
  } catch (const LibraryError&) {
    return {};
  }
}

class Search {
 public:
  /// `rpath`: of the libraries that ask for this one.
  void visit(const std::string& library, Folders rpath) {
    if (std::find(found.begin(), found.end(), library) != found.end()) return;
    found.push_back(library);
    const ElfNeeds needs = needs_of(library);
    const std::string origin = fs::path(library).parent_path().string();
    const char* given = std::getenv("LD_LIBRARY_PATH");
    if (needs.runpath.empty()) append(rpath, folders_in(needs.rpath, origin));
    Folders folders = needs.runpath.empty() ? rpath : Folders();
    for (const Folders& more : {folders_in(given ? given : "", origin), folders_in(needs.runpath, origin), configured_})
      append(folders, more);
    for (const std::string& name : needs.libraries) {
      const std::string file = file_in(name.find('/') == name.npos ? folders : Folders{"."}, name);
      if (!file.empty() && !is_of_system(file)) visit(file, rpath);
    }
  }

  std::vector<std::string> found;

 private:
  static void append(Folders& list, const Folders& more) { list.insert(list.end(), more.begin(), more.end()); }

  Folders configured_ = configured_folders();
};

}  // namespace

std::vector<std::string> with_needed_libraries(const std::string& library) {
  Search search;
  search.visit(fs::absolute(library).string(), {});
  return search.found;
}

}  // namespace assay::adapters
