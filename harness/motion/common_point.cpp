// SPDX-License-Identifier: BSD-3-Clause
// A body is all that lies within a thickness of its core: the centre of a ball, the circle in the middle of a torus,
// all of a drum. Two bodies have points in common where their cores are nearer than the sum of both.
#include "harness/motion/common_point.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "harness/numeric/norms.hpp"

namespace assay {

namespace {

constexpr double touching = 1e-6;  ///< as deep: bodies whose edges touch have no point in common

/// A body at the depth of touching: what two of them have in common lies deeper in both.
class Core {
 public:
  explicit Core(const Revolution& r)
      : center(r.center),
        axis(unit_along(r.axis)),
        is_drum(r.profile == Revolution::Profile::drum),
        ring(r.profile == Revolution::Profile::torus ? r.ring_radius.value_or(0) : 0) {
    const double shrunk = std::sqrt(1 - touching);
    (is_drum ? drum_radius : thickness) = shrunk * r.radius;
    if (is_drum) drum_height = shrunk * r.height.value_or(r.radius);
  }

  Vector3 center, axis;
  bool is_drum;
  double ring;           ///< radius of the circle; 0: a point, or a drum [m]
  double thickness = 0;  ///< [m]
  double drum_radius = 0, drum_height = 0;

  /// The point of the core that is nearest to X.
  Vector3 nearest(const Vector3& X) const {
    const double Z = (X - center).dot(axis);
    const Vector3 radial = X - center - Z * axis;
    const double R = radial.norm();
    if (!is_drum) return center + ring * (R > 0 ? Vector3(radial / R) : axis.unitOrthogonal());
    const double inward = R > drum_radius ? drum_radius / R : 1;
    return center + inward * radial + std::clamp(Z, -drum_height, drum_height) * axis;
  }

  /// The point of a drum that lies farthest along a direction.
  Vector3 farthest(const Vector3& along) const {
    const double up = along.dot(axis);
    Vector3 across = along - up * axis;
    across -= across.dot(axis) * axis;  // the rounding of the first difference may lie along the axis
    const double size = across.norm();
    const bool has_side = size > 1e-14 * along.norm();
    return center + std::copysign(drum_height, up) * axis + (has_side ? drum_radius / size : 0) * across;
  }
};

/// The distance of a core from a point of another's circle, and how far it may fall within an arc around that.
struct ArcBound {
  double distance = 0;
  double least = 0;  ///< within the arc [m]

  /// way: half the length of the arc; outwards, along: unit vectors at the point, from the circle's centre and along
  /// it.
  ArcBound(const Core& other, const Vector3& X, double circle, const Vector3& outwards, const Vector3& along,
           double way) {
    const Vector3 from = X - other.nearest(X);
    distance = from.norm();
    least = distance - way;
    if (!(distance > 0)) return;
    // A distance to a point or a drum is convex. That to a circle is so in the half plane through the circle's axis,
    // and there the radius of a point on a straight way exceeds its tangent by at most bend way^2.
    const Vector3 slope = from / distance;
    double bend = std::max(slope.dot(outwards), 0.0) / (2 * circle);
    if (other.ring > 0) {
      const Vector3 of_center = X - other.center, radial = of_center - of_center.dot(other.axis) * other.axis;
      const double R = radial.norm(), inward = R > 0 ? std::max(-slope.dot(radial) / R, 0.0) : 1;
      if (inward > 0) bend += R > way ? inward / (2 * (R - way)) : HUGE_VAL;
    }
    least = std::max(least, distance - std::abs(slope.dot(along)) * way - bend * way * way);
  }
};

/// The point of the circle of a torus at which another core is nearer than that; absent where none is.
std::optional<Vector3> point_of_circle(const Core& torus, const Core& other, double nearer) {
  constexpr double same = 1e-9;  // of the distance
  constexpr double first = M_PI / 4;
  const Vector3 u = torus.axis.unitOrthogonal(), v = torus.axis.cross(u), apart = other.center - torus.center;
  const double tilt = torus.axis.cross(other.axis).norm(), shift = torus.axis.cross(apart).norm();
  const bool coaxial = tilt * (apart.norm() + torus.ring) + shift < same * nearer;
  struct Arc {
    double middle, half;
  };
  std::vector<Arc> arcs{{0, first}};
  if (!coaxial) arcs = {{0, first}, {2 * first, first}, {4 * first, first}, {6 * first, first}};
  while (!arcs.empty()) {
    const Arc arc = arcs.back();
    arcs.pop_back();
    const double c = std::cos(arc.middle), s = std::sin(arc.middle), way = torus.ring * arc.half;
    const Vector3 outwards = c * u + s * v, X = torus.center + torus.ring * outwards;
    const ArcBound bound(other, X, torus.ring, outwards, c * v - s * u, way);
    if (bound.distance < nearer) return X;
    if (coaxial || bound.least >= nearer || way < same * nearer) continue;
    for (const double side : {-0.5, 0.5}) arcs.push_back({arc.middle + side * arc.half, 0.5 * arc.half});
  }
  return std::nullopt;
}

/// A point of the difference of two drums, and the point of the first that it is of [m].
struct DrumVertex {
  Vector3 difference, of_first;
};

/// Leaves of a simplex the vertices between which the point lies that is nearest to the origin; that point, and of
/// which of the first drum it is.
DrumVertex nearest_to_origin(std::vector<DrumVertex>& simplex) {
  using Edges = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3>;
  DrumVertex best{Vector3::Constant(HUGE_VAL), {}};
  std::vector<DrumVertex> kept;
  for (unsigned some = 1; some < 1U << simplex.size(); ++some) {
    std::vector<DrumVertex> part;
    for (std::size_t k = 0; k < simplex.size(); ++k) {
      if (some >> k & 1U) part.push_back(simplex[k]);
    }
    const auto edges = static_cast<Eigen::Index>(part.size()) - 1;
    DrumVertex found = part.front();
    if (edges > 0) {
      Edges E(3, edges), of_first(3, edges);
      for (Eigen::Index k = 0; k < edges; ++k) {
        const DrumVertex& vertex = part[static_cast<std::size_t>(k) + 1];
        E.col(k) = vertex.difference - part[0].difference;
        of_first.col(k) = vertex.of_first - part[0].of_first;
      }
      const Eigen::VectorXd share = E.colPivHouseholderQr().solve(-part[0].difference);
      if (share.minCoeff() < 0 || share.sum() > 1) continue;
      found = {part[0].difference + E * share, part[0].of_first + of_first * share};
    }
    if (found.difference.norm() < best.difference.norm()) best = found, kept = part;
  }
  simplex = kept;
  return best;
}

/// A point of both drums, by the algorithm of Gilbert, Johnson and Keerthi: the origin is sought in the difference of
/// both. Absent where a plane separates them.
std::optional<Vector3> point_of_drums(const Core& a, const Core& b) {
  constexpr double same = 1e-8;  // of the smallest size
  constexpr int most = 200;
  const auto vertex = [&](const Vector3& along) {
    const Vector3 X = a.farthest(along);
    return DrumVertex{X - b.farthest(-along), X};
  };
  const Vector3 apart = b.center - a.center;
  for (const Vector3& along : {apart, a.axis, b.axis, Vector3(a.axis.cross(b.axis))}) {
    const double side = std::copysign(1, along.dot(apart));
    if (side * along.dot(vertex(side * along).difference) < 0) return std::nullopt;
  }
  const double near = same * std::min({a.drum_radius, a.drum_height, b.drum_radius, b.drum_height});
  std::vector<DrumVertex> simplex{vertex(apart)};
  for (int k = 0; k < most; ++k) {
    const DrumVertex nearest = nearest_to_origin(simplex);
    if (nearest.difference.norm() < near) return nearest.of_first;
    simplex.push_back(vertex(-nearest.difference));
    if (nearest.difference.dot(simplex.back().difference) > 0) return std::nullopt;
  }
  return std::nullopt;
}

/// A point of both bodies, at least as deep as touching.
std::optional<Vector3> point_of_both(const Core& a, const Core& b) {
  if (a.is_drum && b.is_drum) return point_of_drums(a, b);
  if (a.is_drum || (a.ring == 0 && b.ring > 0 && !b.is_drum)) return point_of_both(b, a);
  const double nearer = a.thickness + b.thickness;
  std::optional<Vector3> of_a = a.center;
  if (a.ring > 0) of_a = point_of_circle(a, b, nearer);
  if (!of_a) return std::nullopt;
  const Vector3 way = b.nearest(*of_a) - *of_a;
  if (!(way.norm() < nearer)) return std::nullopt;
  return *of_a + a.thickness / nearer * way;
}

/// Point k of a lattice of 3^3 points from -1 to 1.
Vector3 neighbour(int k) { return Eigen::Vector3i(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1).cast<double>(); }

/// A place near X that lies deeper in both, as steps that become ever shorter find it.
Vector3 deeper(const Revolution& a, const Revolution& b, Vector3 X) {
  constexpr double longest = 0.25, shortest = 1e-3;  // of the smallest size
  const auto depth = [&](const Vector3& at) { return std::min(a.depth(at), b.depth(at)); };
  const double size = std::min({a.radius, b.radius, a.height.value_or(a.radius), b.height.value_or(b.radius)});
  double deepest = depth(X);
  for (double step = longest * size; step > shortest * size;) {
    const Vector3 from = X;
    for (int k = 0; k < 27; ++k) {
      const Vector3 at = from + step * neighbour(k);
      if (depth(at) > deepest) deepest = depth(at), X = at;
    }
    if (X == from) step /= 2;
  }
  return X;
}

}  // namespace

std::optional<Vector3> common_point(const Revolution& a, const Revolution& b) {
  const auto X = point_of_both(Core(a), Core(b));
  return X ? std::optional(deeper(a, b, *X)) : std::nullopt;
}

}  // namespace assay
