// SPDX-License-Identifier: BSD-3-Clause
// A path of the point driver as its scene says it: what is prescribed of one material point, and what is asked of it.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "drivers/path/path_function.hpp"
#include "drivers/path/path_quantity.hpp"
#include "drivers/scene/scene.hpp"
#include "harness/control/increment_errors.hpp"

namespace assay::drivers {

/// "e11: 0.1", and rows that the path's type supplies or that hold a component which nobody names.
struct PathRow {
  PathQuantity quantity;
  PathFunction value;
  enum class Origin { given, supplied, held } origin = Origin::given;
  Location where;
};

struct PathStop {
  ControlStop::When when = ControlStop::When::above;
  PathQuantity quantity;
  double bound = 0;
  Location where;
};

/// Another material, or the same with other parameters.
struct PathVariant {
  std::string label;
  MaterialChoice material;
};

/// Measured values that are drawn with the path.
struct PathComparison {
  std::string file;     ///< absolute
  PathQuantity x, y;    ///< x may be the time: then it has no terms
  PathFunction y_of_x;  ///< the file's columns: x in `times`, y in `values`
  Location where;
};

struct PathScene {
  std::string title, file, sha256;
  MaterialChoice material;
  std::string type = "general";
  Deformation deformation = Deformation::logarithmic_strain;
  StressMeasure stress = StressMeasure::cauchy;
  std::vector<PathRow> rows;  ///< as many as the deformation has components
  double end = 1;             ///< [s]
  int count = 100;            ///< rows of the table
  double tolerance = 1e-10;
  double most_calls = 2e6;                 ///< of the model, by points
  std::array<double, 6> initial_stress{};  ///< 11, 22, 33, 12, 13, 23 [Pa]
  std::optional<double> confinement;       ///< [Pa]
  std::vector<PathStop> stops;
  std::vector<PathVariant> variants;
  std::optional<PathComparison> compare;
  std::vector<int> increments;              ///< numbers of them whose error is asked for
  std::optional<IsoErrorChoice> iso_error;  ///< a map of it
  std::vector<Expectation> expect;
  std::vector<std::string> warnings;
};

/// Whether a file's values are a path: they have the key `path`.
bool is_path_scene(const Tree& root);

/// Throws InputError.
PathScene path_scene_of(const Tree& root, const std::string& file, const std::string& sha256);

/// What a type of path supplies: rows by their text, for the measures that are in use, and what must be given.
struct PathType {
  const char* word;
  const char* doc;
  std::vector<std::string> supplies;  ///< "S22", "D22 - D11", "V": S and D stand for the measures, V for the volume
  std::vector<std::string> drives;    ///< components of which one must be given: "11"
};
const std::vector<PathType>& path_types();

/// The rows that the scene gives, those of its type, and one for each component that nobody names. Throws InputError.
void complete_rows(PathScene& scene, const Location& where);

/// What values of the quantity measure.
HistoryKind kind_of(const PathQuantity& quantity);

/// Throws InputError where a function has too many periods until the end, or begins behind it.
void check_times(const PathRow& row, double end);

/// Notes where a spline leaves the range of its data.
void warn_of_swings(PathScene& scene);

/// As the driver needs it.
Control control_of(const PathScene& scene);

/// YAML that reads back to the same path.
std::string resolved_path_yaml(const PathScene& scene);

}  // namespace assay::drivers
