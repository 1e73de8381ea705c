// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/cache_home.hpp"

#include <cstdlib>

#include "drivers/material/material_path.hpp"

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

void settle_environment() {
  for (const char* name : {"ASSAY_CACHE_HOME", "TMPDIR"}) {
    const std::string path = value_of_environment(name);
    if (!path.empty() && !path.starts_with('/')) ::setenv(name, absolute_path(path).c_str(), 1);
  }
  if (value_of_environment("ASSAY_MATERIAL_PATH").empty()) return;
  std::string folders;
  for (const std::string& folder : material_folders()) folders += (folders.empty() ? "" : ":") + folder;
  ::setenv("ASSAY_MATERIAL_PATH", folders.c_str(), 1);
}

}  // namespace assay::drivers
