// SPDX-License-Identifier: BSD-3-Clause
// What a run of a problem consists of, and what that costs, without running it: what `assay explain` tells.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "drivers/result/fields.hpp"
#include "drivers/result/result.hpp"
#include "drivers/simulation/problem.hpp"
#include "harness/exact/exact_fields.hpp"
#include "mpm/compose.hpp"

namespace assay::drivers {

/// An optional effect: what it is, the scene key that calls for it, and what it brings into a run. What a scene does
/// not call for is not there: no pass, column, grid field, observer or call of the material.
struct EffectEntry {
  std::string name, doc;
  std::string key;             ///< of the scene; empty: no key calls for it
  std::string around;          ///< what it brings around the steps; empty: nothing
  bool asks_material = false;  ///< it can, in steps, for more than the particles' stress
};
template <int Dim>
struct EffectEntryIn : EffectEntry {
  std::function<bool(const ProblemIn<Dim>&)> called_for;  ///< by this scene
  /// Where another key than `key` can call for it, too: the one that does so here.
  std::function<std::string(const ProblemIn<Dim>&)> called_by = nullptr;

  std::string key_of(const ProblemIn<Dim>& problem) const { return called_by ? called_by(problem) : key; }
};

/// Those of a step, which are the records of mpm/effects, and those of a run, around its steps.
template <int Dim = 2>
std::span<const EffectEntryIn<Dim>> effects();

/// Throws std::out_of_range where there is none.
template <int Dim = 2>
const EffectEntryIn<Dim>& entry_of(const std::string& effect);

/// Work of one step after the first, counted from the composition: what each pass reads and writes of the columns of
/// all particles, what it touches of the grid's fields once a node that is reached, and points that the material
/// updates.
struct StepWork {
  double column_bytes = 0, grid_bytes = 0;
  std::int64_t material_updates = 0;

  static void fields(auto& self, auto& archive) {
    ASSAY_MEMBERS(column_bytes, grid_bytes, material_updates);
    archive("measured", false);
  }
};

/// An effect in this composition.
struct EffectPart {
  std::string effect;
  bool is_there = false;
  std::string key;                                        ///< of the scene, that calls for it; empty: none
  std::vector<std::string> passes, columns, grid_fields;  ///< that it brings; empty where it is not there
  std::size_t bytes_per_particle = 0, bytes_per_node = 0;

  static void fields(auto& self, auto& archive) {
    const EffectEntry& entry = entry_of(self.effect);
    archive("name", self.effect);
    archive("doc", entry.doc);
    archive("key", or_null(self.key));
    archive("there", self.is_there);
    ASSAY_MEMBERS(passes, columns, grid_fields);
    archive("asks_material", self.is_there && entry.asks_material);
    ASSAY_MEMBERS(bytes_per_particle, bytes_per_node);
  }
};

struct Composition {
  std::vector<mpm::PassInfo> passes;
  std::vector<mpm::ColumnUse> columns;
  std::vector<mpm::GridFieldUse> grid_fields;
  std::size_t bytes_per_particle = 0, bytes_per_node = 0;
  std::size_t nodes_reached = 0;  ///< of the tiles that particles reach at first; no other is cleared or worked on
  StepWork work;
  std::vector<EffectPart> effects;  ///< all of them, in the order of the list
};
template <int Dim>
Composition composition_of(const ProblemIn<Dim>& problem);

/// Bytes of columns a particle that a pass reads and writes each time.
template <int Dim>
std::size_t bytes_moved(const mpm::PassInfo& pass, const mpm::Setup<Dim>& setup);

/// What a run does between steps, under the names of its profile.
struct Observer {
  std::string name;
  std::size_t times;
  std::string called_for_by;

  ASSAY_FIELDS(name, times, called_for_by)
};
std::vector<Observer> observers_of(const PosedScene& problem);

/// Names of columns.
std::vector<std::string> names_of(const std::vector<mpm::Column>& columns);

/// Passes, columns, observers, memory, steps, response and stability of a problem, as `assay explain` prints them.
/// Without an exact solution, which is not made where the run is refused, there is no response.
template <int Dim>
std::string explanation(const ProblemIn<Dim>& problem, const ExactSolution* exact, const ScreenFigures& screen);

/// The same as JSON.
template <int Dim>
std::string explanation_json(const ProblemIn<Dim>& problem, const ExactSolution* exact, const ScreenFigures& screen);

}  // namespace assay::drivers
