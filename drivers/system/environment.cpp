// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/environment.hpp"

#include <sys/auxv.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

namespace {

std::string value_of_environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

}  // namespace

std::string cache_home() {
  if (std::string own = value_of_environment("ASSAY_CACHE_HOME"); !own.empty()) return own;
  // The standard of XDG: relative paths are to be ignored.
  if (const std::string xdg = value_of_environment("XDG_CACHE_HOME"); xdg.starts_with('/')) return xdg + "/assay";
  if (const std::string home = value_of_environment("HOME"); home.starts_with('/')) return home + "/.cache/assay";
  return {};
}

std::string absolute_path(const std::filesystem::path& path) {
  std::error_code code;
  const std::filesystem::path found = path.is_absolute() ? path : std::filesystem::current_path(code) / path;
  if (code) throw SystemError("the working directory cannot be found: " + code.message());
  return found.lexically_normal().string();
}

std::vector<std::string> material_folders() {
  std::vector<std::string> folders;
  const char* value = std::getenv("ASSAY_MATERIAL_PATH");
  const std::string path = value ? value : "";
  for (std::size_t begin = 0; begin < path.size();) {
    const std::size_t colon = std::min(path.find(':', begin), path.size());
    if (colon > begin) folders.push_back(absolute_path(path.substr(begin, colon - begin)));
    begin = colon + 1;
  }
  return folders;
}

void settle_environment() {
  if (value_of_environment("TMPDIR").empty()) ::unsetenv("TMPDIR");
  for (const char* name : {"ASSAY_CACHE_HOME", "TMPDIR"}) {
    const std::string path = value_of_environment(name);
    if (!path.empty() && !path.starts_with('/')) ::setenv(name, absolute_path(path).c_str(), 1);
  }
  if (value_of_environment("ASSAY_MATERIAL_PATH").empty()) return;
  std::string folders;
  for (const std::string& folder : material_folders()) folders += (folders.empty() ? "" : ":") + folder;
  ::setenv("ASSAY_MATERIAL_PATH", folders.c_str(), 1);
}

void settle_library_path(char** words) {
  namespace fs = std::filesystem;
  const std::string given = value_of_environment("LD_LIBRARY_PATH");
  std::error_code code;
  const fs::path here = fs::current_path(code), program = fs::read_symlink("/proc/self/exe", code);
  const bool by_loader = ::getauxval(AT_BASE) == 0;  // it was called with the program's name: /proc/self/exe is its own
  if (given.empty() || code || by_loader) return;
  std::string folders;
  for (std::size_t begin = 0; begin <= given.size();) {
    const std::size_t end = std::min(given.find_first_of(":;", begin), given.size());
    const std::string folder = given.substr(begin, end - begin);
    const bool is_fixed = folder.starts_with('/') || folder.starts_with('$');
    folders += (begin == 0 ? "" : ":") + (is_fixed ? folder : (here / folder).string());
    begin = end + 1;
  }
  if (folders.size() == given.size()) return;
  ::setenv("LD_LIBRARY_PATH", folders.c_str(), 1);
  ::execv(program.c_str(), words);
}

}  // namespace assay::drivers
