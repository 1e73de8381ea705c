// SPDX-License-Identifier: BSD-3-Clause
// The list of the optional effects: what each is, the scene key that calls for it, and what it brings into a run. What
// a scene does not call for is not there: no pass, column, grid field, observer or call of the material.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "drivers/simulation/problem.hpp"

namespace assay::drivers {

struct EffectEntry {
  std::string name, doc;
  std::string key;                                 ///< of the scene; empty: no key calls for it
  std::string around;                              ///< what it brings around the steps; empty: nothing
  std::function<bool(const Problem&)> called_for;  ///< by this scene
  bool asks_material = false;                      ///< it can, in steps, for more than the particles' stress
  /// Where another key than `key` can call for it, too: the one that does so here.
  std::function<std::string(const Problem&)> called_by = nullptr;

  std::string key_of(const Problem& problem) const { return called_by ? called_by(problem) : key; }
};

/// Those of a step, which are the records of mpm/effects, and those of a run, around its steps.
std::span<const EffectEntry> effects();

/// Throws std::out_of_range where there is none.
const EffectEntry& entry_of(const std::string& effect);

/// Names of those that the problem calls for.
std::vector<std::string> effects_of(const Problem& problem);

}  // namespace assay::drivers
