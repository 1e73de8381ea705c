// SPDX-License-Identifier: BSD-3-Clause
// `assay eval`: the exact fields of a motion at given reference points and times.
#include "drivers/verbs/verbs.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "drivers/command_line/verb.hpp"
#include "drivers/findings/findings.hpp"
#include "drivers/format/csv.hpp"
#include "drivers/format/yaml_writer.hpp"
#include "drivers/output/points_csv.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/box_forces.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/simulation/warnings.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/system/whole_file.hpp"
#include "drivers/tabulation/tabulation.hpp"
#include "harness/motion/kinds/deformation_table.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::drivers {

namespace {

/// Each column of a row, by its name and value.
void visit_columns(const ReferencePoint& point, const ExactPoint& exact, const BoxForce* over_box, bool three,
                   bool normals, const std::function<void(const std::string& name, double value)>& column) {
  const auto vector = [&](const std::string& name, const Vector3& of) {
    for (int d = 0; d < (three ? 3 : 2); ++d) column(name + "xyz"[d], of(d));
  };
  const auto tensor = [&](const std::string& name, const Tensor& of, const std::vector<int>& components) {
    for (const int c : components) column(name + index_text(c), component(of, c));
  };
  using Components = std::vector<int>;
  const Components all = three ? Components{0, 1, 2, 3, 4, 5, 6, 7, 8} : Components{0, 1, 3, 4, 8};
  column("X", point.X);
  column("Y", point.Y);
  if (three) column("Z", point.Z);
  column("t", point.t);
  vector("", exact.state.x);
  vector("v", exact.state.v);
  vector("a", exact.state.a);
  tensor("F", exact.state.F, all);
  tensor("P", exact.stress.first_piola_kirchhoff, all);
  tensor("s", exact.stress.cauchy, three ? Components{0, 4, 8, 1, 2, 5} : Components{0, 1, 4, 8});
  vector("b", over_box ? over_box->acts.b : exact.stress.body_force);
  if (over_box) {
    const Vector3& moment = over_box->acts.moment;
    column("V", over_box->volume);
    for (int d = three ? 0 : 2; d < 3; ++d) column(std::string("m") + "xyz"[d], moment(d));
  }
  if (!normals) return;
  const Vector3 N = unit_along({point.NX, point.NY, point.NZ});
  vector("t", exact.stress.first_piola_kirchhoff * N);  // the traction per reference area [Pa]
}

/// How many values of a table are no finite numbers, and so are empty fields of it, and the first of them.
struct EmptyFields {
  std::size_t count = 0, of = 0;
  std::string column;
  int line = 0;  ///< of the points

  void add(const std::string& name, double value, const ReferencePoint& point) {
    ++of;
    if (std::isfinite(value)) return;
    if (count++ == 0) column = name, line = point.line;
  }
  void tell() const {
    if (count == 0) return;
    warn(std::to_string(count) + " of " + std::to_string(of) + " values are not finite and stay empty, first " +
         column + " of line " + std::to_string(line) +
         " of the points: a time, speed or size of the scene is so small or large that its powers are no numbers");
  }
};

double last_time(const ReferencePoints& points, double otherwise) {
  double last = 0;
  for (const ReferencePoint& point : points.points) last = std::max(last, point.t);
  return last > 0 ? last : otherwise;
}

/// A box in the plane has no third edge, and one in space has; so has a normal in space a third component.
void require_columns_in_space(const ReferencePoints& points, const Scene& scene, bool three, const std::string& file) {
  if (scene.dimension == 3 && points.has_normals && !points.has_third_normal)
    throw InputError({file, 1, 1}, "NX", "normals in three dimensions need NZ");
  if (!points.has_boxes || points.has_third_edge == three) return;
  throw InputError({file, 1, 1}, three ? "HX" : "HZ",
                   three ? "boxes in three dimensions need HZ" : "boxes of a plane scene have HX and HY alone");
}

std::string evaluated(const EvalOptions& options) {
  Scene scene = read_scene(options.scene, options.sets);
  require_acceleration(scene);
  const std::string swing = swing_sentence(scene);
  if (!swing.empty()) std::fprintf(stderr, "warning: %s\n", swing.c_str());
  const ReferencePoints points = read_reference_points(options.points);
  require_within_motion(scene, points.points, options.points);
  watch_interrupts();
  const double end = last_time(points, scene.time.end);
  const bool quiet = options.quiet();
  std::string library;
  const auto material = material_of(scene, library);
  refuse_input_as_output(options.out, "-o");
  warn_of_instability(scene, *material, end, quiet);
  if (scene.force.response == ForceChoice::Response::none) scene.force.response = ForceChoice::Response::sheet;
  const bool three = scene.dimension == 3 || scene.motion->is_spatial();
  require_columns_in_space(points, scene, three, options.points);
  if (points.has_boxes) require_boxes(scene.motion, points.points, three, options.points);
  const auto solution = exact_solution_of_points(scene, material, end, quiet);
  std::vector<ExactPoint> exact = exact_points(*solution, points.points, quiet);
  const bool quasi_static = scene.force.quasi_static;
  for (ExactPoint& point : exact) {
    if (quasi_static) point.stress.body_force = point.stress.static_force;
  }
  std::vector<BoxForce> over_boxes;
  if (points.has_boxes) over_boxes = box_forces(*solution, scene.material.density, points.points, three, quasi_static);
  const BoxForce no_box;
  std::vector<std::string> names;
  visit_columns({}, {}, points.has_boxes ? &no_box : nullptr, three, points.has_normals,
                [&](const std::string& name, double) { names.push_back(name); });
  CsvText csv(names);
  EmptyFields empty;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    std::vector<double> row;
    visit_columns(points.points[i], exact[i], points.has_boxes ? &over_boxes[i] : nullptr, three, points.has_normals,
                  [&](const std::string& name, double value) {
                    row.push_back(value);
                    empty.add(name, value, points.points[i]);
                  });
    csv.row(row);
  }
  Result process;
  record_process(*material, process);
  for (const std::string& warning : process.warnings) warn(warning);
  empty.tell();
  return csv.text();
}

/// The command that leaves the step at which the material failed, as this verb writes no folder.
std::string hint_of(const EvalOptions& options) {
  const Scene scene = read_scene(options.scene, options.sets);
  const double end = last_time(read_reference_points(options.points), scene.time.end);
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
  add_value(verb, "--points", given->points, "CSV", "reference points, columns X,Y,t and more")->required();
  add_out(verb, given->out, "CSV", "file for the table (default: standard output)");
  return act_of(given, eval);
}

}  // namespace

int eval(const EvalOptions& options) {
  forget_inputs();
  if (is_same_stream(options.scene, options.points))
    throw InputError({}, "--points", "is the scene's stream, which can be read once");
  try {
    const std::string text = evaluated(options);
    stop_if_interrupted();
    if (options.out.empty() || options.out == standard_stream)
      print(text);
    else
      write_file(options.out, text);
    return 0;
  } catch (const MaterialFailure& failure) {
    Result result;
    record_failure(failure, result);
    const std::string hint = failure.step ? hint_of(options) : "";
    std::fprintf(stderr, "%s%s\n", one_line(result.reason).c_str(), one_line(hint).c_str());
    return 1;
  }
}

Verb verb_eval() {
  return {80, "exact motion, stress and body force at given points",
          "assay eval scene.yaml --points X_Y_t.csv -o exact.csv", add_eval_arguments};
}

}  // namespace assay::drivers
