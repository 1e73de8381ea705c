// SPDX-License-Identifier: BSD-3-Clause
// Integrals of X f(R) over the part in the ring of each of many reference domains, for any function f of the radius.
#pragma once

#include <span>
#include <vector>

#include "harness/exact/reference_domain.hpp"

namespace assay {

class RingMoments {
 public:
  RingMoments(const Annulus& ring, const ReferenceDomains& domains);

  /// The radial nodes between which f is interpolated [m].
  std::span<const double> nodes() const { return nodes_; }

  /// Integrals over the shapes first to last - 1 of X f(R) dA. f: at the nodes, its parts along X and E_z x X.
  void integrals(std::span<const Point> f, std::size_t first, std::size_t last, std::span<Point> out) const;

 private:
  struct Range {
    std::uint32_t begin = 0, end = 0, node = 0;  ///< weights of nodes from `node` on
  };
  static void sum_up(std::span<const Range> ranges, const Point* weights, const Point* f, Point* out);
  int lay_out_panels(const Annulus& ring, const ReferenceDomains& domains);

  std::vector<double> nodes_;   // [m]
  std::vector<Point> weights_;  // integral of X L_k(R) dA over a shape [m^3]
  std::vector<Range> ranges_;   // of each shape
};

}  // namespace assay
