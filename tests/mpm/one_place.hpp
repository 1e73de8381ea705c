// SPDX-License-Identifier: BSD-3-Clause
// Particles at one place of a grid, for tests of what is done to each.
#pragma once

#include "mpm/setup/setup.hpp"

namespace assay::mpm {

inline Setup<2> setup_at_one_place(std::size_t particles, int threads) {
  Setup<2> setup;
  setup.grid.spacing = 1;
  setup.grid.first.fill(-2);
  setup.grid.count = {8, 8};
  setup.seeds.half_size.fill(0.25);
  for (auto& X : setup.seeds.X) X.assign(particles, 0.3);
  setup.density = 1;
  setup.threads = threads;
  return setup;
}

}  // namespace assay::mpm
