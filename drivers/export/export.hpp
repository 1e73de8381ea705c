// SPDX-License-Identifier: BSD-3-Clause
// All that another code needs to run a scene and to have it judged. A target is a file of drivers/export/targets:
// targets/csv.cpp defines `Target target_csv()`, and is listed nowhere else.
//
//   options --export_problem()--> ExportedProblem --Target::write()--> Deck --folder_of()--> files by their paths
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/findings/run_options.hpp"
#include "drivers/scene/scene.hpp"
#include "harness/exact/exact_fields.hpp"
#include "harness/exact/nodal_loads.hpp"
#include "harness/material/material.hpp"

namespace assay::drivers {

struct ExportOptions : SceneOptions {
  std::string target;
  std::string grids = {};     ///< "0.1,0.05" [m]; empty: three of its own
  bool quasi_static = false;  ///< b without inertia
};

/// Where a target's particles are.
enum class SeedPlace {
  cell_centres,
  nodes,
  two_by_two,   ///< at the quarter points of each cell: 4 in the plane, 8 in space
  body_centred  ///< in space at the centres and at the nodes, in the plane at the centres
};

/// One grid of a ladder: equal cells that fill the body, and a particle in each, or one at each node. In the plane
/// volumes are per metre of thickness.
struct ExportedGrid {
  double h = 0;                            ///< edge of a cell [m]
  std::string folder;                      ///< "h_0.1"
  std::array<int, 3> cells{1, 1, 1};       ///< along each axis; in the plane one along Z
  std::array<double, 3> lower{}, upper{};  ///< corners of the body; in the plane Z = 0 [m]
  /// A ring in place of a box: cells along R and around, whose edges are straight in a mesh.
  std::optional<Annulus> ring = {};
  std::vector<std::int64_t> id;      ///< 1, 2, ...: X goes fastest, Z slowest; of a ring R
  std::vector<Vector3> X, v0;        ///< reference positions [m], velocities at t = 0 [m/s]
  std::vector<double> volume, mass;  ///< [m^3], [kg]; in the plane [m^2], [kg/m]
  std::size_t size() const { return X.size(); }
};

/// Quadrilaterals or hexahedra of a grid whose seeds are nodes.
ElementMesh mesh_of(const ExportedGrid& grid, int dimension);

/// Whether a node lies on the surface of the body.
bool is_on_surface(const ExportedGrid& grid, int dimension, const Vector3& X);

/// A face of a cell on the surface of the body.
struct SurfaceFace {
  std::size_t seed = 0;                                   ///< in the cell
  Vector3 X = Vector3::Zero(), normal = Vector3::Zero();  ///< middle [m], outward
  double area = 0;                                        ///< [m^2]; in the plane [m]
};

/// Of a grid whose seeds are in the cells.
std::vector<SurfaceFace> surface_faces(const ExportedGrid& grid, int dimension);

struct ExportedProblem {
  Scene scene;               ///< with the parameters of the material filled in
  std::string scene_yaml;    ///< scene.yaml of the folder
  std::string scene_sha256;  ///< of it
  std::shared_ptr<const Material> material;
  ExactSolutionPtr exact;  ///< until `end`
  int dimension = 2;
  double density = 0, period = 0, end = 0;  ///< rho0 [kg/m^3], T [s], last time [s]
  double wave_speed = 0;                    ///< fastest on the way of the exact motion [m/s]
  bool quasi_static = false;                ///< b is without inertia
  bool bears_tractions = false;             ///< on the surface of the body
  bool rests_at_edge = false;               ///< the surface of the body stands still
  std::vector<ExportedGrid> grids;          ///< the coarsest first
  std::vector<std::string> remarks;         ///< sentences for README.md and the terminal
};

/// What a target leaves. Paths are relative to the folder: "h_0.1/force.bin".
struct Deck {
  std::map<std::string, std::string> files;
  std::string map;                ///< lines of judge.map.yaml: names, units, times
  std::string readme;             ///< sections of README.md: the files, and how to run them
  std::vector<std::string> runs;  ///< what judge reads, the coarsest grid first: "h_0.1/out.npz"
};

struct Target {
  const char* name;  ///< of --to
  const char* doc;   ///< one line
  SeedPlace seeds;
  /// Why this problem cannot be exported so, as a sentence; empty: it can. Null: every problem can.
  std::string (*refusal)(const ExportedProblem& problem);
  Deck (*write)(const ExportedProblem& problem);
};

/// In the order of their names.
const std::vector<Target>& targets();

/// Throws InputError with the nearest name.
const Target& target_of(const std::string& name);

/// Reads and prepares the scene: exact solution, grids and seeds. A target that refuses it is an InputError. Throws
/// MaterialFailure.
ExportedProblem export_problem(const ExportOptions& options, const Target& target);

/// Everything that goes into the folder: the deck, scene.yaml, seeds.csv of each grid, judge.map.yaml and README.md.
std::map<std::string, std::string> folder_of(const ExportedProblem& problem, const Target& target);

/// The text of drivers/templates/export/FOLDER/FILE, in which @WORD@ is replaced by words["WORD"].
std::string filled_template(const std::string& folder, const std::string& file,
                            const std::map<std::string, std::string>& words = {});

/// A reason that several targets share: the surface of the body bears tractions; empty where it does not.
std::string refusal_of_loaded_surface(const ExportedProblem& problem);

}  // namespace assay::drivers
