// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/state_place.hpp"

namespace assay::check {

std::vector<StatePlace> places_of(const Material& material) {
  const assay_material& table = material.table();
  std::vector<StatePlace> places;
  std::size_t at = 0;
  for (std::uint32_t v = 0; v < table.state_count; ++v) {
    const assay_state_variable& variable = table.state[v];
    const bool is_tensor = variable.kind == ASSAY_TENSOR || variable.kind == ASSAY_SYMMETRIC_TENSOR;
    const bool is_own = variable.role == ASSAY_ROLE_ROTATES_ITSELF && is_tensor;
    if (is_own || (variable.kind != ASSAY_SCALAR && variable.role == ASSAY_ROLE_PLAIN)) {
      places.push_back({variable.name, variable.kind, at, is_own});
    }
    at += static_cast<std::size_t>(components_of_kind(variable.kind));
  }
  return places;
}

}  // namespace assay::check
