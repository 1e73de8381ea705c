// SPDX-License-Identifier: BSD-3-Clause
// `assay eval`: the exact fields of a motion at given reference points and times.
#include "drivers/verbs/eval.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "drivers/check/replay.hpp"
#include "drivers/command_line/verb_arguments.hpp"
#include "drivers/findings/findings.hpp"
#include "drivers/format/csv.hpp"
#include "drivers/output/points_csv.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/exact_stress.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/scene_limits.hpp"
#include "drivers/simulation/screening.hpp"
#include "drivers/simulation/warnings.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/system/whole_file.hpp"
#include "harness/numeric/stable_norm.hpp"

namespace assay::drivers {

namespace {

std::vector<std::string> column_names(bool three, bool normals) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& list) {
    for (std::size_t begin = 0; begin < list.size();) {
      const std::size_t end = std::min(list.find(',', begin), list.size());
      names.push_back(list.substr(begin, end - begin));
      begin = end + 1;
    }
  };
  if (three) {
    add("X,Y,Z,t,x,y,z,vx,vy,vz,ax,ay,az");
    for (const char* tensor : {"F", "P"}) {
      for (const char* c : {"11", "12", "13", "21", "22", "23", "31", "32", "33"})
        names.push_back(tensor + std::string(c));
    }
    add("s11,s22,s33,s12,s13,s23,bx,by,bz");
  } else {
    add("X,Y,t,x,y,vx,vy,ax,ay,F11,F12,F21,F22,F33,P11,P12,P21,P22,P33,s11,s12,s22,s33,bx,by");
  }
  if (normals) add(three ? "tx,ty,tz" : "tx,ty");
  return names;
}

std::vector<double> row_of(const ReferencePoint& point, const ExactState& state, const ExactStress& stress, bool three,
                           bool normals) {
  const Tensor &F = state.F, &P = stress.first_piola_kirchhoff, &s = stress.cauchy;
  std::vector<double> row{point.X, point.Y};
  if (three) row.push_back(point.Z);
  row.push_back(point.t);
  for (const Vector3* vector : {&state.x, &state.v, &state.a}) {
    for (int d = 0; d < (three ? 3 : 2); ++d) row.push_back((*vector)(d));
  }
  for (const Tensor* tensor : {&F, &P}) {
    if (three) {
      for (int c = 0; c < 9; ++c) row.push_back(component(*tensor, c));
    } else {
      for (const int c : {0, 1, 3, 4, 8}) row.push_back(component(*tensor, c));
    }
  }
  if (three)
    row.insert(row.end(), {s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(0, 2), s(1, 2)});
  else
    row.insert(row.end(), {s(0, 0), s(0, 1), s(1, 1), s(2, 2)});
  for (int d = 0; d < (three ? 3 : 2); ++d) row.push_back(stress.body_force(d));
  if (normals) {
    const Vector3 N = unit_along({point.NX, point.NY, point.NZ});
    const Vector3 traction = P * N;  // per reference area [Pa]
    for (int d = 0; d < (three ? 3 : 2); ++d) row.push_back(traction(d));
  }
  return row;
}

double last_time(const ReferencePoints& points, double otherwise) {
  double last = 0;
  for (const ReferencePoint& point : points.points) last = std::max(last, point.t);
  return last > 0 ? last : otherwise;
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
  const bool quiet = options.verbosity == Verbosity::quiet;
  std::string library;
  const auto material = material_of(scene, library);
  refuse_input_as_output(options.out, "-o");
  warn_of_instability(scene, *material, end, quiet);
  if (scene.force.response == ForceChoice::Response::none) scene.force.response = ForceChoice::Response::sheet;
  const bool three = scene.motion->is_spatial();
  CsvText csv(column_names(three, points.has_normals));
  const std::vector<ExactPoint> exact = exact_points(scene, material, points.points, end, quiet);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    csv.row(row_of(points.points[i], exact[i].state, exact[i].stress, three, points.has_normals));
  }
  Result process;
  record_process(*material, process);
  for (const std::string& warning : process.warnings) warn(warning);
  return csv.text();
}

/// How the same failure is met by a tabulation.
std::string hint_of(const EvalOptions& options) {
  const Scene scene = read_scene(options.scene, options.sets);
  return replay_hint(scene, options.sets, last_time(read_reference_points(options.points), scene.time.end));
}

Act add_eval_arguments(VerbArguments& verb) {
  const auto given = std::make_shared<EvalOptions>();
  add_scene(verb, given->scene, given->sets);
  add_value(verb, "--points", given->points, "CSV", "reference points, columns X,Y,t")->required();
  add_out(verb, given->out, "CSV", "file for the table (default: standard output)");
  return [given](Verbosity verbosity) {
    given->verbosity = verbosity;
    return eval(*given);
  };
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
    const std::string hint = failure.step ? "; " + hint_of(options) : "";
    std::fprintf(stderr, "%s%s\n", one_line(result.reason).c_str(), one_line(hint).c_str());
    return 1;
  }
}

Verb verb_eval() {
  return {80, "exact motion, stress and body force at given points",
          "assay eval scene.yaml --points X_Y_t.csv -o exact.csv", add_eval_arguments};
}

}  // namespace assay::drivers
