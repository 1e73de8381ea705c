// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/seeding/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace assay::mpm {

namespace {

/// A bound that is a multiple of h up to rounding counts as that multiple.
constexpr double rounding = 1e-9;

std::int32_t cell_below(double x, double h) { return static_cast<std::int32_t>(std::floor(x / h + rounding)); }
std::int32_t cell_above(double x, double h) { return static_cast<std::int32_t>(std::ceil(x / h - rounding)); }

/// All bits of the result depend on all bits of x (the finaliser of SplitMix64; Steele, Lea and Flood 2014).
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// Between -1 and 1, both excluded: 52 bits of a hash, no rounding.
double noise(std::uint64_t seed, std::uint64_t number) {
  return (static_cast<double>(mixed(mixed(seed) ^ number) >> 12) + 0.5) * 0x1p-51 - 1;
}

/// All lattice cells of the square around the ring that may have a part in it.
std::vector<Rectangle> cells_around(const Annulus& ring, double spacing, const std::array<int, 2>& per_cell) {
  std::array<double, 2> half{};
  std::array<std::int64_t, 2> reach{};
  for (std::size_t d = 0; d < 2; ++d) {
    half[d] = 0.5 * spacing / per_cell[d];
    reach[d] = static_cast<std::int64_t>(cell_above(ring.outer, spacing)) * per_cell[d];
  }
  const auto corner = [&](std::size_t d, std::int64_t i) { return 2.0 * static_cast<double>(i) * half[d]; };
  std::vector<Rectangle> cells;
  for (std::int64_t j = -reach[1]; j < reach[1]; ++j) {
    for (std::int64_t i = -reach[0]; i < reach[0]; ++i) {
      const Rectangle cell{{corner(0, i), corner(1, j)}, {corner(0, i + 1), corner(1, j + 1)}};
      const auto near = [&](std::size_t d) { return std::min(std::abs(cell.lower[d]), std::abs(cell.upper[d])); };
      const auto far = [&](std::size_t d) { return std::max(std::abs(cell.lower[d]), std::abs(cell.upper[d])); };
      if (std::hypot(near(0), near(1)) < ring.outer && std::hypot(far(0), far(1)) > ring.inner) cells.push_back(cell);
    }
  }
  return cells;
}

/// An edge this close to a face [relative to the body] lies on it.
constexpr double face_rounding = 1e-12;

}  // namespace

namespace {

/// body(cells), the first axis fastest, for all cells from lower to upper - 1.
template <std::size_t N>
void for_cells(const std::array<std::int32_t, N>& lower, const std::array<std::int32_t, N>& upper, const auto& body) {
  for (std::size_t d = 0; d < N; ++d) {
    if (lower[d] >= upper[d]) return;
  }
  std::array<std::int32_t, N> at = lower;
  for (;;) {
    body(at);
    std::size_t d = 0;
    while (d < N && ++at[d] == upper[d]) at[d] = lower[d], ++d;
    if (d == N) return;
  }
}

}  // namespace

template <std::size_t N>
Seeds<int{N}> lattice_of(const std::array<double, N>& lower, const std::array<double, N>& upper, double spacing,
                         const std::array<int, N>& per_cell, const CellPoint& coordinate,
                         const std::type_identity_t<FateOf<N>>& fate) {
  Seeds<int{N}> seeds;
  std::array<std::int32_t, N> first, end, none{};
  for (std::size_t d = 0; d < N; ++d) {
    seeds.half_size[d] = 0.5 * spacing / per_cell[d];
    first[d] = cell_below(lower[d], spacing), end[d] = cell_above(upper[d], spacing);
  }
  for_cells<N>(first, end, [&](const auto& cell) {
    for_cells<N>(none, per_cell, [&](const auto& k) {
      std::array<double, N> X;
      for (std::size_t d = 0; d < N; ++d) {
        X[d] = coordinate(d, cell[d], k[d]);
        if (X[d] < lower[d] || X[d] > upper[d]) return;
      }
      const Fate what = fate(X);
      if (what == Fate::held) seeds.held.push_back(X);
      if (what != Fate::stepped) return;
      for (std::size_t d = 0; d < N; ++d) seeds.X[d].push_back(X[d]);
    });
  });
  return seeds;
}

template <std::size_t N>
Seeds<int{N}> cartesian_lattice(const std::array<double, N>& lower, const std::array<double, N>& upper, double spacing,
                                const std::array<int, N>& per_cell, const std::type_identity_t<FateOf<N>>& fate) {
  // (2 i + 1) half: the same |X| to the last bit on both sides of the origin
  std::array<double, N> half;
  for (std::size_t d = 0; d < N; ++d) half[d] = 0.5 * spacing / per_cell[d];
  const auto coordinate = [&](std::size_t d, std::int32_t cell, int k) {
    return (2.0 * (static_cast<double>(cell) * per_cell[d] + k) + 1) * half[d];
  };
  return lattice_of(lower, upper, spacing, per_cell, coordinate, fate);
}

template <int Dim>
void disturb(Seeds<Dim>& seeds, double fraction, std::uint64_t seed,
             const std::type_identity_t<std::function<bool(const std::array<double, Dim>&)>>& inside) {
  const auto offset = [&](std::size_t particle, std::size_t d) {
    return fraction * 2 * seeds.half_size[d] * noise(seed, Dim * particle + d);
  };
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    std::array<double, Dim> X;
    for (std::size_t d = 0; d < Dim; ++d) X[d] = seeds.X[d][p] + offset(p, d);
    if (inside && !inside(X)) continue;
    for (std::size_t d = 0; d < Dim; ++d) seeds.X[d][p] = X[d];
  }
  for (std::size_t d = 0; d < Dim; ++d) {
    for (std::size_t k = 0; k < seeds.held.size(); ++k) seeds.held[k][d] += offset(seeds.size() + k, d);
  }
}

Seeds<2> clipped_lattice(const Annulus& ring, double spacing, const std::array<int, 2>& per_cell) {
  Seeds<2> seeds;
  for (std::size_t d = 0; d < 2; ++d) seeds.half_size[d] = 0.5 * spacing / per_cell[d];
  ReferenceDomains domains = domains_of(cells_around(ring, spacing, per_cell), ring, true);
  std::vector<Point> centroids;
  for (const auto& shape : domains.shapes) centroids.push_back(moments_of(shape.boundary).centroid);
  const double least = rounding * seeds.volume();
  std::erase_if(domains.places, [&](const auto& place) { return !(domains.shapes[place.shape].volume > least); });
  for (const auto& place : domains.places) {
    const Point X = place.turned(centroids[place.shape]);
    seeds.X[0].push_back(X[0]);
    seeds.X[1].push_back(X[1]);
    seeds.volumes.push_back(domains.shapes[place.shape].volume);
  }
  seeds.domains = std::make_shared<const ReferenceDomains>(std::move(domains));
  return seeds;
}

Seeds<2> polar_lattice(const Annulus& ring, double spacing, const std::array<int, 2>& per_cell, bool share_corners) {
  Seeds<2> seeds;
  for (std::size_t d = 0; d < 2; ++d) seeds.half_size[d] = 0.5 * spacing / per_cell[d];
  const double width = ring.outer - ring.inner;
  const int rings = static_cast<int>(std::ceil(width / (2 * seeds.half_size[0]) - rounding));
  std::vector<Sector> sectors;
  std::vector<int> count;
  for (int k = 0; k < rings; ++k) {
    const double inner = ring.inner + width * k / rings, outer = ring.inner + width * (k + 1) / rings;
    const double quarter = 0.25 * std::numbers::pi * (share_corners ? ring.inner + ring.outer : inner + outer);
    count.push_back(4 * static_cast<int>(std::ceil(quarter / (2 * seeds.half_size[1]) - rounding)));
    const double half = std::numbers::pi / count.back();
    sectors.push_back({inner, outer, -half, half});
  }
  ReferenceDomains domains = domains_of(sectors, count);
  for (const auto& place : domains.places) {
    const Sector& s = sectors[place.shape];
    const double volume = domains.shapes[place.shape].volume, half = 0.5 * (s.outer - s.inner);
    const double R = 4.0 / 3 * (std::pow(s.outer, 3) - std::pow(s.inner, 3)) /
                     ((s.outer - s.inner) * (s.outer + s.inner)) * std::sin(s.end) / (s.end - s.begin);  // centroid
    const double c = place.cos_turn, si = place.sin_turn, across = 0.25 * volume / half;
    seeds.X[0].push_back(R * c);
    seeds.X[1].push_back(R * si);
    seeds.volumes.push_back(volume);
    seeds.half_edges.push_back({half * c, -across * si, half * si, across * c});  // along E_R, E_Theta
    if (!share_corners) continue;
    const auto corner = [&](double radius, double angle) {
      return place.turned({radius * std::cos(angle), radius * std::sin(angle)});
    };
    seeds.corners.push_back(
        {corner(s.inner, s.begin), corner(s.outer, s.begin), corner(s.inner, s.end), corner(s.outer, s.end)});
  }
  seeds.domains = std::make_shared<const ReferenceDomains>(std::move(domains));
  return seeds;
}

ReferenceDomains rectangles_of(const Seeds<2>& seeds, const Annulus& ring) {
  return domains_of(rectangles_around(seeds.X[0], seeds.X[1], seeds.half_size), ring, false);
}

void turn(Seeds<2>& seeds, double angle, bool half_edges) {
  const ReferenceDomains::Place by{0, std::cos(angle), std::sin(angle)};
  if (seeds.domains) {
    ReferenceDomains domains = *seeds.domains;
    for (auto& place : domains.places) {
      const Point direction = by.turned({place.cos_turn, place.sin_turn});
      place.cos_turn = direction[0], place.sin_turn = direction[1];
    }
    seeds.domains = std::make_shared<const ReferenceDomains>(std::move(domains));
  }
  if (half_edges && seeds.half_edges.empty()) {
    seeds.half_edges.assign(seeds.size(), {seeds.half_size[0], 0, 0, seeds.half_size[1]});
  }
  for (auto& H : seeds.half_edges) {
    const Point first = by.turned({H[0], H[2]}), second = by.turned({H[1], H[3]});
    H = {first[0], second[0], first[1], second[1]};
  }
  for (auto& corners : seeds.corners) {
    for (Point& X : corners) X = by.turned(X);
  }
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    const Point X = by.turned({seeds.X[0][p], seeds.X[1][p]});
    seeds.X[0][p] = X[0], seeds.X[1][p] = X[1];
  }
  for (auto& X : seeds.held) X = by.turned(X);
  if (!half_edges && seeds.half_size[0] != seeds.half_size[1]) seeds.half_size.fill(0.5 * std::sqrt(seeds.volume()));
  seeds.angle += angle;
}

void turn(Seeds<3>& seeds, const Tensor& R, bool half_edges) {
  const auto turned = [&](const std::array<double, 3>& X) {
    const Vector3 x = R * Vector3(X[0], X[1], X[2]);
    return std::array{x.x(), x.y(), x.z()};
  };
  if (seeds.domains) {
    std::vector<std::array<Vector3, 8>> domains;
    for (const Hexahedra::Domain& domain : seeds.domains->domains()) {
      auto& corners = domains.emplace_back();
      for (std::size_t k = 0; k < corners.size(); ++k) corners[k] = R * seeds.domains->corners()[domain.corners[k]];
    }
    seeds.domains = std::make_shared<const Hexahedra>(domains);
  }
  if (half_edges) {
    std::array<double, 9> H{};
    for (int i = 0; i < 3; ++i) {
      for (int d = 0; d < 3; ++d)
        H[static_cast<std::size_t>(3 * i + d)] = R(i, d) * seeds.half_size[static_cast<std::size_t>(d)];
    }
    seeds.half_edges.assign(seeds.size(), H);
  }
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    const auto X = turned({seeds.X[0][p], seeds.X[1][p], seeds.X[2][p]});
    for (std::size_t d = 0; d < 3; ++d) seeds.X[d][p] = X[d];
  }
  for (auto& X : seeds.held) X = turned(X);
  for (SurfacePiece<3>& piece : seeds.surface) {
    piece.N_dA = turned(piece.N_dA), piece.middle = turned(piece.middle);
    for (auto& X : piece.X) X = turned(X);
  }
  if (!half_edges) seeds.half_size.fill(0.5 * std::cbrt(seeds.volume()));
}

template <std::size_t N>
GridGeometry<int{N}> grid_around(const std::array<double, N>& lower, const std::array<double, N>& upper, double spacing,
                                 int margin) {
  GridGeometry<int{N}> grid;
  grid.spacing = spacing;
  for (std::size_t d = 0; d < N; ++d) {
    grid.first[d] = cell_below(lower[d], spacing) - margin;
    grid.count[d] = cell_above(upper[d], spacing) + margin - grid.first[d] + 1;
  }
  return grid;
}

void add_surface_edges(const Rectangle& body, const std::array<AxisEnds, 2>& ends, const Rectangle& domain,
                       std::uint32_t particle, std::vector<SurfaceEdge>& edges) {
  const auto corner = [&](std::size_t c) {
    return Point{(c & 1) ? domain.upper[0] : domain.lower[0], (c & 2) ? domain.upper[1] : domain.lower[1]};
  };
  const double near = face_rounding * (body.upper[0] - body.lower[0] + body.upper[1] - body.lower[1]);
  for (std::size_t d = 0; d < 2; ++d) {
    const std::size_t along = 1 - d;
    for (const bool upper : {false, true}) {
      const double at = upper ? domain.upper[d] : domain.lower[d], face = upper ? body.upper[d] : body.lower[d];
      if (std::abs(at - face) > near || (upper ? ends[d].upper : ends[d].lower)) continue;
      const auto first = static_cast<std::uint8_t>(upper ? 1u << d : 0u);
      const auto second = static_cast<std::uint8_t>(first | 1u << along);
      const Point a = corner(first), b = corner(second);
      SurfaceEdge edge{particle, {first, second}, {}, {a, b}, {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])}};
      edge.N_dA[d] = (upper ? 1 : -1) * (domain.upper[along] - domain.lower[along]);
      edges.push_back(edge);
    }
  }
}

void add_surface_edges(const Cuboid& body, const std::array<AxisEnds, 3>& ends, const Cuboid& domain,
                       std::uint32_t particle, std::vector<SurfacePiece<3>>& faces) {
  double size = 0;
  for (std::size_t d = 0; d < 3; ++d) size += body.upper[d] - body.lower[d];
  for (std::size_t d = 0; d < 3; ++d) {
    for (const bool upper : {false, true}) {
      const double at = upper ? domain.upper[d] : domain.lower[d], face = upper ? body.upper[d] : body.lower[d];
      if (std::abs(at - face) > face_rounding * size || (upper ? ends[d].upper : ends[d].lower)) continue;
      const std::size_t along = d == 0 ? 1 : 0, across = d == 2 ? 1 : 2;
      SurfacePiece<3> piece{particle, {}, {}, {}, {}};
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t corner = (upper ? 1u << d : 0u) | (k & 1 ? 1u << along : 0u) | (k & 2 ? 1u << across : 0u);
        piece.corners[k] = static_cast<std::uint8_t>(corner);
        for (std::size_t i = 0; i < 3; ++i) {
          piece.X[k][i] = corner >> i & 1 ? domain.upper[i] : domain.lower[i];
          piece.middle[i] += 0.25 * piece.X[k][i];
        }
      }
      piece.N_dA[d] = (upper ? 1 : -1) * (domain.upper[along] - domain.lower[along]) *
                      (domain.upper[across] - domain.lower[across]);
      faces.push_back(piece);
    }
  }
}

void add_face_arcs(const Annulus& ring, Seeds<2>& seeds) {
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    const ReferenceDomains::Place& place = seeds.domains->places[p];
    for (const BoundaryPiece& piece : seeds.domains->shapes[place.shape].boundary) {
      const bool outer = piece.sweep > 0;
      if (piece.straight() || piece.radius != (outer ? ring.outer : ring.inner)) continue;
      const double middle = piece.from + 0.5 * piece.sweep, chord = 2 * piece.radius * std::sin(0.5 * piece.sweep);
      const Point out = place.turned({std::cos(middle), std::sin(middle)});
      SurfaceEdge edge{static_cast<std::uint32_t>(p), {}, {chord * out[0], chord * out[1]}, {}, {}};
      edge.X = {place.turned(piece.a), place.turned(piece.b)};
      edge.middle = {piece.radius * out[0], piece.radius * out[1]};
      if (!outer) std::swap(edge.X[0], edge.X[1]);  // counterclockwise
      edge.on_corners = !seeds.corners.empty();     // in the order in which polar_lattice gives them
      edge.corners = outer ? std::array<std::uint8_t, 2>{1, 3} : std::array<std::uint8_t, 2>{0, 2};
      seeds.surface.push_back(edge);
    }
  }
}

template Seeds<2> lattice_of(const std::array<double, 2>&, const std::array<double, 2>&, double,
                             const std::array<int, 2>&, const CellPoint&, const FateOf<2>&);
template Seeds<2> cartesian_lattice(const std::array<double, 2>&, const std::array<double, 2>&, double,
                                    const std::array<int, 2>&, const FateOf<2>&);
template void disturb(Seeds<2>&, double, std::uint64_t, const std::function<bool(const std::array<double, 2>&)>&);
template GridGeometry<2> grid_around(const std::array<double, 2>&, const std::array<double, 2>&, double, int);
template Seeds<3> lattice_of(const std::array<double, 3>&, const std::array<double, 3>&, double,
                             const std::array<int, 3>&, const CellPoint&, const FateOf<3>&);
template Seeds<3> cartesian_lattice(const std::array<double, 3>&, const std::array<double, 3>&, double,
                                    const std::array<int, 3>&, const FateOf<3>&);
template void disturb(Seeds<3>&, double, std::uint64_t, const std::function<bool(const std::array<double, 3>&)>&);
template GridGeometry<3> grid_around(const std::array<double, 3>&, const std::array<double, 3>&, double, int);

}  // namespace assay::mpm
