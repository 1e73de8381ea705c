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
    std::sort(all.begin(), all.end(),
              [](const auto* a, const auto* b) { return std::string_view(a->name) < std::string_view(b->name); });
    return all;
  }();
  return tables;
}

const assay_material* builtin_table(const std::string& name) {
  const auto& all = builtin_tables();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto* table) { return name == table->name; });
  return found == all.end() ? nullptr : *found;
}

}  // namespace assay::adapters
