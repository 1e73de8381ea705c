// SPDX-License-Identifier: BSD-3-Clause
// The stages of a step in time, and which passes run in each of them.
#pragma once

#include <algorithm>

#include "harness/numeric/symplectic_stages.hpp"
#include "mpm/step/pass.hpp"

namespace assay::mpm {

/// One, of kick and drift, of an integrator without stages.
inline std::vector<SymplecticStage> stages_of(const Method& method) {
  return method.has_stages() ? symplectic_rkn4() : std::vector<SymplecticStage>{SymplecticStage{}};
}

/// Whether a pass runs in a stage out of so many; `later`: in the steps after the first.
inline bool runs_in(const PassInfo& pass, std::size_t stage, std::size_t stages, bool later) {
  if (pass.once) return stage == 0 && !later;
  if (stages == 1 || pass.stages == Stages::all) return true;
  return (stage == 0) == (pass.stages == Stages::first);
}

/// How often a pass runs in a step after the first; in the first, where it runs in none of those.
inline std::size_t times_a_step(const PassInfo& pass, const Method& method) {
  const std::size_t stages = stages_of(method).size();
  std::size_t times = 0;
  for (std::size_t k = 0; k < stages; ++k) times += runs_in(pass, k, stages, true) ? 1 : 0;
  return std::max<std::size_t>(times, 1);
}

}  // namespace assay::mpm
