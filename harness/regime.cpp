// SPDX-License-Identifier: BSD-3-Clause
#include "harness/regime.hpp"

#include <cmath>
#include <string_view>

#include "harness/material.hpp"

namespace assay {

RegimeReader::RegimeReader(const assay_material& table) {
  std::vector<std::size_t> scalars, names;
  std::size_t offset = 0;
  for (std::uint32_t k = 0; k < table.state_count; ++k) {
    const assay_state_variable& variable = table.state[k];
    if (variable.kind == ASSAY_SCALAR) {
      const bool names_regime = variable.unit && std::string_view(variable.unit) == "regime";
      (names_regime ? names : scalars).push_back(offset);
    }
    offset += static_cast<std::size_t>(components_of_kind(variable.kind));
  }
  named_ = !names.empty();
  watched_ = named_ ? names : scalars;
}

std::uint64_t RegimeReader::of(const double* state0, const double* state1) const {
  std::uint64_t regime = 0;
  for (const std::size_t k : watched_) {
    if (named_) {
      regime = regime * 1000003u + static_cast<std::uint64_t>(std::llround(state1[k]) + 1);
    } else {
      regime = (regime << 1) | (state1[k] != state0[k] && state1[k] != 0 ? 1u : 0u);
    }
  }
  return regime;
}

}  // namespace assay
