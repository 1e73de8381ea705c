// SPDX-License-Identifier: BSD-3-Clause
// A scene as plain values: what a YAML file under configs/ says after reading, with defaults filled.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "drivers/scene/body.hpp"
#include "drivers/scene/material_path.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/units.hpp"
#include "harness/motion/frame.hpp"
#include "harness/motion/motion.hpp"
#include "mpm/setup/effect_options.hpp"
#include "mpm/setup/method.hpp"

namespace assay::drivers {

struct MaterialChoice {
  std::string adapter;
  std::map<std::string, double> parameters;  ///< as given; defaults are filled by the material
  Units units;         ///< of the parameters; of a foreign model they are those of its description
  double density = 0;  ///< 0: not given
  std::optional<std::array<double, 3>> direction;
  std::optional<std::array<double, 6>> initial_stress;
  Isolation isolation = Isolation::automatic;

  void keys(auto& key) {
    static constexpr const char* places[] = {"worker", "none"};
    key("adapter", "registered name, shared library (lib.so or lib.so:name), Fortran source or description (.yaml)",
        adapter, {.required = true});
    key("density", "density rho0 in the reference configuration", density,
        {.unit = "kg/m^3",
         .range = positive,
         .derived = "of the material's description; required where it has none",
         .shown = density > 0});
    key("direction",
        "axis of the model, any length; components on e_R, e_Theta, e_Z in the vortex, N, e_Theta, "
        "M in vortex3d, else on the coordinate axes",
        direction, {.derived = "[1, 0, 0] of a model that has one"});
    key("initial_stress", "Cauchy stress at rest, the same everywhere: 11, 22, 33, 12, 13, 23 on the axes of direction",
        initial_stress, {.unit = "Pa", .derived = "none"});
    key("isolation", "where the model's code runs: in worker processes (worker) or in the process of assay (none)",
        isolation,
        {.choices = places,
         .derived = "worker for UMAT, VUMAT and MFront, none for native models",
         .shown = isolation != Isolation::automatic});
  }

  Location where;                                       ///< of `material.adapter`
  std::map<std::string, Location> parameter_where;      ///< of the values
  std::map<std::string, Location> parameter_key_where;  ///< of their names
  /// As whoever made the choice calls them in messages.
  std::string adapter_key = "material.adapter", parameters_key = "material.parameters";
  std::vector<std::string> varying = {};  ///< fields of a foreign model that a path changes
  std::string hypothesis = {};            ///< of a behaviour of MFront; empty: as its description says
  bool needs_density = true;              ///< a point without motion needs none
  std::string parameters_option = {};     ///< of the command line, which gives them without a place
};

struct GridChoice {
  double spacing = 0;  ///< h
  PerAxis<double> offset;
  std::optional<PerAxis<double>> lower, upper;

  void keys(auto& key) {
    key("spacing", "node spacing h; nodes are at multiples of h", spacing,
        {.unit = "m", .range = positive, .required = true});
    key("offset", "shift of the nodes from multiples of h; the body is not shifted [h]", offset,
        {.range = {.lower = 0, .upper = 1}, .derived = "[0, 0]"});
    key("lower", "lower corner of the grid", lower, {.unit = "m", .derived = "around the body with a margin"});
    key("upper", "upper corner of the grid", upper, {.unit = "m", .derived = "around the body with a margin"});
  }
};

struct Method : mpm::Method {
  double courant = 0.4;

  void keys(auto& key) {
    mpm::Method::keys(key);
    key("courant", "Courant number of the fastest wave on the baseline path plus the fastest particle", courant,
        {.range = {.lower = 0, .upper = 1, .lower_open = true}});
  }
};

struct ForceChoice {
  enum class Response { none, closed_form, sheet, shadow };
  friend constexpr std::array<const char*, 4> names_of(Response) { return {"none", "closed_form", "sheet", "shadow"}; }
  using Evaluation = mpm::Evaluation;
  Response response = Response::sheet;
  Evaluation evaluation = Evaluation::domain_average;
  mpm::Inertia inertia = mpm::Inertia::grid;
  bool quasi_static = false;
  int radii = 400;
  bool cache = true;
  double tolerance = 1e-8;
  static constexpr double coarsest_tolerance = 1e-2;

  void keys(auto& key) {
    key("response", "source of the stress tau on the baseline path; none: no body force", response);
    key("evaluation", "body force at the particle's reference position, or averaged over its reference domain",
        evaluation, {.derived = "domain_average; in space point where b is smooth: profile_power 4 or more"});
    key("inertia", "grid: all of b acts through the grid; particles: they receive its part a (uses the exact solution)",
        inertia);
    key("quasi_static", "b without the acceleration, as eval gives it to codes without inertia; no run is that",
        quasi_static);
    key("radii", "number of histories that response: shadow steps during the run", radii,
        {.range = {.lower = 4, .upper = 1e6, .whole = true}});
    key("cache", "keep the sheet on disk and reuse it in later runs", cache);
    key("tolerance", "requested relative error of the sheet", tolerance,
        {.range = {.lower = 1e-14, .upper = coarsest_tolerance},
         .derived = "1e-8; 1e-5 for a UMAT, VUMAT or MFront model"});
  }
};

struct TractionChoice {
  mpm::TractionAlgorithm algorithm = mpm::TractionAlgorithm::edges;
  std::optional<mpm::TractionForm> form;

  void keys(auto& key) {
    key("algorithm",
        "forces on domain edges, from the exact stress, at surface particles, or on edges of undeformed length",
        algorithm, {.motions = loaded_motions});
    key("form", "sigma n ds on the current surface (follower), or P N dA0 (reference)", form,
        {.derived = "the stable one: reference where the body is stretched, follower where it is compressed",
         .motions = loaded_motions});
  }
};

struct TimeChoice {
  enum class Control { planned, current };
  friend constexpr std::array<const char*, 2> names_of(Control) { return {"planned", "current"}; }
  double end = 1;
  std::optional<double> step;
  Control control = Control::planned;

  void keys(auto& key) {
    key("end", "end of the run", end, {.unit = "s", .range = positive, .derived = "motion.period"});
    key("step", "fixed time step dt, in place of method.courant", step,
        {.unit = "s", .range = positive, .derived = "of method.courant"});
    key("control",
        "planned: equal steps from the exact motion; current: steps from the present fastest wave and particle",
        control);
  }
  /// The key that fixes equal steps in place of method.courant, their length dt [s], how a message begins with both,
  /// and what makes them shorter.
  struct FixedStep {
    double dt;
    const char *key, *says, *shorter;
  };
  std::optional<FixedStep> fixed_step() const {
    if (!step) return std::nullopt;
    return FixedStep{*step, "time.step", "time.step = ", "a shorter time.step"};
  }
};

struct OutputChoice {
  int errors = 100, particles = 10;
  std::optional<double> each_step_from = {};
  bool pictures = true, report = true, accounts = true, tractions = false;

  void keys(auto& key) {
    key("errors", "number of samples of the error over the run", errors,
        {.range = {.lower = 1, .upper = 1e6, .whole = true}});
    key("particles", "number of snapshots of the particles (VTU) over the run; 0: none", particles,
        {.range = {.lower = 0, .upper = 1e5, .whole = true}});
    key("each_step_from", "also write a snapshot of every step from this time on", each_step_from,
        {.unit = "s", .range = {.lower = 0}, .derived = "none"});
    key("pictures", "write PNG pictures", pictures);
    key("report", "write report.html", report);
    key("accounts", "compute the accounts of mass, momentum and energy", accounts);
    key("tractions",
        "repeat the run with each traction algorithm on grids of 4h, 2h and h, for report.html and result.json",
        tractions, {.motions = loaded_motions});
  }
  bool writes_particles() const { return particles > 0 || each_step_from; }
  bool shows_particles() const { return writes_particles() || pictures; }
};

struct Limits {
  double memory_gib = 16;
  double particle_steps = 1e12;

  void keys(auto& key) {
    key("memory_gib", "refuse a run that would need more memory [GiB]", memory_gib, {.range = positive});
    key("particle_steps", "refuse a run of more particles times steps", particle_steps, {.range = positive});
  }
};

/// One line of `expect:`. Operators: below, above, between, equals.
struct Expectation {
  enum class Operator { below, above, between, equals };
  friend constexpr std::array<const char*, 4> names_of(Operator) { return {"below", "above", "between", "equals"}; }
  std::string key;  ///< key of result.json, dotted: "outcome", "error.l2_max"
  Operator op = Operator::equals;
  double number = 0, upper = 0;     ///< the bound; for between lower and upper
  std::optional<std::string> text;  ///< for equals on a string
  std::optional<bool> truth;        ///< for equals on a boolean
  Location where;
};

struct Scene {
  std::string title;
  int dimension = 2;   ///< 3: points, vectors and tensors have all components
  std::string file;    ///< as given on the command line
  std::string sha256;  ///< of the file's bytes
  Units units;         ///< in which the file is written; the values here are in SI
  Motion motion;
  std::optional<Frame> frame;   ///< from which the motion is seen; absent: the body's own
  std::string path_time = "s";  ///< unit of the column t of motion.path, unless its header says one
  bool allow_unstable = false;
  MaterialChoice material;
  Body body;
  std::optional<GridChoice> grid;
  std::optional<Method> method;
  ForceChoice force;
  TractionChoice traction;
  TimeChoice time;
  mpm::EffectOptions effects;
  OutputChoice output;
  Limits limits;
  std::vector<Expectation> expect;

  /// At rest, on the axes of the baseline; zero where none is given [Pa].
  Tensor initial_cauchy() const;
  /// On the surface of the body.
  bool bears_tractions() const;

  void keys(auto& key) {
    key("title", "one-line title for pictures and reports", title);
    key("dimension", "2 in the plane (plane strain), 3 in space, where points, vectors and tensors have all components",
        dimension,
        {.range = {.lower = 2, .upper = 3, .whole = true},
         .derived = "2; 3 for a motion that is in space only",
         .shown = dimension == 3});
    key("motion.allow_unstable",
        "run a motion that is not a stable solution for the model; otherwise the run is refused", allow_unstable);
  }

  std::map<std::string, Location> places;  ///< where the keys that were given stand, by dotted path
  /// Where a key stands; not given: its section, else the file. Of an item in a list "motion.vortices[1].radius".
  Location place(const std::string& key) const;
};

/// Throws InputError at a key of the scene.
[[noreturn]] inline void refuse(const Scene& scene, const std::string& key, const std::string& why,
                                const std::string& known = {}) {
  throw InputError(scene.place(key), key, why, known);
}

/// The baseline of the scene's motion with the material's direction, a unit vector, in its frame: E1 = e_R.
Path baseline_path(const Scene& scene);

/// Why the motion is no exact solution under material.initial_stress, or the body cannot be held under it; empty: it
/// is.
std::string fault_of_initial_stress(const Scene& scene);

/// All paths that points of the body take: of the axis-aligned motion one for each of some Y and Z, of others the
/// baseline.
std::vector<Path> baseline_paths(const Scene& scene);

}  // namespace assay::drivers
