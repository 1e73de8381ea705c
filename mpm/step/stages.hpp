// SPDX-License-Identifier: BSD-3-Clause
// The stages of a step in time, and which passes run in each of them.
#pragma once

#include "harness/numeric/symplectic_stages.hpp"
#include "mpm/step/pass.hpp"

namespace assay::mpm {

/// One, of kick and drift, of an integrator without stages.
std::vector<SymplecticStage> stages_of(const Method& method);

/// Whether a pass runs in a stage out of so many; `later`: in the steps after the first.
bool runs_in(const PassInfo& pass, std::size_t stage, std::size_t stages, bool later);

/// How often a pass runs in a step after the first; in the first, where it runs in none of those.
std::size_t times_a_step(const PassInfo& pass, const Method& method);

}  // namespace assay::mpm
