// SPDX-License-Identifier: BSD-3-Clause
// Reference domains of particles in and around a ring: where they are bounded, what they hold.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "harness/motion/ring_kinematics.hpp"
#include "harness/numeric/range.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay {

using Point = std::array<double, 2>;
using Plane = std::array<double, 4>;  ///< a tensor's components 11, 12, 21, 22

inline Plane product(const Plane& a, const Plane& b) {
  return {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3]};
}
inline Plane transposed(const Plane& a) { return {a[0], a[2], a[1], a[3]}; }
inline Plane rotation(double c, double s) { return {c, -s, s, c}; }
inline Point times(const Plane& a, const Point& x) { return {a[0] * x[0] + a[1] * x[1], a[2] * x[0] + a[3] * x[1]}; }

inline Plane in_plane(const Tensor& s) { return {s(0, 0), s(0, 1), s(1, 0), s(1, 1)}; }
inline Point in_plane(const Vector3& v) { return {v.x(), v.y()}; }
/// With 33.
inline std::array<double, 5> plane_stress(const Tensor& s) { return {s(0, 0), s(0, 1), s(1, 0), s(1, 1), s(2, 2)}; }

/// Hash of two exact positions; -0 is 0.
struct PositionHash {
  std::size_t operator()(const std::array<double, 4>& key) const {
    std::size_t seed = 0;
    for (const double v : key) seed = seed * 1000003 ^ std::hash<double>()(v + 0.0);
    return seed;
  }
};

/// Axis-aligned, between two corners [m].
struct Rectangle {
  Point lower{}, upper{};
  double area() const { return (upper[0] - lower[0]) * (upper[1] - lower[1]); }
};

/// Between two radii [m] and two angles [rad].
struct Sector {
  double inner = 0, outer = 0, begin = 0, end = 0;
};

/// A piece of a boundary, from a to b with the domain on its left: straight, or an arc around the origin.
struct BoundaryPiece {
  Point a{}, b{};     ///< [m]
  double radius = 0;  ///< of an arc [m]; 0: straight
  double from = 0;    ///< angle at which an arc begins [rad]
  double sweep = 0;   ///< by which it turns, negative: clockwise [rad]

  bool straight() const { return radius == 0; }
};
using Boundary = std::vector<BoundaryPiece>;

/// The boundary of what a rectangle and a ring have in common: its edges inside the ring, split at the ring's edges,
/// and the arcs of the ring's edges inside it. Empty where they have nothing in common. The pieces follow in no order.
Boundary common_boundary(const Rectangle& rectangle, const Annulus& ring);

Boundary boundary_of(const Sector& sector);

struct AreaMoments {
  double area = 0;   ///< [m^2]
  Point centroid{};  ///< [m]
};

/// Of the domain inside a closed boundary; to round-off.
AreaMoments moments_of(const Boundary& boundary);

/// Points and (signed) weights of a quadrature over the inside of a closed boundary that does not contain the origin:
/// integral of f dA = sum w f(X). Exact to high order for what is smooth from the origin's side of it on: the area
/// integral is taken along radii and then along the boundary (Green). visit(X, w).
void for_each_area_point(const Boundary& boundary, const std::function<void(const Point&, double)>& visit);

/// Reference domains of many particles: the shapes that differ by more than a turn around the origin, once each.
struct ReferenceDomains {
  struct Shape {
    Boundary boundary;          ///< of the part in the ring
    double volume = 0;          ///< of the whole domain, per unit thickness [m^3]
    bool arcs_are_cuts = true;  ///< the domain ends at its arcs; false: it goes on beyond them, without stress
  };
  /// A particle has its shape turned by an angle whose cosine and sine stand here.
  struct Place {
    std::uint32_t shape = 0;
    double cos_turn = 1, sin_turn = 0;
    Point turned(const Point& X) const {
      return {cos_turn * X[0] - sin_turn * X[1], sin_turn * X[0] + cos_turn * X[1]};
    }
  };
  std::vector<Shape> shapes;
  std::vector<Place> places;  ///< of each particle
};

/// Around a point with a half edge [m]; on a lattice neighbours share their ends to the last bit.
Interval side_around(double middle, double half);

/// The same in the plane.
std::vector<Rectangle> rectangles_around(std::span<const double> X, std::span<const double> Y, const Point& half);

/// Whole rectangles, of which the part in the ring bears stress, or (clipped) those parts alone. Rectangles that are
/// images of each other under quarter turns share a shape.
ReferenceDomains domains_of(std::span<const Rectangle> rectangles, const Annulus& ring, bool clipped);

/// Sectors of one ring of sectors share a shape. sectors[k]: the first of ring k, centred at the angle 0; count[k]: how
/// many of them fill the circle. Particles follow ring by ring, counterclockwise from the positive x axis.
ReferenceDomains domains_of(std::span<const Sector> sectors, std::span<const int> count);

}  // namespace assay
