// SPDX-License-Identifier: BSD-3-Clause
// What a path has found: the content of its result.json.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "adapters/foreign/foreign_model.hpp"
#include "drivers/path/path_scene.hpp"
#include "drivers/path/path_table.hpp"
#include "drivers/result/result.hpp"

namespace assay::drivers {

/// Of increments of a model.
struct IncrementFindings {
  int increments = 0;
  std::string outcome;
  double error = 0, stress = 0, deformation = 0, call_ns = 0;
  std::int64_t material_calls = 0;
  Figure order;

  static void fields(auto& self, auto& archive) {
    archive("increments", self.increments, "1", "increments between two knots");
    archive("outcome", self.outcome, "", "as of a path");
    archive("error", self.error, "1", "the larger of the two errors that follow");
    archive("stress", self.stress, "1", "largest error of the stress at a knot, relative to the largest stress");
    archive("deformation", self.deformation, "1", "largest error of the deformation at a knot, relative to its change");
    archive("order", self.order, "1",
            "of the error, from the number of increments before; none where both are rounding");
    archive("material_calls", self.material_calls, "1", "points updated");
    archive("call_ns", self.call_ns, "ns", "time of a call, with the solver's share");
  }
};

/// Of one increment over the plane of two strains.
struct IsoErrorFindings {
  Figure largest, mean, order;

  static void fields(auto& self, auto& archive) {
    archive("largest", self.largest, "1", "largest relative error of the stress by one increment");
    archive("mean", self.mean, "1", "mean of it");
    archive("order", self.order, "1", "of the mean, from two increments to four");
  }
};

/// Of one material along the path.
struct PathFindings {
  std::string label, material;
  std::string outcome = "completed", reason;
  double t = 0, error = 0, residual = 0;
  std::int64_t steps = 0, material_calls = 0;
  Figure loses_ellipticity, misfit, difference;
  std::optional<std::array<double, 3>> normal;
  std::vector<double> branches;
  std::vector<std::string> warnings;
  std::map<std::string, double> last, largest;
  std::vector<IncrementFindings> increments;
  std::optional<IsoErrorFindings> iso_error;

  static void fields(auto& self, auto& archive) {
    archive("label", self.label, "", "of a variant; empty for the scene's own material");
    archive("material", self.material, "", "name of the model");
    archive("outcome", self.outcome, "",
            "completed; stopped, at a stop of the path; limit_load; no_solution; undetermined, if the rows leave a "
            "deformation free; material_failed");
    archive("reason", or_null(self.reason), "", "one sentence if the path did not complete");
    archive("t", self.t, "s", "time reached");
    archive("error", self.error, "1", "estimated error of stress and deformation, relative to their largest");
    archive("residual", self.residual, "1", "largest residual of the rows, in strains");
    archive("steps", self.steps, "1", "steps that were accepted");
    archive("material_calls", self.material_calls, "1", "points updated");
    archive("loses_ellipticity", self.loses_ellipticity, "s", "time at which strong ellipticity is lost");
    archive("normal", self.normal, "", "then: normal of the plane, in the reference configuration");
    archive("branches", self.branches, "s", "times at which another solution begins");
    archive("misfit", self.misfit, "1", "root mean square difference to the measured values over their largest");
    archive("difference", self.difference, "1",
            "of a variant: largest difference of the stress to the scene's own material, over its largest stress");
    archive("increments", self.increments);
    archive.section("iso_error", self.iso_error);
    archive("warnings", self.warnings, "", "what did not stop the path");
    archive("last", self.last, "", "values at the end, by the columns of path.csv");
    archive("largest", self.largest, "", "largest absolute values along the path");
  }
};

struct UnitsOfResult {
  std::string length, stress, time;

  static void fields(auto& self, auto& archive) {
    archive("length", self.length, "", "of lengths");
    archive("stress", self.stress, "", "of stresses");
    archive("time", self.time, "", "of times");
  }
};

struct PathResult {
  std::string title;
  UnitsOfResult units;
  PathFindings own;
  std::vector<PathFindings> variants;
  std::vector<ExpectationOutcome> expect;
  std::string replay;
  double wall_s = 0;
  Provenance provenance;

  static void fields(auto& self, auto& archive) {
    archive("title", self.title, "", "of the scene");
    archive("units", self.units);
    PathFindings::fields(self.own, archive);
    archive("variants", self.variants, "", "the same of each variant");
    archive("replay", or_null(self.replay), "", "replay.yaml, which shows again the step at which the model failed");
    archive("wall_s", self.wall_s, "s", "wall time of all histories");
    archive("expect", self.expect);
    archive("provenance", self.provenance);
  }
};

std::string path_result_json(const PathResult& result);

/// What `expect:` of a path may ask for, by key: numbers.
std::map<std::string, double> path_figures(const PathResult& result);

/// Which of these keys a map of expectations may have: `last.` and `largest.` go on with a column of path.csv, which
/// is known when the material is. Those of a variant begin with `variants.LABEL.`.
std::vector<std::string> path_figure_keys(const Tree& expect, const std::vector<PathVariant>& variants);

/// Lines on what one material has found, and the one of the table's end that a user looks at first: what was
/// prescribed.
std::string findings_text(const PathFindings& found);
std::string end_text(const PathScene& scene, const PathFindings& found);

/// How a path can end.
const std::vector<std::string>& path_outcomes();

/// What the increments of a material err by, as the scene asks; files by their names. Throws InputError.
struct PathAccuracy {
  std::vector<IncrementFindings> increments;
  std::optional<IsoErrorFindings> iso_error;
  std::map<std::string, std::string> files;
};
PathAccuracy path_accuracy(const PathScene& scene, const Material& material, const std::string& label,
                           const std::function<void(double)>& progress);

/// The same path with the rows out of the plane that a model of plane stress has: strains 13 and 23 are zero, and the
/// thickness follows. note: what was put in place. Throws InputError where the path prescribes something there.
PathScene path_of_plane_stress(const PathScene& scene, const adapters::ForeignModel& model, std::string& note);

/// Takes a material along the path. Throws InputError where rows do not fit the material.
struct PathRun {
  PathFindings findings;
  PathTable table;
  std::optional<MaterialFailure> failure;
};
PathRun run_path(const PathScene& scene, const Material& material, const std::function<void(double)>& progress);

}  // namespace assay::drivers
