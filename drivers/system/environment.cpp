// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/environment.hpp"

#include <sys/auxv.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "drivers/system/input_error.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

std::string environment_value(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

std::string own_folder(const char* own, const char* xdg, const std::string& of_home) {
  if (std::string said = environment_value(own); !said.empty()) return said;
  // The standard of XDG: relative paths are to be ignored.
  if (const std::string base = environment_value(xdg); base.starts_with('/')) return base + "/assay";
  if (const std::string home = environment_value("HOME"); home.starts_with('/')) return home + of_home + "/assay";
  return {};
}

std::string cache_home() { return own_folder("ASSAY_CACHE_HOME", "XDG_CACHE_HOME", "/.cache"); }

std::string absolute_path(const std::filesystem::path& path) {
  std::error_code code;
  const std::filesystem::path found = path.is_absolute() ? path : std::filesystem::current_path(code) / path;
  if (code) throw SystemError("the working directory cannot be found: " + code.message());
  return found.lexically_normal().string();
}

std::vector<std::string> material_folders() {
  std::vector<std::string> folders;
  for (const std::string& folder : split(environment_value("ASSAY_MATERIAL_PATH"), ':')) {
    if (!folder.empty()) folders.push_back(absolute_path(folder));
  }
  return folders;
}

void settle_environment() {
  if (environment_value("TMPDIR").empty()) ::unsetenv("TMPDIR");
  for (const char* name : {"ASSAY_CACHE_HOME", "TMPDIR"}) {
    const std::string path = environment_value(name);
    if (!path.empty() && !path.starts_with('/')) ::setenv(name, absolute_path(path).c_str(), 1);
  }
  if (environment_value("ASSAY_MATERIAL_PATH").empty()) return;
  std::string folders;
  for (const std::string& folder : material_folders()) folders += (folders.empty() ? "" : ":") + folder;
  ::setenv("ASSAY_MATERIAL_PATH", folders.c_str(), 1);
}

void settle_library_path(char** words) {
  namespace fs = std::filesystem;
  std::string given = environment_value("LD_LIBRARY_PATH");
  std::error_code code;
  const fs::path here = fs::current_path(code), program = fs::read_symlink("/proc/self/exe", code);
  const bool by_loader = ::getauxval(AT_BASE) == 0;  // it was called with the program's name: /proc/self/exe is its own
  if (given.empty() || code || by_loader) return;
  std::ranges::replace(given, ';', ':');
  std::string folders;
  for (const std::string& folder : split(given, ':')) {
    const bool is_fixed = folder.starts_with('/') || folder.starts_with('$');
    folders += (folders.empty() ? "" : ":") + (is_fixed ? folder : (here / folder).string());
  }
  if (folders.size() == given.size()) return;
  ::setenv("LD_LIBRARY_PATH", folders.c_str(), 1);
  ::execv(program.c_str(), words);
}

}  // namespace assay::drivers
