// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/material_path.hpp"

#include <algorithm>
#include <cstdlib>

#include "drivers/input_error.hpp"
#include "drivers/material/abaqus_deck.hpp"
#include "drivers/material/fortran_form.hpp"

namespace assay::drivers {

namespace {

bool ends_as_source(const std::string& text) { return is_fortran_source(text) || is_deck(text); }

bool ends_as_path(const std::string& text) {
  return text.ends_with(".so") || text.ends_with(".yaml") || text.ends_with(".yml") || ends_as_source(text);
}

}  // namespace

MaterialName parse_material(const std::string& adapter) {
  const std::size_t colon = adapter.rfind(".so:");
  if (colon != adapter.npos && adapter.find('/', colon) == adapter.npos) {
    return {true, adapter.substr(0, colon + 3), adapter.substr(colon + 4)};
  }
  const std::size_t last = adapter.rfind(':');
  if (last != adapter.npos && adapter.find('/', last) == adapter.npos && ends_as_source(adapter.substr(0, last))) {
    return {true, adapter.substr(0, last), adapter.substr(last + 1)};
  }
  return {adapter.find('/') != adapter.npos || ends_as_path(adapter), adapter, {}};
}

std::string absolute_path(const std::filesystem::path& path) {
  std::error_code code;
  const std::filesystem::path found = path.is_absolute() ? path : std::filesystem::current_path(code) / path;
  if (code) throw SystemError("the working directory cannot be found: " + code.message());
  return found.lexically_normal().string();
}

std::string absolute_material(const std::string& adapter, const std::filesystem::path& folder) {
  const MaterialName name = parse_material(adapter);
  if (!name.is_path) return adapter;
  const auto path = absolute_path(folder / name.file);
  const std::string rest = adapter.substr(name.file.size());
  return path + rest;
}

bool is_material_name(const std::string& name) {
  const auto alnum = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); };
  return !name.empty() && name.size() <= 100 && alnum(name[0]) && !ends_as_path(name) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return alnum(c) || c == '_' || c == '-' || c == '.'; });
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

}  // namespace assay::drivers
