// SPDX-License-Identifier: BSD-3-Clause
// `assay eval`: the exact fields of a motion at given reference points and times, block by block: the memory that it
// needs does not depend on the number of rows.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "drivers/command_line/verb.hpp"
#include "drivers/findings/findings.hpp"
#include "drivers/format/yaml_writer.hpp"
#include "drivers/output/point_table.hpp"
#include "drivers/output/time_list.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/exact_rows.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/simulation/warnings.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/progress.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/verbs/verbs.hpp"
#include "harness/motion/kinds/deformation_table.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t points_at_once = 16'384;
/// Of boxes, whose neighbours share faces, and of points with histories, which are followed once for all their times:
/// both within a block alone.
constexpr std::size_t related_at_once = 65'536;

/// What a first look at all points finds.
struct Looked {
  std::uint64_t points = 0;                      ///< in the file
  double last = 0;                               ///< time [s]
  std::map<double, std::uint64_t> rows_at = {};  ///< of each time, where it is asked for
};

/// How many values of a table are no finite numbers, and the first of them.
class EmptyFields {
 public:
  explicit EmptyFields(const std::vector<PointColumn>& columns) : names_(mapped(columns, &PointColumn::name)) {}

  void add(std::span<const double> values, const std::vector<ReferencePoint>& block) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (std::isfinite(values[k])) continue;
      if (count_++ == 0) column_ = names_[k % names_.size()], line_ = block[k / names_.size()].line;
    }
    of_ += values.size();
  }
  void tell() const {
    if (count_ == 0) return;
    warn(std::to_string(count_) + " of " + std::to_string(of_) + " values are not finite and stay empty, first " +
         column_ + " of line " + std::to_string(line_) +
         " of the points: a time, speed or size of the scene is so small or large that its powers are no numbers");
  }

 private:
  std::vector<std::string> names_;
  std::uint64_t count_ = 0, of_ = 0;
  std::string column_;
  int line_ = 0;  ///< of the points
};

/// A box in the plane has no third edge, and one in space has; so has a normal in space a third component.
void require_columns_in_space(const PointsGiven& given, const Scene& scene, bool three, const std::string& file) {
  if (scene.dimension == 3 && given.normals && !given.third_normal)
    throw InputError({file, 1, 1}, "NX", "normals in three dimensions need NZ");
  if (!given.boxes || given.third_edge == three) return;
  throw InputError({file, 1, 1}, three ? "HX" : "HZ",
                   three ? "boxes in three dimensions need HZ" : "boxes of a plane scene have HX and HY alone");
}

/// Refuses what cannot be evaluated, before anything is written.
Looked look_at_points(PointReader& points, const std::vector<double>& times, const Scene& scene, bool three,
                      bool by_time, const EvalOptions& options) {
  Looked found;
  if (!times.empty()) points.rewind({*std::ranges::max_element(times)});
  Progress progress("points", options.quiet() || prints_to_terminal());
  std::vector<ReferencePoint> block;
  while (points.next(block, points_at_once)) {
    stop_if_interrupted();
    require_within_motion(scene, block, options.points);
    if (points.given().boxes) require_boxes(scene.motion, block, three, options.points);
    for (const ReferencePoint& point : block) {
      found.last = std::max(found.last, point.t);
      if (by_time && times.empty()) ++found.rows_at[point.t];
    }
    found.points += block.size();
    progress.update(points.share());
  }
  for (const double t : times) found.rows_at[t] += found.points;
  points.rewind(times);
  return found;
}

/// VTU needs the positions, and all files the times to which their rows belong.
void add_hidden_columns(PointColumns& wanted, const std::vector<PointColumn>& all) {
  for (const PointColumn& column : all) {
    const bool needed = column.quantity == Quantity::position || column.quantity == Quantity::time;
    const auto same = [&](const PointColumn& there) { return there.name == column.name; };
    if (needed && std::ranges::none_of(wanted.columns, same)) wanted.columns.push_back(column);
  }
}

void write_table(ExactRows& exact, PointReader& points, PointTable& table, std::uint64_t rows, std::size_t at_once,
                 EmptyFields& empty, const EvalOptions& options) {
  Progress progress("eval", options.quiet() || prints_to_terminal());
  std::vector<ReferencePoint> block;
  std::vector<double> values;
  std::uint64_t done = 0;
  while (points.next(block, at_once)) {
    if (block.size() > rows - done) break;
    exact.evaluate(block, values, [&](double share, const char* of) {
      stop_if_interrupted();
      progress.update(
          (static_cast<double>(done) + share * static_cast<double>(block.size())) / static_cast<double>(rows), of);
    });
    done += block.size();
    table.add(values);
    empty.add(values, block);
  }
  if (done != rows) throw InputError({options.points, 0, 0}, "", "was changed while it was read");
}

constexpr double rounding = 1e-9;  ///< of a time that is a sum of steps

/// end: set to the last time, as soon as it is known.
void evaluate_points(const EvalOptions& options, double& end) {
  Scene scene = read_scene(options.scene, options.sets);
  if (options.is_static) scene.force.quasi_static = true;
  require_acceleration(scene);
  const std::string swing = swing_sentence(scene);
  if (!swing.empty()) std::fprintf(stderr, "warning: %s\n", swing.c_str());
  const TableFormat format = format_of(options.format, options.out);
  if (format != TableFormat::csv && (options.out.empty() || options.out == standard_stream) && prints_to_terminal())
    throw InputError({}, "--format", "a terminal shows no " + options.format + ": name a file with -o, or use a pipe");
  watch_interrupts();
  const std::vector<double> times = options.times.empty() ? std::vector<double>() : read_times(options.times);
  const InputBytes input(options.points);
  PointReader points(input, times);
  const PointsGiven& given = points.given();
  const bool three = scene.dimension == 3 || scene.motion->is_spatial();
  require_columns_in_space(given, scene, three, options.points);
  TableShape shape{wanted_columns(options.columns, three, given)};
  if (format == TableFormat::vtu) add_hidden_columns(shape.wanted, all_point_columns(three, given));
  Looked looked = look_at_points(points, times, scene, three, format == TableFormat::vtu, options);
  shape.rows = looked.points * std::max<std::size_t>(times.size(), 1);
  if (format == TableFormat::vtu) shape.rows_at = std::move(looked.rows_at);
  end = looked.last > 0 ? looked.last : scene.time.end;
  std::string library;
  const auto material = material_of(scene, library);
  refuse_input_as_output(options.out, "-o");
  require_table_name(options.format, options.out);
  if (end > scene.time.end * (1 + rounding))
    warn("the last time, " + scene.units.text(end, "s", 6) + ", is after time.end of the scene, " +
         scene.units.text(scene.time.end, "s", 6));
  const std::vector<PointColumn> columns = shape.wanted.columns;
  const RowNeeds needs(columns, given.boxes);
  const bool quiet = options.quiet();
  ExactSolutionPtr solution;
  if (needs.response()) {
    warn_of_instability(scene, *material, end, quiet);
    if (scene.force.response == ForceChoice::Response::none) scene.force.response = ForceChoice::Response::sheet;
    solution = exact_solution_of_points(scene, material, end, quiet);
  } else {
    solution = motion_alone(scene, material);
  }
  EmptyFields empty(columns);
  ExactRows exact(solution, columns, {scene.material.density, three, given.boxes, scene.force.quasi_static});
  const auto table = point_table(format, options.out, std::move(shape));
  const std::uint64_t rows = looked.points * std::max<std::size_t>(times.size(), 1);
  const bool related = given.boxes || (needs.response() && !solution->response());
  write_table(exact, points, *table, rows, related ? related_at_once : points_at_once, empty, options);
  table->finish();
  Result process;
  record_process(*material, process);
  for (const std::string& warning : process.warnings) warn(warning);
  empty.tell();
}

/// The command that leaves the step at which the material failed, as this verb writes no folder.
std::string hint_of(const EvalOptions& options, double end) {
  const Scene scene = read_scene(options.scene, options.sets);
  std::string command = "; `assay tabulate " + scene.file;
  // tabulate takes another function between the rows unless it is told
  const bool table = scene.motion.as<DeformationTable>();
  if (table && !scene.places.contains("motion.interpolation")) command += " --set motion.interpolation=monotone";
  for (const std::string& set : options.sets) command += " --set '" + set + "'";
  return command + " --set time.end=" + yaml_number(end) + "` leaves the step in a replay.yaml";
}

Act add_eval_arguments(VerbArguments& verb) {
  const auto given = std::make_shared<EvalOptions>();
  add_scene(verb, *given);
  add_value(verb, "--points", given->points, "FILE", "reference points X,Y,t and more: CSV, .npy or .npz")->required();
  add_value(verb, "--times", given->times, "TIMES", "0,.1,.2 or a file: times for points without t");
  add_value(verb, "--columns", given->columns, "NAME,...", "only these columns, in this order");
  verb.app.add_flag("--static", given->is_static, "b without inertia, for quasi-static codes");
  add_out(verb, given->out, "FILE", ".csv, .npy, .npz or .vtu (default: standard output)");
  add_value(verb, "--format", given->format, "FORMAT", "csv, npy, npz or vtu, whatever the file is called",
            "csv npy npz vtu");
  return act_of(given, eval);
}

}  // namespace

int eval(const EvalOptions& options) {
  forget_inputs();
  const auto require_apart = [](const std::string& one, const std::string& other, const char* option) {
    if (is_same_stream(one, other)) throw InputError({}, option, "is the scene's stream, which can be read once");
  };
  require_apart(options.scene, options.points, "--points");
  require_apart(options.scene, options.times, "--times");
  if (is_same_stream(options.points, options.times))
    throw InputError({}, "--times", "is the points' stream, which can be read once");
  double end = 0;
  try {
    evaluate_points(options, end);
    return 0;
  } catch (const MaterialFailure& failure) {
    Result result;
    record_failure(failure, result);
    const std::string hint = failure.step ? hint_of(options, end) : "";
    std::fprintf(stderr, "%s%s\n", one_line(result.reason).c_str(), one_line(hint).c_str());
    return 1;
  }
}

Verb verb_eval() {
  return {80, "exact motion, stress and body force at given points",
          "assay eval scene.yaml --points X_Y_t.csv -o exact.csv", add_eval_arguments};
}

}  // namespace assay::drivers
