// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/material_path.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "drivers/system/environment.hpp"

namespace assay::drivers {

namespace {

std::string ending_of(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

bool ends_as_source(const std::string& text) { return is_fortran_source(text) || is_deck(text); }

bool ends_as_path(const std::string& text) {
  return text.ends_with(".so") || text.ends_with(".yaml") || text.ends_with(".yml") || ends_as_source(text);
}

}  // namespace

bool is_fortran_source(const std::string& file) {
  const std::string ending = ending_of(file);
  constexpr const char* known[] = {".f",   ".for", ".ftn", ".f77", ".f90", ".f95",
                                   ".f03", ".f08", ".f15", ".f18", ".fpp"};
  return std::any_of(std::begin(known), std::end(known), [&](const char* each) { return ending == each; });
}

bool is_deck(const std::string& file) { return ending_of(file) == ".inp"; }

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

}  // namespace assay::drivers
