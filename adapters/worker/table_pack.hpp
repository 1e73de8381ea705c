// SPDX-License-Identifier: BSD-3-Clause
// A table's metadata as bytes, from one process to another.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "harness/assay_material.h"

namespace assay::adapters {

/// Metadata that owns its words; its functions are null.
struct UnpackedTable {
  assay_material table{};
  std::vector<assay_parameter> parameters;
  std::vector<assay_state_variable> state;
  std::uint32_t offered = 0;        ///< a bit for each of StatusExtensions: whether the table has its function
  std::vector<double> example;      ///< empty: none
  std::int32_t material_class = 0;  ///< of assay_symmetry; 0: none
  std::deque<std::string> words;
};

/// Throws ModelThrew.
std::string packed(const assay_material& table);

/// Throws std::runtime_error where the bytes are no table.
void unpack(const std::string& bytes, UnpackedTable& table);

/// Components of the state of one point.
std::size_t state_size_of(const assay_material& table);

}  // namespace assay::adapters
