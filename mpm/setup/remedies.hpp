// SPDX-License-Identifier: BSD-3-Clause
// What a scene may call for where a method alone does not hold: each is a pass of its own, and absent by default.
#pragma once

#include <array>

namespace assay::mpm {

/// The stress is that of F scaled to a volume ratio J averaged over cells, or over the functions of nodes (F-bar):
/// nearly incompressible materials then resist changes of a cell's volume, not of each particle's.
enum class AntiLocking { none, cell, node };
constexpr std::array<const char*, 3> names_of(AntiLocking) { return {"none", "cell", "node"}; }

struct Remedies {
  AntiLocking anti_locking = AntiLocking::none;
  double largest_domain = 0;  ///< of convected domains, from a particle to a corner [cells]; 0: as they deform
  double small_mass = 0;      ///< lighter nodes take up force in proportion [rho0 h^Dim]; 0: all forces
  /// C1 and C2 of q = rho h (C1 c + C2 h |tr D|) |tr D| in compression, h a cell's width, of
  /// cells and domains that deform with the body where they are thinnest; 0: no viscosity.
  std::array<double, 2> viscosity{};
  double viscosity_speed = 0;  ///< c of it [m/s]

  bool averages_volume() const { return anti_locking != AntiLocking::none; }
  bool has_viscosity() const { return viscosity[0] > 0 || viscosity[1] > 0; }
};

}  // namespace assay::mpm
