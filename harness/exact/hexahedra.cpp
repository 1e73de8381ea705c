// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/hexahedra.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "harness/exact/divided_quadrature.hpp"

namespace assay {

namespace {

/// A domain's faces, whose normals by the order of their corners point outwards.
constexpr int face_corners[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}, {1, 2, 6, 5}, {3, 0, 4, 7}};

struct HashOfFace {
  std::size_t operator()(const Hexahedra::Face& face) const {
    std::size_t seed = 0;
    for (const std::uint32_t corner : face) seed = seed * 1000003 ^ corner;
    return seed;
  }
};

/// Whether two orders of the same corners go round the same way.
bool same_way(const Hexahedra::Face& a, const Hexahedra::Face& b) {
  const auto at = static_cast<std::size_t>(std::find(b.begin(), b.end(), a[0]) - b.begin());
  return b[(at + 1) % 4] == a[1];
}

template <int Dim, class Indices>
MultilinearMap<Dim> map_of(const Hexahedra& domains, const Indices& indices) {
  MultilinearMap<Dim> map;
  for (std::size_t k = 0; k < map.corners.size(); ++k) map.corners[k] = domains.corners()[indices[k]];
  return map;
}

double volume_at(const MultilinearMap<3>& map, const std::array<double, 3>& u) {
  return map.slope(u, 0).dot(map.slope(u, 1).cross(map.slope(u, 2)));
}

}  // namespace

Hexahedra::Hexahedra(std::span<const std::array<Vector3, 8>> domains) {
  std::unordered_map<std::array<double, 4>, std::uint32_t, PositionHash> known;
  std::unordered_map<Face, std::uint32_t, HashOfFace> known_faces;
  const auto corner_of = [&](const Vector3& x) {
    const auto [it, is_new] =
        known.try_emplace({x.x() + 0.0, x.y() + 0.0, x.z() + 0.0, 0}, static_cast<std::uint32_t>(corners_.size()));
    if (is_new) corners_.push_back(x);
    return it->second;
  };
  const auto side_of = [&](const Face& face) {
    Face sorted = face;
    std::sort(sorted.begin(), sorted.end());
    const auto [it, is_new] = known_faces.try_emplace(sorted, static_cast<std::uint32_t>(faces_.size()));
    if (is_new) faces_.push_back(face);
    return Side{it->second, is_new || same_way(face, faces_[it->second]) ? 1.0 : -1.0};
  };
  for (const std::array<Vector3, 8>& given : domains) {
    Domain domain;
    for (std::size_t k = 0; k < 8; ++k) domain.corners[k] = corner_of(given[k]);
    for (std::size_t f = 0; f < 6; ++f) {
      Face face;
      for (std::size_t k = 0; k < 4; ++k) face[k] = domain.corners[static_cast<std::size_t>(face_corners[f][k])];
      domain.sides[f] = side_of(face);
    }
    domains_.push_back(domain);
  }
}

std::vector<std::array<Vector3, 8>> boxes_around(std::span<const Vector3> points, const Vector3& half) {
  std::vector<std::array<Vector3, 8>> boxes(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    const std::array<Interval, 3> sides{side_around(points[p][0], half[0]), side_around(points[p][1], half[1]),
                                        side_around(points[p][2], half[2])};
    constexpr int upper[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                 {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    for (std::size_t k = 0; k < 8; ++k) {
      for (std::size_t d = 0; d < 3; ++d)
        boxes[p][k][static_cast<int>(d)] = upper[k][d] ? sides[d].upper : sides[d].lower;
    }
  }
  return boxes;
}

HalfEdges::HalfEdges(std::span<const Vector3> corners, int directions) {
  constexpr std::size_t edges[12][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                                        {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  const std::size_t count = corners.size() == 4 || directions == 2 ? 4 : 12;
  for (const auto& [a, b] : std::span(edges).first(count)) {
    Vector3 edge = corners[b] - corners[a];
    if (directions == 2) edge.z() = 0;
    longest = std::max(longest, 0.5 * edge.norm()), shortest = std::min(shortest, 0.5 * edge.norm());
  }
}

HexahedronAverage::HexahedronAverage(Hexahedra domains, double density, const HexahedronRule& rule)
    : domains_(std::move(domains)), density_(density), rule_(rule) {
  for (const Hexahedra::Face& face : domains_.faces()) of_face_.push_back(points_along(face));
  for (const Hexahedra::Domain& domain : domains_.domains()) of_domain_.push_back(points_along(domain.corners));
  const auto& exact = gauss_rule<2>();  // det of a trilinear map is quadratic along each direction
  for (const Hexahedra::Domain& domain : domains_.domains()) {
    const MultilinearMap<3> map = map_of<3>(domains_, domain.corners);
    double volume = 0;
    for (const GaussPoint& u : exact) {
      for (const GaussPoint& v : exact) {
        for (const GaussPoint& w : exact)
          volume += 0.125 * u.weight * v.weight * w.weight *
                    volume_at(map, {0.5 * (1 + u.at), 0.5 * (1 + v.at), 0.5 * (1 + w.at)});
      }
    }
    volume_.push_back(volume);
  }
}

int HexahedronRule::points_along(double half_edge) const {
  return gauss + static_cast<int>(std::max(1.0, std::ceil(half_edge / reach))) - 1;
}

/// Those of a face or a domain. They follow from its own edges, so that its neighbours do not change what acts on it.
std::uint8_t HexahedronAverage::points_along(std::span<const std::uint32_t> corners) {
  std::array<Vector3, 8> places;
  for (std::size_t k = 0; k < corners.size(); ++k) places[k] = domains_.corners()[corners[k]];
  const HalfEdges half({places.data(), corners.size()}, rule_.directions);
  const auto points = static_cast<std::size_t>(rule_.points_along(half.longest));
  if (gauss_.size() <= points) gauss_.resize(points + 1);
  if (gauss_[points].empty()) gauss_[points] = gauss_points(static_cast<int>(points));
  return static_cast<std::uint8_t>(points);
}

HexahedronAverage::Flux HexahedronAverage::flux(const ExactSlice& slice, std::size_t face) const {
  const MultilinearMap<2> map = map_of<2>(domains_, domains_.faces()[face]);
  Flux sum;
  for_each_gauss_point<2>(slice, ExactSlice::Smooth::stress, map, gauss_[of_face_[face]], rule_.divisions, {},
                          [&](const std::array<double, 2>& u, double weight) {
                            const Vector3 X = map(u), normal = weight * map.slope(u, 0).cross(map.slope(u, 1));
                            const Vector3 force = slice.first_piola_kirchhoff(X) * normal;
                            sum.force += force;
                            sum.moment += slice.state(X).x.cross(force);
                          });
  return sum;
}

HexahedronAverage::Flux HexahedronAverage::inertia(const ExactSlice& slice, std::size_t domain) const {
  const MultilinearMap<3> map = map_of<3>(domains_, domains_.domains()[domain].corners);
  Flux sum;
  for_each_gauss_point<3>(slice, ExactSlice::Smooth::motion, map, gauss_[of_domain_[domain]], rule_.divisions / 2, {},
                          [&](const std::array<double, 3>& u, double weight) {
                            const ExactState now = slice.state(map(u));
                            const Vector3 force = density_ * weight * volume_at(map, u) * now.a;
                            sum.force += force;
                            sum.moment += now.x.cross(force);
                          });
  return sum;
}

std::vector<DomainForce> HexahedronAverage::at(const ExactSlice& slice, const InPieces& pieces) const {
  std::vector<Flux> flux_of(domains_.faces().size());
  pieces(flux_of.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) flux_of[f] = flux(slice, f);
  });
  std::vector<DomainForce> found(domains_.domains().size());
  pieces(found.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      const Hexahedra::Domain& domain = domains_.domains()[p];
      Flux sum = rule_.quasi_static ? Flux() : inertia(slice, p);
      for (const Hexahedra::Side& side : domain.sides) {
        sum.force -= side.sign * flux_of[side.face].force;
        sum.moment -= side.sign * flux_of[side.face].moment;
      }
      found[p] = {sum.force / (density_ * volume_[p]), sum.moment};
    }
  });
  return found;
}

}  // namespace assay
