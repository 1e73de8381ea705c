// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/step/stages.hpp"

#include <algorithm>

namespace assay::mpm {

std::vector<SymplecticStage> stages_of(const Method& method) {
  return method.has_stages() ? symplectic_rkn4() : std::vector<SymplecticStage>{SymplecticStage{}};
}

bool runs_in(const PassInfo& pass, std::size_t stage, std::size_t stages, bool later) {
  if (pass.once) return stage == 0 && !later;
  if (stages == 1 || pass.stages == Stages::all) return true;
  return (stage == 0) == (pass.stages == Stages::first);
}

std::size_t times_a_step(const PassInfo& pass, const Method& method) {
  const std::size_t stages = stages_of(method).size();
  std::size_t times = 0;
  for (std::size_t k = 0; k < stages; ++k) times += runs_in(pass, k, stages, true) ? 1 : 0;
  return std::max<std::size_t>(times, 1);
}

}  // namespace assay::mpm
