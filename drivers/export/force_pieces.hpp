// SPDX-License-Identifier: BSD-3-Clause
// The body force of the plane vortex as a few polynomials, for codes that take source or expressions.
//
// Along e_r and e_theta of the current position b depends on R and t alone. Over a piece [R0, R1] x [t0, t1] each
// component is a sum of a few products P(s) Q(u), where s and u go from -1 to 1 over the piece. P and Q are written in
// powers, for Horner's rule. The products come of the singular values of the coefficients of a Chebyshev interpolant.
// A point of the vortex keeps its radius: whoever knows its position alone knows R, and whoever knows X alone turns by
// alpha = g(t) h(R) besides.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "drivers/export/force_series.hpp"
#include "drivers/scene/scene.hpp"
#include "harness/exact/exact_fields.hpp"
#include "harness/motion/kinds/vortex.hpp"

namespace assay::drivers {

struct ForcePieces {
  Vortex vortex;
  bool quasi_static = false;                       ///< b without inertia
  std::vector<double> radii;                       ///< edges of the pieces, ascending; b = 0 outside [m]
  std::vector<double> times;                       ///< likewise, from 0 to the end [s]
  std::vector<std::array<ForceSeries, 2>> pieces;  ///< [time * (radii - 1) + radius], radial and tangential
  double largest = 0;                              ///< |b| [m/s^2]
  double tolerance = 0;                            ///< that was asked for, relative to it
  double error = 0;                                ///< largest one between the nodes, as written, relative to it

  std::size_t rings() const { return radii.size() - 1; }
  std::size_t slabs() const { return times.size() - 1; }
  const std::array<ForceSeries, 2>& piece(std::size_t slab, std::size_t ring) const {
    return pieces[slab * rings() + ring];
  }
  std::size_t numbers() const;  ///< coefficients in all

  /// b along e_r and e_theta, by the same operations as the source that is written [m/s^2].
  Polar at(double R, double t) const;
};

struct ForceFit {
  bool quasi_static = false;
  double tolerance = 1e-6;  ///< of b, relative to the largest
  double end = 1;           ///< [s]
  std::size_t most_pieces = 48;
  std::string asked_by = {};  ///< as a message names it: "--to lammps"
};

/// solution: of a vortex in the plane, in its own frame. Throws InputError where the pieces would be too many, as for a
/// material with kinks, MaterialFailure.
ForcePieces fit_force(const ExactSolution& solution, const ForceFit& fit);

/// Why the scene's body force cannot be written as pieces; empty: it can.
std::string fault_of_pieces(const Scene& scene);

}  // namespace assay::drivers
