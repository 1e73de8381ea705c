// SPDX-License-Identifier: BSD-3-Clause
// The body force of a polar motion averaged over the particles' reference domains, from tau alone: no derivative of it.
//
//   b_avg = a_avg - 1/(rho0 V) closed integral of T.N dS,   T = r tau q^T (20), 0 outside the vortex's ring
//
// Straight edges are split at the ring's edges (by ReferenceDomains) and, at each time, at the fronts of the material;
// two Gauss points a piece. Along an arc tau and alpha are constant: the angle is integrated exactly.
//
//        +--:--+        edges inside the ring bear T.N, which two neighbours share with opposite signs;
//        |  :  |        the dotted arc is the ring's face, an edge of the part in the ring;
//        +--:--+        a, a function X f(R) of the place, is integrated over that part (RingMoments)
#pragma once

#include <span>
#include <vector>

#include "harness/exact/exact_fields.hpp"
#include "harness/exact/reference_domain.hpp"
#include "harness/motion/motion.hpp"
#include "harness/numeric/gauss.hpp"
#include "harness/numeric/parallel.hpp"

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

class PolarAverage {
 public:
  /// S = Q(alpha) tau at a radius, row-major.
  struct Rotated {
    double s11 = 0, s12 = 0, s21 = 0, s22 = 0;
  };

  /// density: rho0 [kg/m^3]; rule: of each straight piece; rest: stress in the
  /// plane at rest [Pa].
  PolarAverage(const Motion& motion, double density, const ReferenceDomains& domains,
               std::span<const GaussPoint> rule = gauss_rule<2>(), double rest = 0);

  /// Writes b_avg [m/s^2] of each particle at the time of the response. Allocates nothing where there are no fronts.
  void evaluate(const ResponseAtTime& response, double t, std::span<double> b_x, std::span<double> b_y,
                const InPieces& pieces = in_one_piece);

  std::size_t radii() const { return xi_.size(); }     ///< at which tau is asked for
  std::size_t edges() const { return edges_.size(); }  ///< that are integrated

 private:
  /// A point on a boundary: T.N dS = S_11 n1 e + S_12 n2 e + (S_21 n1 + S_22 n2) e', S = Q(alpha) tau,
  /// with e along E_R, e' along E_Theta (of an arc e is the integral of E_R), n the normal in E_R, E_Theta times the
  /// weight [m].
  struct BoundaryPoint {
    BoundaryPoint(const Point& e, const Point& n)
        : along_x{e[0] * n[0], e[0] * n[1]}, along_y{e[1] * n[0], e[1] * n[1]} {}
    Point along_x, along_y;  ///< e_x n, e_y n [m]
    std::uint32_t radius = 0;
  };
  struct Edge {
    std::uint32_t begin = 0, end = 0;  ///< of its points
    Point a{}, b{};
    double nearest = 0, farthest = 0;  ///< radii between which it runs; equal for an arc [m]
  };
  struct Side {
    std::uint32_t edge = 0;
    double sign = 1;
  };
  struct Shape {
    std::uint32_t sides_begin = 0, sides_end = 0;
    double of_inertia = 0, of_flux = 0;  ///< 1/V0 [1/m^2], -1/(rho0 V0)
  };

  void add_edges(const ReferenceDomains& domains, double density);
  std::uint32_t add_arc(const BoundaryPiece& arc, std::vector<double>& radius);
  std::uint32_t add_straight(const Point& a, const Point& b, std::vector<double>& radius);
  void add_points(const Point& a, const Point& b, std::vector<BoundaryPoint>& points,
                  std::vector<double>& radius) const;
  void share_radii(std::span<const double> radius);
  Point flux_of(std::span<const BoundaryPoint> points, std::span<const Rotated> S) const;
  void cuts_of(const Edge& edge, std::span<const double> radii, std::vector<double>& cuts) const;
  std::vector<Rotated> rotated_at(const ResponseAtTime& response, double g, std::span<const double> radius) const;
  void split_at_fronts(const ResponseAtTime& response, double g);
  void accelerations(double t);
  void force_on(std::size_t shape);

  Motion motion_;
  double rest_;  ///< stress in the plane, of which the outside is full, too [Pa]
  std::vector<GaussPoint> rule_;
  std::function<std::vector<double>(double)> radii_of_xi_;
  std::vector<ReferenceDomains::Place> places_;
  RingMoments moments_;
  RingsInMotion nodes_;  // at the radial nodes of these
  std::vector<Shape> shapes_;
  std::vector<Side> sides_;
  std::vector<Edge> edges_;
  std::vector<BoundaryPoint> points_;
  std::vector<double> xi_, h_;  // of each distinct radius
  std::vector<double> tau_;
  std::vector<Rotated> rotated_;
  std::vector<Point> flux_;    // of each edge [N/m]
  std::vector<Point> node_a_;  // along X and E_z x X [1/s^2]
  std::vector<Point> force_;   // of each shape: integral of a, then b [m/s^2]
};

/// The means of x and v over the particles' domains: those of X, and what the part in the ring adds to them.
class PolarMeans {
 public:
  PolarMeans(const Motion& motion, const ReferenceDomains& domains);
  void set_time(double t);
  /// centroid: of the particle's domain [m].
  PlaneMean at(std::size_t particle, const Point& centroid) const;

 private:
  std::vector<ReferenceDomains::Place> places_;
  RingMoments moments_;
  RingsInMotion nodes_;
  std::vector<double> volume_;            // of each shape [m^3]
  std::vector<Point> node_x_, node_v_;    // at the radial nodes, along X and E_z x X: x - X and v [1], [1/s]
  std::vector<Point> added_x_, added_v_;  // of each shape
};

}  // namespace assay
