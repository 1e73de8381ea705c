// SPDX-License-Identifier: BSD-3-Clause
// A scene as plain values: what a YAML file under configs/ says after reading, with defaults filled.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "drivers/scene/material_path.hpp"
#include "drivers/system/input_error.hpp"
#include "harness/motion/frame.hpp"
#include "harness/motion/motion.hpp"
#include "mpm/setup/method.hpp"

namespace assay::drivers {

struct MaterialChoice {
  std::string adapter;  ///< registered name, shared library (`lib.so` or `lib.so:name`), description
  std::map<std::string, double> parameters;  ///< as given; defaults are filled by the material
  double density = 0;                        ///< rho0 [kg/m^3]
  /// Of a model that has one: components along e_R, e_Theta, e_Z of the vortex, along the axes of any other motion.
  std::optional<std::array<double, 3>> direction;
  Isolation isolation = Isolation::automatic;
  Location where;                                       ///< of `material.adapter`
  std::map<std::string, Location> parameter_where;      ///< of the values
  std::map<std::string, Location> parameter_key_where;  ///< of their names
  /// As whoever made the choice calls them in messages.
  std::string adapter_key = "material.adapter", parameters_key = "material.parameters";
  std::string parameters_option = {};  ///< of the command line, which gives them without a place
};

/// Of a body that is left to itself: v = velocity + L X, L of a spin and a stretching.
struct InitialVelocity {
  std::array<double, 2> velocity{};    ///< of the origin [m/s]
  double spin = 0;                     ///< about E_z through the origin [rad/s]
  std::array<double, 3> stretching{};  ///< D11, D22, D12 [1/s]
};

struct Body {
  enum class Domain { ring, square, box };
  enum class Outside { held, free };
  Domain domain = Domain::ring;
  Outside outside = Outside::held;  ///< of the ring, on square and box: prescribed to stand still, or left to itself
  std::array<double, 2> lower{-1.5, -1.5}, upper{1.5, 1.5};  ///< corners of square and box [m]
  std::array<int, 2> per_cell{2, 2};                         ///< particles a cell in each direction
  enum class Lattice { cartesian, polar, gauss, jittered };
  enum class Cut { clipped, whole };
  Lattice lattice = Lattice::cartesian;
  Cut cut = Cut::clipped;  ///< of lattice cells at the ring's edges, on a ring with a Cartesian or jittered lattice
  double jitter = 0.25;    ///< of a jittered lattice: longest way along an axis [distance between particles]
  int seed = 1;            ///< of its pseudo-random numbers
  enum class Periodic { none, x, y, both };
  Periodic periodic = Periodic::none;  ///< directions in which square and box repeat
  bool is_periodic(std::size_t d) const {
    return periodic == Periodic::both || periodic == (d == 0 ? Periodic::x : Periodic::y);
  }
  std::optional<InitialVelocity> initial_velocity;  ///< absent: that of the motion
};

constexpr std::array<const char*, 3> names_of(Body::Domain) { return {"ring", "square", "box"}; }
constexpr std::array<const char*, 2> names_of(Body::Outside) { return {"held", "free"}; }
constexpr std::array<const char*, 4> names_of(Body::Lattice) { return {"cartesian", "polar", "gauss", "jittered"}; }
constexpr std::array<const char*, 2> names_of(Body::Cut) { return {"clipped", "whole"}; }
constexpr std::array<const char*, 4> names_of(Body::Periodic) { return {"none", "x", "y", "both"}; }

struct GridChoice {
  double spacing = 0;                                 ///< h [m]; nodes lie at multiples of h
  std::array<double, 2> offset{};                     ///< and this far beyond them [h]
  std::optional<std::array<double, 2>> lower, upper;  ///< corners; by default around the body with a margin
};

struct Method : mpm::Method {
  using Basis = mpm::Basis;
  using Transfer = mpm::Transfer;
  using Update = mpm::Update;
  double courant = 0.4;  ///< of the fastest wave on the baseline path plus the fastest particle
};

struct ForceChoice {
  enum class Response { none, closed_form, sheet, shadow };
  Response response = Response::sheet;  ///< none: no body force at all
  using Evaluation = mpm::Evaluation;
  Evaluation evaluation = Evaluation::domain_average;
  mpm::Inertia inertia = mpm::Inertia::grid;
  int radii = 400;          ///< of response shadow
  bool cache = true;        ///< a sheet is kept on disk and taken from there
  double tolerance = 1e-8;  ///< requested relative error of the sheet
};

constexpr std::array<const char*, 4> names_of(ForceChoice::Response) {
  return {"none", "closed_form", "sheet", "shadow"};
}

struct TractionChoice {
  mpm::TractionAlgorithm algorithm = mpm::TractionAlgorithm::edges;
  std::optional<mpm::TractionForm> form;  ///< absent: the stable one of the motion
};

struct TimeChoice {
  double end = 1;  ///< [s]
  enum class Control { planned, current };
  Control control = Control::planned;  ///< equal steps by the exact motion; or as the particles are now
  std::optional<double> step;          ///< fixes dt [s] instead of courant
};

constexpr std::array<const char*, 2> names_of(TimeChoice::Control) { return {"planned", "current"}; }

struct OutputChoice {
  int errors = 100;                           ///< samples of the error over the run
  int particles = 10;                         ///< snapshots (VTU) over the run; 0: none
  std::optional<double> each_step_from = {};  ///< snapshots of every step from this time on, besides [s]
  bool pictures = true;                       ///< PNG pictures
  bool report = true;                         ///< report.html
  bool writes_particles() const { return particles > 0 || each_step_from; }
  bool accounts = true;    ///< momentum, mass and energy accounts
  bool tractions = false;  ///< the algorithms of tractions side by side
};

struct Limits {
  double memory_gib = 16;        ///< a run that would need more is refused
  double particle_steps = 1e12;  ///< likewise
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
  std::string file;    ///< as given on the command line
  std::string sha256;  ///< of the file's bytes
  Motion motion;
  std::optional<Frame> frame;  ///< from which the motion is seen; absent: the body's own
  bool allow_unstable = false;
  MaterialChoice material;
  Body body;
  std::optional<GridChoice> grid;
  std::optional<Method> method;
  ForceChoice force;
  TractionChoice traction;
  TimeChoice time;
  mpm::Remedies remedies;
  OutputChoice output;
  Limits limits;
  std::vector<Expectation> expect;

  std::map<std::string, Location> places;  ///< where the keys that were given stand, by dotted path
  /// Where a key stands; not given: its section, else the file.
  Location place(const std::string& key) const;
};

/// Throws InputError at a key of the scene.
[[noreturn]] inline void refuse(const Scene& scene, const std::string& key, const std::string& why,
                                const std::string& known = {}) {
  throw InputError(scene.place(key), key, why, known);
}

/// The baseline of the scene's motion with the material's direction, a unit vector, in its frame: E1 = e_R.
Path baseline_path(const Scene& scene);

/// All paths that points of the body take: of the axis-aligned motion one for each of some Y, of others the baseline.
std::vector<Path> baseline_paths(const Scene& scene);

/// L = D + W: L11, L12, L21, L22 [1/s].
inline std::array<double, 4> gradient_of(const InitialVelocity& v) {
  return {v.stretching[0], v.stretching[2] - v.spin, v.stretching[2] + v.spin, v.stretching[1]};
}

/// v = velocity + L X [m/s].
inline std::array<double, 2> velocity_at(const InitialVelocity& v, double X, double Y) {
  const std::array<double, 4> L = gradient_of(v);
  return {v.velocity[0] + L[0] * X + L[1] * Y, v.velocity[1] + L[2] * X + L[3] * Y};
}

}  // namespace assay::drivers
