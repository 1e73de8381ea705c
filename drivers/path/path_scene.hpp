// SPDX-License-Identifier: BSD-3-Clause
// A path of the point driver as its scene says it: what is prescribed of one material point, and what is asked of it.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "drivers/material/material_choice.hpp"
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

/// A field of the surroundings that the model takes: its temperature, or one of `fields` of its description.
struct PathField {
  std::string name;
  PathFunction value;
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
  Location where = {};  ///< of the label
};

/// The quantity of that text. Throws InputError.
PathQuantity quantity_at(const std::string& text, const Location& where, const std::string& key);

/// Measured values that are drawn with the path.
struct PathComparison {
  std::string file;     ///< absolute
  PathQuantity x, y;    ///< x may be the time: then it has no terms
  PathFunction y_of_x;  ///< the file's columns: x in `times`, y in `values`
  Location where;
};

struct PathScene {
  std::string title, file, sha256;
  Units units;                   ///< in which the file is written; the values here are in SI
  std::string section = "path";  ///< as keys of it begin in messages; "stages[1]"
  MaterialChoice material;
  std::string type = "general";
  Deformation deformation = Deformation::logarithmic_strain;
  StressMeasure stress = StressMeasure::cauchy;
  std::vector<PathRow> rows;  ///< as many as the deformation has components
  std::vector<PathField> fields;
  double end = 1;       ///< of a later stage since its begin [s]
  Location where = {};  ///< of its control
  int count = 100;      ///< rows of the table
  double tolerance = 1e-10;
  double most_calls = 2e6;                 ///< of the model, by points
  std::array<double, 6> initial_stress{};  ///< 11, 22, 33, 12, 13, 23 [Pa]
  std::optional<double> confinement;       ///< [Pa]
  Location initial_where = {};             ///< of one of these
  std::vector<PathStop> stops;
  std::vector<PathVariant> variants;
  std::optional<PathComparison> compare;
  std::vector<int> increments;              ///< numbers of them whose error is asked for
  std::optional<IsoErrorChoice> iso_error;  ///< a map of it
  std::vector<Expectation> expect;
  std::vector<std::string> warnings;
  std::vector<PathScene> later;          ///< stages that follow this one: their rows, end, stops
  std::optional<ControlledPoint> start;  ///< of such a stage, on its way: where it begins
};

/// Of a later stage: begins where a point is whose stress was of that measure. Rows that the scene does not give keep
/// the values that they have there. Throws InputError where the stage needs a body that has not rotated, and it has.
PathScene begun_at(const PathScene& stage, const ControlledPoint& point, StressMeasure measure);

/// Whether a file's values are a path: they have the key `path`.
bool is_path_scene(const Tree& root);

/// Throws InputError.
PathScene path_scene_of(const Tree& root, const std::string& file, const std::string& sha256);

/// `path.fields`; the materials of the scene must let them vary. Throws InputError.
void read_path_fields(const Tree& tree, PathScene& scene);

/// Throws InputError where a field jumps.
void check_path_fields(const PathScene& scene);

/// Times at which they have kinks.
std::vector<double> knots_of_fields(const PathScene& scene);

/// A material whose fields follow the path. Throws InputError: what resolve_material() does, no such field.
ResolvedMaterial resolve_path_material(const PathScene& scene, const MaterialChoice& choice);

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

/// The same, but what stands beside a stress: "s11 + 2000 e11" in MPa is "s11 + 2000000000 e11".
PathQuantity in_si(PathQuantity quantity, const Units& units);

/// Measured values; a list of numbers of increments, ascending; a map of strains. Throw InputError.
void read_compare(const Tree& tree, PathScene& scene);
void read_increments(const Tree& tree, PathScene& scene);
void read_iso_error(const Tree& tree, PathScene& scene);

/// Of the end: two times that differ by less are one, of which rounding has made two.
inline constexpr double same_time = 1e-12;

/// What values of the quantity measure.
HistoryKind kind_of(const PathQuantity& quantity);

/// Throws InputError where a function has too many periods until the end, or begins behind it.
void check_times(const PathFunction& f, const std::string& key, const PathScene& scene);

/// Notes where a spline leaves the range of its data.
void warn_of_swings(PathScene& scene);

/// As the driver needs it.
Control control_of(const PathScene& scene);

/// YAML that reads back to the same path.
std::string resolved_path_yaml(const PathScene& scene);

}  // namespace assay::drivers
