// SPDX-License-Identifier: BSD-3-Clause
// Particles at the Gauss-Legendre points of the grid's cells.
#pragma once

#include "harness/numeric/gauss.hpp"
#include "mpm/seeding/lattice.hpp"

namespace assay::mpm {

/// The Gauss-Legendre rule of a cell: its points, and the rectangles whose areas or volumes are their weights. These
/// tile the cell, each around its point, for the partial sums of the weights separate the points (Chebyshev, Markov,
/// Stieltjes).
template <std::size_t N>
class GaussCells {
 public:
  GaussCells(double spacing, const std::array<int, N>& per_cell);

  double coordinate(std::size_t d, std::int32_t cell, int k) const;  ///< of point k of a cell along axis d [m]
  double volume_at(const std::array<double, N>& X) const;            ///< of the particle at X [m^N]
  BoxOfAxes<N> box_around(const std::array<double, N>& X) const;     ///< of the particle at X

 private:
  struct Axis {
    std::vector<GaussPoint> points;
    std::vector<double> cuts;  ///< partial sums of the weights, from -1 to 1
  };
  struct Place {
    double middle = 0;  ///< of the cell [h/2]
    std::size_t k = 0;  ///< the point's number
  };
  Place place_of(std::size_t d, double x) const;

  double half_;  ///< of a cell [m]
  std::array<Axis, N> axes_;
};

/// As `cartesian_lattice`, at the Gauss points of the cells and with their weights. Where the corners are no nodes the
/// cells at the edges are incomplete.
template <std::size_t N>
Seeds<int{N}> gauss_lattice(const std::array<double, N>& lower, const std::array<double, N>& upper, double spacing,
                            const std::array<int, N>& per_cell, const std::type_identity_t<FateOf<N>>& fate);

/// The rectangles of its particles, for the average of the body force.
ReferenceDomains gauss_domains(const Seeds<2>& seeds, const GaussCells<2>& cells, const Annulus& ring);

}  // namespace assay::mpm
