// SPDX-License-Identifier: BSD-3-Clause
// Everything that a running simulation owns; passes work on it.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "harness/failed_step.hpp"
#include "mpm/basis.hpp"
#include "mpm/columns.hpp"
#include "mpm/grid_field.hpp"
#include "mpm/setup.hpp"

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
  double mass_defect = 0;           ///< largest |grid mass - particle mass| / particle mass
};

template <int Dim>
struct State {
  explicit State(Setup<Dim> s) : setup(std::move(s)), particles(setup.seeds.size()) {}

  Setup<Dim> setup;
  std::size_t particles;
  std::array<ColumnData, column_count> columns;
  GridField<Dim + 1> inertia;          ///< mass, momentum
  GridField<Dim> force;                ///< internal and body force [N]
  GridField<2 * Dim> motion;           ///< velocity, acceleration
  std::vector<GridField<Dim>> solver;  ///< of a mass matrix that is not lumped
  std::vector<double> held_mass;       ///< of particles that never move, a node; empty where nothing is held
  std::vector<std::uint32_t> held_nodes;
  std::array<ColumnData, 2> history;  ///< material state by block, [c * n + p]: begin and end of the step
  std::shared_ptr<void> basis;        ///< the weights of all particles; its type is known to the passes
  std::optional<Finding> finding;
  Ledger ledger;
  std::int64_t material_calls = 0;  ///< points updated

  double* column(Column which, int component = 0) {
    return columns[static_cast<std::size_t>(which)].component(component);
  }
  const double* column(Column which, int component = 0) const {
    return columns[static_cast<std::size_t>(which)].component(component);
  }
  bool has(Column which) const { return !columns[static_cast<std::size_t>(which)].empty(); }
};

}  // namespace assay::mpm
