// SPDX-License-Identifier: BSD-3-Clause
// Columns of particles as VTU files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/output/vtu.hpp"
#include "drivers/simulation/space_domains.hpp"
#include "drivers/system/whole_file.hpp"

namespace assay::drivers {

/// A column that snapshots show. It holds a number, a vector or a tensor of each particle.
struct ShownColumn {
  mpm::Column column;
  int components;
  int width() const { return components == 1 ? 1 : components <= 3 ? 3 : 9; }  ///< in three dimensions
};

/// Particles in the plane as points. shown: first the positions, in the reference configuration and now. more: arrays
/// behind the columns. velocity_t: of the velocities, where it is another time [s].
std::string particles_vtu(const std::vector<ShownColumn>& shown, const ColumnView& of, std::size_t particles,
                          const std::vector<VtuArray>& more, double t, const std::optional<double>& velocity_t = {});

/// Particles in space as their domains, written a part at a time. more: arrays of one component.
void put_particles(const PutBytes& put, const std::vector<ShownColumn>& shown, const ColumnView& of,
                   const SpaceDomains::Now& domains, std::size_t particles, const std::vector<VtuArray>& more, double t,
                   const std::optional<double>& velocity_t = {});

}  // namespace assay::drivers
