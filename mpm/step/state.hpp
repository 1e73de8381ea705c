// SPDX-License-Identifier: BSD-3-Clause
// Everything that a running simulation owns; passes work on it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/material/failed_step.hpp"
#include "mpm/grid/images.hpp"
#include "mpm/grid/live_nodes.hpp"
#include "mpm/kernels/kernels.hpp"
#include "mpm/setup/setup.hpp"
#include "mpm/step/surface_loads.hpp"

namespace assay::mpm {

/// Why a run must stop: a result, not an error.
struct Finding {
  enum class Kind { unstable, material_failed };
  Kind kind = Kind::unstable;
  std::string reason;                   ///< one sentence
  std::int64_t particle = 0;            ///< permanent id
  std::optional<FailedStep> step = {};  ///< of a material that failed
};

/// Momentum and energy since t = 0. What the particles have is compared with what was given to them.
struct Ledger {
  std::array<double, 3> impulse{};  ///< of body force and holding reactions [N s]
  double angular_impulse = 0;       ///< of the body force, about E_z [N m s]
  double external_work = 0;         ///< of the body force [J]
  double internal_work = 0;         ///< of the stress [J]
  /// Of the grid's momentum about E_z, affine parts of the particles included, before a step's forces: the first, its
  /// largest difference to that and the impulse given since, and the largest sum of |x m v| [N m s].
  std::optional<double> grid_angular;
  double grid_angular_defect = 0, grid_angular_scale = 0;
  double angular_impulse_before = 0;  ///< this step [N m s]
  double mass_defect = 0;             ///< largest |grid mass - particle mass| / particle mass
};

/// Where a thread adds up what its tile gives to the grid; zero between tiles.
template <int Dim>
struct TileCopy {
  GridField<Dim + 1> inertia;
  GridField<Dim> force;
};

/// Of all nodes before images were folded.
struct UnfoldedSums {
  std::vector<double> image_mass;             ///< of each image [kg]
  std::array<double, 3> momentum{}, force{};  ///< [N s], [N]
};

/// Nodes without mass where particles lie on lines between cells, and those with mass that they go with.
struct MasslessNodes {
  struct Share {
    std::size_t node = 0;
    double of_mass = 0;  ///< of all those of one node
  };
  struct Node {
    std::size_t node = 0, end = 0;  ///< of its shares, which begin where those of the node before end
  };
  std::vector<Node> nodes;
  std::vector<Share> shares;

  void clear() {
    nodes.clear();
    shares.clear();
  }

  /// body(node, shares)
  template <class Body>
  void each(const Body& body) const {
    std::size_t begin = 0;
    for (const Node& one : nodes) {
      body(one.node, std::span(shares).subspan(begin, one.end - begin));
      begin = one.end;
    }
  }
};

template <int Dim>
struct State : KernelState<Dim> {
  explicit State(Setup<Dim> s) : KernelState<Dim>{s.method, s.seeds.size()}, setup(std::move(s)) {}

  Setup<Dim> setup;
  LiveNodes<Dim> live{setup.grid};  ///< in which all nodal fields are kept up to date
  Kernels<Dim> kernels = kernels_of<Dim>(setup.method.basis, setup.instructions);
  std::vector<GridField<Dim>> solver;  ///< of a mass matrix that is not lumped
  std::vector<double> inverse_mass;    ///< of a mass matrix that is not lumped: 1 / row sum of a node that moves, or 0
  std::vector<double> held_mass;       ///< of particles that never move, a node; empty where nothing is held
  std::vector<std::uint32_t> held_nodes;
  Images<Dim> images;                   ///< of symmetry planes and periodic ends; empty without
  UnfoldedSums unfolded;                ///< for the accounts of these
  MasslessNodes massless;               ///< of this step
  std::shared_ptr<SurfaceLoads> loads;  ///< of tractions; null without
  std::array<ColumnData, 2> history;    ///< material state by block, [c * n + p]: begin and end of the step
  std::vector<TileCopy<Dim>> tile_copies;
  std::optional<Finding> finding;
  Ledger ledger;
  std::int64_t material_calls = 0;  ///< points updated
};

}  // namespace assay::mpm
