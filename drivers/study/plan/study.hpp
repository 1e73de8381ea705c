// SPDX-License-Identifier: BSD-3-Clause
// A study as plain values: a base scene, axes along which it is changed, and what is asked of the cases.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drivers/format/yaml_reader.hpp"
#include "drivers/result/fields.hpp"
#include "drivers/result/result.hpp"
#include "drivers/scene/scene.hpp"
#include "drivers/scene/scene_reader.hpp"

namespace assay::drivers {

/// Where a case stands on one axis.
struct AxisValue {
  std::string axis, value;  ///< "method", "CPDI, FLIP"; "grid.spacing", "0.05"

  ASSAY_FIELDS(axis, value)
};

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

/// One value of an axis and what it sets.
struct Level {
  std::string name;  ///< the level's, or the value's text
  std::vector<Setting> settings;
};

/// Where a Latin hypercube takes values of a key from.
struct Span {
  double from = 0, to = 0;
  bool logarithmic = false, whole = false;
};

/// Named levels of several keys, or values of the one key that names the axis.
struct StudyAxis {
  std::string name;
  std::vector<Level> levels;
  std::optional<Span> span;
  bool is_key = false;
  Location where;
};

struct Sampling {
  enum class Type { product, list, latin_hypercube };
  Type type = Type::product;
  int count = 0;  ///< of a Latin hypercube
  int seed = 1;   ///< of its pseudo-random numbers
};

/// Timed cases run alone, again and again.
struct StudyTiming {
  int repeat = 3;       ///< runs of a case
  double seconds = 60;  ///< a case that has taken so long [s] is not repeated
  Selection where;      ///< the cases that are timed
  bool none = false;    ///< nothing is
};

/// A finer setting of one source of the error.
struct BudgetSource {
  std::string name;
  std::vector<Setting> settings;
};

struct StudyBudget {
  Selection of;  ///< the cases whose error is divided
  std::vector<BudgetSource> sources;
};

/// What is to be found of the cases of a selection, or of their series: keys of result.json, order, order_last.
struct StudyExpectation {
  Selection where;
  Expectation line;
  bool implied = false;  ///< that a case completes, where nothing is said of its outcome: told where it does not
};

/// An order that others have published of the series of a selection.
struct PublishedOrder {
  Selection where;
  double order = 0;
  std::string source;  ///< "Brannon et al., figure 4"
};

/// Cases that would say nothing, with the reason: they are n/a.
struct NotApplicable {
  Selection where;
  std::string because;
};

struct Study {
  std::string title, question;
  std::string file, text, sha256;  ///< of the study: as given, its bytes, their hash
  std::string scene;               ///< file of the base scene, from the working directory;
  Location scene_where;
  std::vector<Setting> set;  ///< of every case
  std::vector<StudyAxis> axes;
  Sampling sampling;
  std::vector<std::vector<std::pair<std::string, Tree>>> listed;  ///< cases of a list: axis, value
  std::vector<Selection> excluded;
  std::vector<NotApplicable> not_applicable;
  std::string refine;  ///< key of resolution; empty: none
  Location refine_where;
  std::string error = "error.relative", cost = "step_cpu_s";
  bool asks_survival = false;  ///< the answer is which method lives through most, not what accuracy costs
  bool skips_invalid = false;  ///< cases that cannot be are n/a, not an error
  double case_seconds = 0;     ///< a case that takes longer is stopped [s]; 0: never
  StudyTiming timing;
  std::optional<StudyBudget> budget;
  std::vector<PublishedOrder> published;
  std::vector<StudyExpectation> expect;
};

/// What an axis may set beside the keys of a scene: threads of the run, and another base scene's file.
inline constexpr const char* threads_key = "threads";
inline constexpr const char* scene_key = "scene";

// The cases of a study, each with its scene, ready to be run.

/// One combination: where it stands on every axis that it has a value of, and what that sets.
struct Combination {
  std::vector<AxisValue> values;
  std::vector<Setting> settings;
};

/// All that the study samples and does not exclude: the full product with the last axis fastest, the list, or a Latin
/// hypercube, in which each axis is cut into as many equal parts as there are cases and each part is taken once. The
/// same study gives the same combinations everywhere. Throws InputError where there are none or too many.
std::vector<Combination> combinations_of(const Study& study);

inline constexpr std::size_t most_combinations = 100000;

/// Of the resolved scene, the files that it names (the material's library and description, a table of the motion), what
/// a material that is not built in answers along a short way, the number of threads, and this program with the shared
/// libraries that it runs with: 32 hexadecimal digits. Throws InputError where a file cannot be read.
std::string case_key(const Scene& scene, const std::string& resolved, int threads);

struct PlannedCase {
  std::size_t number = 0;  ///< from 1
  std::vector<AxisValue> values;
  std::string label, series;
  Figure resolution;  ///< value of the refined key
  int threads = 1;
  std::string yaml;                 ///< the text of its scene, every default written out
  std::string key;                  ///< 32 hexadecimal digits; empty where the case cannot be
  std::string invalid;              ///< why it cannot be, one line
  double particle_steps = 0;        ///< expected
  bool timed = false;               ///< runs alone, and again
  std::optional<std::size_t> base;  ///< of a case that refines one source of another's error: that one's index
  std::size_t source = 0;           ///< and the source's index in the study's budget
};

struct Plan {
  Study study;
  std::vector<PlannedCase> cases;
};

/// Reads every scene as `assay run` would. Throws InputError where one cannot be, unless the study skips such.
/// `progress` is told the share that is done.
Plan plan_of(Study study, const std::function<void(double)>& progress = {});

}  // namespace assay::drivers
