// SPDX-License-Identifier: BSD-3-Clause
// The list of the optional effects: what each is, the scene key that calls for it, and what it brings into a run. What
// a scene does not call for is not there: no pass, column, grid field, observer or call of the material.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "drivers/simulation/problem.hpp"
#include "mpm/data/effect.hpp"

namespace assay::drivers {

struct EffectEntry {
  mpm::Effect effect;
  std::string name, doc;
  std::string key;                     ///< of the scene; empty: no key calls for it
  bool (*called_for)(const Problem&);  ///< by this scene
  std::vector<std::string> passes;     ///< that it can bring; which of them, and with which columns, the method decides
  std::vector<mpm::Column> columns;
  std::vector<std::string> grid_fields;
  bool asks_material;  ///< it can, in steps, for more than the particles' stress
  std::string around;  ///< what else it brings, around the steps; empty: nothing
  /// Where another key than `key` can call for it, too: the one that does so here.
  std::string (*called_by)(const Problem&) = nullptr;

  std::string key_of(const Problem& problem) const { return called_by ? called_by(problem) : key; }
};

/// In the order of mpm::Effect.
std::span<const EffectEntry> effects();
const EffectEntry& entry_of(mpm::Effect effect);

std::vector<mpm::Effect> effects_of(const Problem& problem);

/// Throws InputError where the problem calls for an effect that this build does not have.
void require_compiled(const Problem& problem);

}  // namespace assay::drivers
