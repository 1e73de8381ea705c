// SPDX-License-Identifier: BSD-3-Clause
// Tensors among state variables of a UMAT that nobody has said to be any.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adapters/foreign/foreign_model.hpp"
#include "drivers/material/material_choice.hpp"
#include "harness/check/battery.hpp"

namespace assay::drivers {

/// Components one after the other, from STATEV(first + 1) on.
struct StateBlock {
  std::size_t first;
  adapters::ForeignVariable::Kind kind;
};

/// What the state is if it is turned with a loaded body, so that the next step has the turned stress.
struct StateGuess {
  std::vector<StateBlock> blocks;  ///< empty: nothing fits
  bool turns = false;              ///< whether the numbers are more than scalars
};

/// strain, pressure: of the battery's histories.
StateGuess guessed_blocks(const ResolvedMaterial& material, const adapters::ForeignModel& model, double strain,
                          double pressure);

/// The same model with these tensors declared, by the names "STATEV(1:6)".
adapters::ForeignModel with_blocks(const adapters::ForeignModel& model, const std::vector<StateBlock>& blocks);

/// Of a UMAT that does not turn with the body, as its battery found: whether it is such a tensor. The diagnosis is then
/// that of the model with the tensor declared, and says how to declare it.
void judge_state_blocks(const ResolvedMaterial& material, check::Report& report);

}  // namespace assay::drivers
