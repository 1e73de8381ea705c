// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/builtin.hpp"

#include <algorithm>
#include <string_view>

#define ASSAY_BUILTIN(NAME) extern "C" const assay_material* assay_builtin_##NAME(uint32_t host_major, uint32_t index);
#include "builtin_models.inc"
#undef ASSAY_BUILTIN

namespace assay::adapters {

const std::vector<const assay_material*>& builtin_tables() {
  static const std::vector<const assay_material*> tables = [] {
    std::vector<const assay_material*> all;
    constexpr assay_material_entry_function entries[] = {
#define ASSAY_BUILTIN(NAME) &assay_builtin_##NAME,
#include "builtin_models.inc"
#undef ASSAY_BUILTIN
    };
    for (const assay_material_entry_function entry : entries) {
      for (uint32_t i = 0; const assay_material* table = entry(ASSAY_ABI_MAJOR, i); ++i) all.push_back(table);
    }
    std::ranges::sort(all, {}, [](const assay_material* table) { return std::string_view(table->name); });
    return all;
  }();
  return tables;
}

const assay_material* builtin_table(const std::string& name) {
  const auto found = std::ranges::find(builtin_tables(), name, &assay_material::name);
  return found == builtin_tables().end() ? nullptr : *found;
}

}  // namespace assay::adapters
