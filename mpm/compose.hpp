// SPDX-License-Identifier: BSD-3-Clause
// From what a scene calls for to the list of passes of a step. An absent effect is an absent pass.
#pragma once

#include <optional>

#include "mpm/step/effect.hpp"

namespace assay::mpm {

/// The optional effects of a step: the records of mpm/effects, by place.
template <int Dim>
const std::vector<EffectRecord<Dim>>& effects();

/// Why the method has no place for one of the effects that the options call for, and its key.
template <int Dim>
std::optional<Contradiction> contradiction(const Method& method, const EffectOptions& options);

/// What a column is, and of which effect.
template <int Dim>
const ColumnRecord<Dim>& record_of(Column column);
inline const ColumnRecord<2>& info(Column column) { return record_of<2>(column); }

/// Bytes a particle of a column in this setup.
template <int Dim>
std::size_t bytes_of(Column column, const Setup<Dim>& setup) {
  return record_of<Dim>(column).bytes(setup);
}

/// The passes of one step, in order: those of the spine and of each effect that is called for, by their slots. Nothing
/// is allocated and nothing is run.
template <int Dim>
std::vector<Pass<Dim>> compose(const Setup<Dim>& setup);

/// One column that the passes call for.
struct ColumnUse {
  Column column;
  std::size_t bytes = 0;              ///< a particle
  std::vector<std::string> passes;    ///< that read or write it
  std::optional<std::string> effect;  ///< without which it is not there; none: of the spine
};

/// The columns of a step: those that some pass reads or writes, and the position in the reference configuration that
/// errors and snapshots are told from.
template <int Dim>
std::vector<ColumnUse> columns_of(const std::vector<Pass<Dim>>& passes, const Setup<Dim>& setup);

/// What is allocated for every node.
template <int Dim>
std::vector<GridFieldUse> grid_fields_of(const Setup<Dim>& setup);

/// Bytes a node of all grid fields.
template <int Dim>
std::size_t grid_bytes_per_node(const Setup<Dim>& setup);

}  // namespace assay::mpm
