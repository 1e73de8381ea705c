// SPDX-License-Identifier: BSD-3-Clause
// What is measured of the particle method: the paper's vortex by the methods that people choose between.
#pragma once

#include <string>
#include <vector>

#include "mpm/setup/setup.hpp"

namespace assay::bench {

struct Case {
  std::string name;
  mpm::Method method;
};
std::vector<Case> method_cases();

/// The free ring with 2x2 particles a cell, so many cells across: 5,032 particles at 10.
mpm::Setup<2> vortex(const mpm::Method& method, int across, int threads);

/// Steps at 0.3 of the period, so short that nothing moves: the exact state is not that of the particles, and no pass
/// minds [s].
inline constexpr double step_begin = 0.3, step_length = 1e-9;

}  // namespace assay::bench
