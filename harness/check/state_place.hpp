// SPDX-License-Identifier: BSD-3-Clause
// What of the state turns with a body.
#pragma once

#include <string>
#include <vector>

#include "harness/check/state_variable.hpp"
#include "harness/material/material.hpp"

namespace assay::check {

/// A tensor or vector of the state that has to turn, or a tensor that is declared to turn by itself.
struct StatePlace {
  std::string name;
  std::int32_t kind;
  std::size_t at;
  bool is_own;  ///< declared to turn by itself

  Variable in(const std::vector<double>& state) const { return {kind, &state[at]}; }
};

std::vector<StatePlace> places_of(const Material& material);

}  // namespace assay::check
