// SPDX-License-Identifier: BSD-3-Clause
// Columns of particles as VTU files.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drivers/output/vtu.hpp"
#include "mpm/data/columns.hpp"

namespace assay::drivers {

/// A column that snapshots show. It holds a number, a vector or a tensor of each particle.
struct ShownColumn {
  mpm::Column column;
  int components;
  int width() const { return components == 1 ? 1 : components <= 3 ? 3 : 9; }  ///< in three dimensions
};

/// Where component c of a column begins.
using ColumnView = std::function<const double*(mpm::Column, int)>;

/// shown: first the positions, in the reference configuration and now. more: arrays behind the columns. velocity_t: of
/// the velocities, where it is another time [s].
template <int Dim>
std::string particles_vtu(const std::vector<ShownColumn>& shown, const ColumnView& of, std::size_t particles,
                          const std::vector<VtuArray>& more, double t, const std::optional<double>& velocity_t = {});

}  // namespace assay::drivers
