// SPDX-License-Identifier: BSD-3-Clause
// A controlled history as a table: every measure of deformation and stress, invariants, energy, the state by its names.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "drivers/path/path_scene.hpp"
#include "harness/control/controlled_history.hpp"

namespace assay::drivers {

/// ln U of an F = R U.
Tensor log_of_stretch(const Tensor& F);

struct PathTable {
  std::vector<std::string> names, units, si_units;
  std::vector<std::vector<double>> columns;  ///< one a name, all of one length

  std::size_t rows() const { return columns.empty() ? 0 : columns[0].size(); }
  /// Null where there is none of that name.
  const std::vector<double>* column(const std::string& name) const;
  /// Whether a column of that name is there, with a value other than that of its first row.
  bool moves(const std::string& name) const;
};

/// Of rows whose stress is that of Cauchy: t; F11 ... F33; e11 ... e23 (ln U); s11 ... s23 (Cauchy); tau11 ... tau23
/// (Kirchhoff); P11 ... P33; J; pressure; mises, of the Cauchy stress; work, energy and dissipation per reference
/// volume, the last two of a model that offers its energy; acoustic; residual; error; the components of the state.
PathTable path_table(const Material& material, const std::vector<ControlledRow>& rows);
/// The same of a history under that control.
PathTable path_table(const Material& material, const ControlledHistory& history, const Control& control);

/// In the units of an author. Columns whose unit is no SI unit stay as they are: the state of a foreign model.
PathTable in_units(PathTable si, const Units& units);

/// One line of names; units stand in a remark before it.
std::string path_csv(const PathTable& table);
std::string path_npz(const PathTable& table);

/// One history with what names it.
struct NamedTable {
  std::string label;
  PathTable table;
};

/// Largest difference of a component of the Cauchy stress at the times that both have, over the largest stress of
/// `one`.
double largest_difference(const PathTable& one, const PathTable& other);

/// Pictures by the names of their files. compare: drawn with them; null: none.
std::map<std::string, std::string> path_pictures(const PathScene& scene, const std::vector<NamedTable>& tables);

/// Root mean square of the difference to the measured values, over their largest; none where the path does not come to
/// them. fault: why, or that some of them lie beyond it.
std::optional<double> misfit(const PathComparison& compare, const PathTable& table, std::string& fault);

}  // namespace assay::drivers
