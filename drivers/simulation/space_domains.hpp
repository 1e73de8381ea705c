// SPDX-License-Identifier: BSD-3-Clause
// The space that each particle of a body takes, as pictures and files show it.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "drivers/simulation/problem.hpp"
#include "mpm/data/columns.hpp"
#include "mpm/seeding/gauss_lattice.hpp"

namespace assay::drivers {

/// Where component c of a column begins.
using ColumnView = std::function<const double*(mpm::Column, int)>;

/// A domain of the basis, if it has some: its corners where they move one by one, a box along the axes, or a
/// parallelepiped. Else the part of the reference lattice that the particle stands for, deformed by its F.
class SpaceDomains {
 public:
  using Corners = std::array<Vector3, 8>;  ///< in the order of mpm::Corners [m]

  explicit SpaceDomains(const ProblemIn<3>& problem);

  /// The middle of a domain, and half edges between its faces: column d. Where corners move one by one the means.
  struct Shape {
    Vector3 middle;  ///< [m]
    Tensor half;     ///< [m]
  };

  /// The domains of one moment.
  class Now {
   public:
    Shape shape(std::size_t p) const;
    Corners corners(std::size_t p) const;

   private:
    friend class SpaceDomains;
    const SpaceDomains* domains_ = nullptr;
    std::array<const double*, 3> x_{};
    std::array<const double*, 9> F_{};
    std::array<const double*, 24> corners_{};  ///< null where there are none
  };
  /// keeps_corners: whether the columns are all those of the state. Without corners the domains are those of F.
  Now now(const ColumnView& of, bool keeps_corners) const;

 private:
  enum class Kind { deformed, corners, box, stretched_box };

  const mpm::Seeds<3>* seeds_;
  Kind kind_;
  double largest_half_ = 0;                  ///< of a box that stretches [m]
  Tensor turn_, half_;                       ///< of the lattice against the grid, and of each particle on it
  std::optional<mpm::GaussCells<3>> gauss_;  ///< whose points are not in the middle of their parts
};

/// Where the corners of VTK's hexahedron stand among those of mpm::Corners.
inline constexpr std::array<std::size_t, 8> corners_in_vtk{0, 1, 3, 2, 4, 5, 7, 6};

}  // namespace assay::drivers
