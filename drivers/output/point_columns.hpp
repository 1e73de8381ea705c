// SPDX-License-Identifier: BSD-3-Clause
// What a table of exact values holds: its columns, and the fields of which these are components.
#pragma once

#include <string>
#include <vector>

#include "drivers/output/point_reader.hpp"

namespace assay::drivers {

enum class Quantity {
  reference,
  time,
  position,
  velocity,
  acceleration,
  gradient,
  piola,
  cauchy,
  force,
  volume,
  moment,
  traction
};

struct PointColumn {
  std::string name;
  Quantity quantity = Quantity::reference;
  int component = 0;  ///< of a vector 0 to 2, of a tensor 0 to 8, row-major
};

/// Several columns side by side, as one array of numbers. The width of a vector is the dimension, that of F and P is 9,
/// row-major, that of the Cauchy stress 6: 11, 22, 33, 12, 13, 23.
struct PointField {
  std::string name;
  std::vector<int> columns;  ///< of each component; -1: zero
  bool is_tensor = false;
};

struct PointColumns {
  std::vector<PointColumn> columns;
  std::vector<PointField> fields;
};

/// All columns of a table, in their order. three: with all components of three dimensions.
std::vector<PointColumn> all_point_columns(bool three, const PointsGiven& given);

/// What --columns asks for: names of columns, and words for all components of a field, with commas between them; empty:
/// everything. Throws InputError with the nearest name.
PointColumns wanted_columns(const std::string& asked, bool three, const PointsGiven& given);

}  // namespace assay::drivers
