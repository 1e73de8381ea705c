// SPDX-License-Identifier: BSD-3-Clause
// A table's metadata as bytes, from one process to another.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "harness/assay_material.h"

namespace assay::adapters {

/// Which optional functions a table has, its example, if it has one, and its class of symmetry; 0: none.
struct TableAbilities {
  bool rate = false, tangent = false, energy = false, wave_speed = false, closed_form = false, reason = false;
  std::vector<double> example;
  std::int32_t material_class = 0;
};

/// Metadata that owns its words; its functions are null.
struct UnpackedTable {
  assay_material table{};
  TableAbilities abilities;
  std::vector<assay_parameter> parameters;
  std::vector<assay_state_variable> state;
  std::deque<std::string> words;
};

std::string packed(const assay_material& table);

/// Throws std::runtime_error where the bytes are no table.
void unpack(const std::string& bytes, UnpackedTable& table);

}  // namespace assay::adapters
