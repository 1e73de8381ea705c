// SPDX-License-Identifier: BSD-3-Clause
// Which cases of a study are meant: conditions on the axes.
#pragma once

#include <string>
#include <vector>

#include "drivers/format/yaml_reader.hpp"
#include "drivers/study/findings.hpp"

namespace assay::drivers {

struct Condition {
  enum class Kind { one_of, none_of, below, above, between };
  std::string axis;
  Kind kind = Kind::one_of;
  std::vector<std::string> values;  ///< of one_of and none_of
  double lower = 0, upper = 0;      ///< bounds, as far as the kind has them
  Location where;
};

/// All conditions hold; without any, of every case.
struct Selection {
  std::vector<Condition> conditions;
  Location where;
  /// A case that has no value on an axis fulfils no condition on it but none_of.
  bool holds(const std::vector<AxisValue>& values) const;
};

/// {axis: value}, {axis: [values]}, {axis: {not: value or values}}, {axis: {below: x}}, above, {between: [x, y]}. `key`
/// is the path of the map. Throws InputError; what the axes are is not looked at.
Selection read_selection(const Tree& map, const std::string& key);

/// Whether two values of an axis are the same: as numbers where both are numbers, else as texts.
bool same_value(const std::string& a, const std::string& b);

/// A value on one line of YAML: "0.05", "[2, 2]", "{E: 1e3}".
std::string flow_text(const Tree& tree);

}  // namespace assay::drivers
