// SPDX-License-Identifier: BSD-3-Clause
// Any model, its points counted as they are updated.
#pragma once

#include <atomic>
#include <memory>

#include "harness/material/material.hpp"

namespace assay::test_materials {

namespace counting {

inline std::atomic<std::int64_t> points{0};
inline const assay_material* original = nullptr;

inline void update(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                   double* cauchy, std::int32_t* status, double* dt_factor, char* message) {
  points += static_cast<std::int64_t>(n);
  original->update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
}

}  // namespace counting

/// The same model, of this process, with the same parameters. One at a time; its count begins at 0.
inline std::shared_ptr<const Material> counted(const Material& material) {
  static assay_material table;
  if (material.table().update != counting::update) counting::original = &material.table();
  table = *counting::original;
  table.update = counting::update;
  counting::points = 0;
  std::map<std::string, double> parameters;
  for (std::uint32_t k = 0; k < table.parameter_count; ++k) {
    parameters[table.parameters[k].name] = material.parameters()[k];
  }
  return std::make_shared<const Material>(&table, parameters);
}

}  // namespace assay::test_materials
