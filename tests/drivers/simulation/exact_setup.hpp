// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/response_source.hpp"

namespace assay::drivers {

/// The problem's setup with what its body force is made of, as `run` makes it.
inline mpm::Setup<2> with_exact_solution(const Problem& problem) {
  mpm::Setup<2> setup = problem.setup;
  if (problem.compared) setup.exact = exact_solution_of(problem.scene, problem.material, problem.scene.time.end);
  return setup;
}

}  // namespace assay::drivers
