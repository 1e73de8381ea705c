// SPDX-License-Identifier: BSD-3-Clause
// An optional effect is one record: what it is, when it is called for, and what it brings. What is not called for
// brings nothing. mpm/effects/NAME.cpp defines the record of NAME:
//   template <int Dim>
//   EffectRecord<Dim> NAME_effect();
#pragma once

#include <string_view>

#include "harness/numeric/keys.hpp"
#include "mpm/step/pass.hpp"

namespace assay::mpm {

/// What a column is for besides its passes.
enum ColumnRole : unsigned {
  for_passes = 0,
  of_stress = 1,     ///< the update of the material reads or writes it, wherever that runs
  in_snapshots = 2,  ///< a number, a vector or a tensor of each particle that snapshots show
};

/// A column of particle data.
template <int Dim>
struct ColumnRecord {
  Column column;
  std::string_view name, unit, doc;
  std::size_t (*bytes)(const Setup<Dim>&);  ///< a particle
  unsigned roles = for_passes;              ///< of ColumnRole, or-ed
  std::string effect = {};                  ///< that brings it; empty: the spine
};

/// One field of the grid.
struct GridFieldUse {
  std::string name, doc;
  std::size_t bytes = 0;                  ///< a node
  std::vector<std::string> holds = {};    ///< of what passes say that they touch; empty: its name
  std::vector<std::string> effects = {};  ///< without one of which it is not there; empty: of the spine
  bool is_last = false;                   ///< in lists
};

template <int Dim>
struct EffectRecord {
  int place = 1000;            ///< in lists of all effects
  std::string doc;             ///< one line
  std::string key;             ///< of the scene, that calls for it; empty: none
  std::string name{};          ///< that of its file
  std::string around{};        ///< what else it brings, around the steps; empty: nothing
  bool asks_material = false;  ///< in steps, for more than the particles' stress
  bool (*called_for)(const Setup<Dim>&) = nullptr;
  std::vector<ColumnRecord<Dim>> columns{};  ///< of which there are those that passes read or write
  /// Of the main parts of phases they take the place of the pass that is there: of the spine's, or of an effect's that
  /// stands before in lists.
  std::vector<Pass<Dim>> (*passes)(const Setup<Dim>&) = nullptr;
  std::vector<GridFieldUse> (*grid_fields)(const Setup<Dim>&) = nullptr;  ///< two effects can bring the same
  void (*prepare)(State<Dim>&) = nullptr;                                 ///< once, before passes are bound
  /// Where another key than `key` can call for it, too: the one that does so here.
  std::string (*called_by)(const Setup<Dim>&) = nullptr;

  /// Shows `key` if the key is the effect's own, and then a scene has the key. The options keep its value in a type of
  /// the effect's outside any unnamed namespace: sources for two and for three dimensions must mean the same type.
  void (*keys)(EffectOptions&, Keys&) = nullptr;
  std::string example{};  ///< a value of the key, as YAML, that calls for the effect
  /// Says why the method has no place for the effect; empty if it has.
  std::string (*refusal)(const Method&, const EffectOptions&) = nullptr;
  std::string (*in_title)(const EffectOptions&) = nullptr;  ///< how the line of a run names it: "small masses"
};

/// Bytes of so many numbers.
constexpr std::size_t doubles(int count) { return static_cast<std::size_t>(count) * sizeof(double); }

}  // namespace assay::mpm
