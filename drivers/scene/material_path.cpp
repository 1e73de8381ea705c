// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/material_path.hpp"

#include <algorithm>

#include "drivers/system/environment.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

std::string ending_of(const std::string& file) {
  return small_letters(std::filesystem::path(file).extension().string());
}

bool ends_as_source(const std::string& text) { return is_fortran_source(text) || is_deck(text); }

bool ends_as_path(const std::string& text) {
  return text.ends_with(".so") || text.ends_with(".yaml") || text.ends_with(".yml") || ends_as_source(text);
}

}  // namespace

bool is_fortran_source(const std::string& file) {
  return is_one_of(ending_of(file),
                   {".f", ".for", ".ftn", ".f77", ".f90", ".f95", ".f03", ".f08", ".f15", ".f18", ".fpp"});
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
  const auto of_name = [](char c) { return is_letter_or_digit(c) || c == '_' || c == '-' || c == '.'; };
  return !name.empty() && name.size() <= 100 && is_letter_or_digit(name[0]) && !ends_as_path(name) &&
         std::all_of(name.begin(), name.end(), of_name);
}

}  // namespace assay::drivers
