// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/seeds.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/scene/body_box.hpp"
#include "drivers/simulation/body_ends.hpp"
#include "mpm/gauss_lattice.hpp"
#include "mpm/lattice.hpp"

namespace assay::drivers {

namespace {

/// A cell that reaches into the ring by less [relative to the radius] lies outside it.
constexpr double edge_rounding = 1e-12;

/// Whether a part of a particle's domain lies in the ring.
bool partly_inside(const Vortex& vortex, const Rectangle& domain) {
  std::array<double, 2> nearest{}, farthest{};
  for (std::size_t d = 0; d < 2; ++d) {
    nearest[d] = std::max({0.0, domain.lower[d], -domain.upper[d]});
    farthest[d] = std::max(-domain.lower[d], domain.upper[d]);
  }
  return std::hypot(nearest[0], nearest[1]) < vortex.outer * (1 - edge_rounding) &&
         std::hypot(farthest[0], farthest[1]) > vortex.inner * (1 + edge_rounding);
}

Rectangle around(const Point& X, const Point& half) {
  return {{X[0] - half[0], X[1] - half[1]}, {X[0] + half[0], X[1] + half[1]}};
}

bool is_averaged(const Scene& scene) { return scene.force.evaluation == ForceChoice::Evaluation::domain_average; }

/// Particles in the cells of the grid, whole.
mpm::Seeds<2> whole_cells(const Scene& scene) {
  const auto& vortex = std::get<Vortex>(scene.motion);
  const Body& body = scene.body;
  const double h = scene.grid->spacing;
  const bool gauss = body.lattice == Body::Lattice::gauss;
  const mpm::GaussCells cells(h, body.per_cell);
  const auto domain_of = [&](const std::array<double, 2>& X) {
    if (gauss) return cells.rectangle_around(X);
    return around(X, {0.5 * h / body.per_cell[0], 0.5 * h / body.per_cell[1]});
  };
  const auto fate = [&](const std::array<double, 2>& X) {
    if (vortex.moves({X[0], X[1], 0})) return mpm::Fate::stepped;
    if (body.domain == Body::Domain::ring) return mpm::Fate::absent;
    if (body.outside == Body::Outside::free) return mpm::Fate::stepped;
    return is_averaged(scene) && partly_inside(vortex, domain_of(X)) ? mpm::Fate::stepped : mpm::Fate::held;
  };
  const Box box = body_box(scene);
  if (!gauss) return mpm::cartesian_lattice(box.lower, box.upper, h, body.per_cell, fate);
  mpm::Seeds<2> seeds = mpm::gauss_lattice(box.lower, box.upper, h, body.per_cell, fate);
  if (is_averaged(scene)) {
    const Annulus ring{vortex.inner, vortex.outer};
    seeds.domains = std::make_shared<const ReferenceDomains>(mpm::gauss_domains(seeds, cells, ring));
  }
  return seeds;
}

/// The edges of a particle's domain that lie on faces of the box which are neither symmetry planes nor periodic.
void add_surface(const Box& box, const std::array<mpm::AxisEnds, 2>& ends, const Rectangle& domain,
                 std::uint32_t particle, std::vector<mpm::SurfaceEdge>& all) {
  const auto corner = [&](std::size_t c) {
    return Point{(c & 1) ? domain.upper[0] : domain.lower[0], (c & 2) ? domain.upper[1] : domain.lower[1]};
  };
  const double near = edge_rounding * (box.upper[0] - box.lower[0] + box.upper[1] - box.lower[1]);
  for (std::size_t d = 0; d < 2; ++d) {
    const std::size_t along = 1 - d;
    for (const bool upper : {false, true}) {
      const double at = upper ? domain.upper[d] : domain.lower[d], face = upper ? box.upper[d] : box.lower[d];
      if (std::abs(at - face) > near || (upper ? ends[d].upper : ends[d].lower)) continue;
      const auto first = static_cast<std::uint8_t>(upper ? 1u << d : 0u);
      const auto second = static_cast<std::uint8_t>(first | 1u << along);
      const Point a = corner(first), b = corner(second);
      mpm::SurfaceEdge edge{particle, {first, second}, {}, {a, b}, {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])}};
      edge.N_dA[d] = (upper ? 1 : -1) * (domain.upper[along] - domain.lower[along]);
      all.push_back(edge);
    }
  }
}

/// The arcs of the particles' domains that lie on the ring's faces. P N is constant along an arc but for its direction,
/// so that its force is that of P N in the middle on the chord.
void add_faces(const Annulus& ring, mpm::Seeds<2>& seeds) {
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    const ReferenceDomains::Place& place = seeds.domains->places[p];
    for (const BoundaryPiece& piece : seeds.domains->shapes[place.shape].boundary) {
      const bool outer = piece.sweep > 0;
      if (piece.straight() || piece.radius != (outer ? ring.outer : ring.inner)) continue;
      const double middle = piece.from + 0.5 * piece.sweep, chord = 2 * piece.radius * std::sin(0.5 * piece.sweep);
      const Point out = place.turned({std::cos(middle), std::sin(middle)});
      mpm::SurfaceEdge edge{static_cast<std::uint32_t>(p), {}, {chord * out[0], chord * out[1]}, {}, {}};
      edge.X = {place.turned(piece.a), place.turned(piece.b)};
      edge.middle = {piece.radius * out[0], piece.radius * out[1]};
      if (!outer) std::swap(edge.X[0], edge.X[1]);  // counterclockwise
      edge.on_corners = !seeds.corners.empty();     // in the order in which polar_lattice gives them
      edge.corners = outer ? std::array<std::uint8_t, 2>{1, 3} : std::array<std::uint8_t, 2>{0, 2};
      seeds.surface.push_back(edge);
    }
  }
}

/// A box full of particles, every one stepped, with the edges that bear tractions.
mpm::Seeds<2> box_seeds(const Scene& scene) {
  const Box box = body_box(scene);
  const auto ends = ends_of(scene);
  const double h = scene.grid->spacing;
  const bool gauss = scene.body.lattice == Body::Lattice::gauss;
  const auto all = [](const Point&) { return mpm::Fate::stepped; };
  const auto make = gauss ? mpm::gauss_lattice : mpm::cartesian_lattice;
  mpm::Seeds<2> seeds = make(box.lower, box.upper, h, scene.body.per_cell, all);
  const mpm::GaussCells cells(h, scene.body.per_cell);
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    const Point X{seeds.X[0][p], seeds.X[1][p]};
    const Rectangle domain = gauss ? cells.rectangle_around(X) : around(X, seeds.half_size);
    add_surface(box, ends, domain, static_cast<std::uint32_t>(p), seeds.surface);
  }
  return seeds;
}

/// Of the body in its own frame, before any jitter.
mpm::Seeds<2> still_seeds_of(const Scene& scene) {
  const auto ring = ring_of(scene.motion);
  if (!ring) return box_seeds(scene);
  const Body& body = scene.body;
  if (body.domain == Body::Domain::ring) {
    const double h = scene.grid->spacing;
    if (body.lattice == Body::Lattice::polar) {
      return mpm::polar_lattice(*ring, h, body.per_cell, scene.method->basis == Method::Basis::cpdi2);
    }
    if (body.cut == Body::Cut::clipped) return mpm::clipped_lattice(*ring, h, body.per_cell);
  }
  return whole_cells(scene);
}

}  // namespace

mpm::Seeds<2> seeds_of(const Scene& scene) {
  mpm::Seeds<2> seeds = still_seeds_of(scene);
  if (std::holds_alternative<TwistingRing>(scene.motion)) add_faces(*ring_of(scene.motion), seeds);
  const bool jittered = scene.body.lattice == Body::Lattice::jittered;
  const bool turned = scene.frame && scene.frame->angle != 0;
  if ((jittered || turned) && !seeds.domains && is_averaged(scene) &&
      ring_of(scene.motion)) {  // the domains as they are before
    seeds.domains = std::make_shared<const ReferenceDomains>(mpm::rectangles_of(seeds, *ring_of(scene.motion)));
  }
  if (jittered) {
    std::function<bool(const Point&)> inside;
    if (scene.body.domain == Body::Domain::ring) {
      inside = [&](const Point& X) { return turn_of(scene.motion).moves({X[0], X[1], 0}); };
    }
    mpm::disturb(seeds, scene.body.jitter, static_cast<std::uint64_t>(scene.body.seed), inside);
  }
  if (turned) {
    mpm::turn(seeds, scene.frame->angle,
              scene.method->basis == Method::Basis::cpdi || scene.method->basis == Method::Basis::cpdi2);
  }
  return seeds;
}

}  // namespace assay::drivers
