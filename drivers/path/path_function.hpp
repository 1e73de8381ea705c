// SPDX-License-Identifier: BSD-3-Clause
// A prescribed value of a path as its scene says it: a number, or a map with `type`.
#pragma once

#include <string>
#include <vector>

#include "drivers/format/yaml_values.hpp"
#include "drivers/text/units.hpp"
#include "harness/control/time_function.hpp"

namespace assay::drivers {

struct PathFunction {
  enum class Type { constant, ramp, sine, cycles, table, file };
  enum class Shape { triangle, sine };

  Type type = Type::constant;
  double value = 0;                                       ///< constant
  double from = 0, to = 0, begin = 0, end = 0;            ///< ramp; end 0: that of the path
  double mean = 0, amplitude = 0, period = 0, phase = 0;  ///< sine, and the period of cycles; phase [degrees]
  std::vector<double> sizes;                              ///< cycles
  Shape shape = Shape::triangle;                          ///< cycles
  std::vector<double> times, values;                      ///< table
  std::string file, column, time = "t";                   ///< file: absolute path, name of a column, of that of times
  Interpolation interpolation = Interpolation::linear;
  double factor = 1, offset = 0;  ///< file
  std::string unit, time_unit;    ///< file: of columns whose headers say none; empty: those of the scene, then SI
  bool says_from = false, says_column = false;
  Location where;

  /// Time at which it ends by itself; 0: it goes on.
  double last() const;
};

/// What a column measures: a unit in its header must be of that. field: a quantity of the model, in its own unit.
enum class HistoryKind { stress, number, time, rate, field };

/// The SI unit of a kind.
const char* si_unit_of(HistoryKind kind);

/// Reads the value of a row, a file with it. `key` is its path in messages, `name` that of the row, which is the column
/// where the scene names none. Throws InputError.
PathFunction read_path_function(const Tree& tree, const std::string& key, const std::string& name, HistoryKind kind,
                                const Units& units);

/// YAML that reads back to the same.
std::string path_function_yaml(const PathFunction& function);

/// As the driver needs it. rest: the value at rest, from which a ramp begins where it does not say from; path_end [s]:
/// where it ends where it does not say when.
TimeFunction time_function_of(const PathFunction& function, double rest, double path_end);

/// Reads the file behind a function, whose values then stand in its table, in SI. Throws InputError.
void read_history_file(PathFunction& function, const std::string& name, const std::string& key, HistoryKind kind,
                       const Units& units = {}, HistoryKind time_kind = HistoryKind::time);

}  // namespace assay::drivers
