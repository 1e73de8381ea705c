// SPDX-License-Identifier: BSD-3-Clause
// The particles that a scene's body and lattice call for.
#include <algorithm>
#include <cmath>

#include "drivers/scene/body_box.hpp"
#include "drivers/simulation/body_faces.hpp"
#include "drivers/simulation/problem.hpp"
#include "mpm/seeding/gauss_lattice.hpp"
#include "mpm/seeding/lattice.hpp"

namespace assay::drivers {

namespace {

/// A cell that reaches into the ring by less [relative to the radius] lies outside it.
constexpr double edge_rounding = 1e-12;

/// Whether a part of a particle's domain lies in the ring.
bool partly_inside(const Annulus& ring, const Rectangle& domain) {
  std::array<double, 2> nearest{}, farthest{};
  for (std::size_t d = 0; d < 2; ++d) {
    nearest[d] = std::max({0.0, domain.lower[d], -domain.upper[d]});
    farthest[d] = std::max(-domain.lower[d], domain.upper[d]);
  }
  return std::hypot(nearest[0], nearest[1]) < ring.outer * (1 - edge_rounding) &&
         std::hypot(farthest[0], farthest[1]) > ring.inner * (1 + edge_rounding);
}

Rectangle around(const Point& X, const Point& half) {
  return {{X[0] - half[0], X[1] - half[1]}, {X[0] + half[0], X[1] + half[1]}};
}

bool is_averaged(const Scene& scene) { return scene.force.evaluation == ForceChoice::Evaluation::domain_average; }

/// Particles in the cells of the grid, whole.
mpm::Seeds<2> whole_cells(const Scene& scene) {
  const Annulus ring = *ring_of(scene.motion);
  const Body& body = scene.body;
  const double h = scene.grid->spacing;
  const bool gauss = body.lattice == Body::Lattice::gauss;
  const mpm::GaussCells cells(h, body.per_cell);
  const auto domain_of = [&](const std::array<double, 2>& X) {
    if (gauss) return cells.rectangle_around(X);
    return around(X, {0.5 * h / body.per_cell[0], 0.5 * h / body.per_cell[1]});
  };
  const auto fate = [&](const std::array<double, 2>& X) {
    if (ring.holds(std::hypot(X[0], X[1]))) return mpm::Fate::stepped;
    if (body.domain == Body::Domain::ring) return mpm::Fate::absent;
    if (body.outside == Body::Outside::free) return mpm::Fate::stepped;
    return is_averaged(scene) && partly_inside(ring, domain_of(X)) ? mpm::Fate::stepped : mpm::Fate::held;
  };
  const Box box = body_box(scene);
  if (!gauss) return mpm::cartesian_lattice(box.lower, box.upper, h, body.per_cell, fate);
  mpm::Seeds<2> seeds = mpm::gauss_lattice(box.lower, box.upper, h, body.per_cell, fate);
  if (is_averaged(scene)) {
    seeds.domains = std::make_shared<const ReferenceDomains>(mpm::gauss_domains(seeds, cells, ring));
  }
  return seeds;
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
    mpm::add_surface_edges({box.lower, box.upper}, ends, domain, static_cast<std::uint32_t>(p), seeds.surface);
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
      return mpm::polar_lattice(*ring, h, body.per_cell, mpm::traits_of<2>(scene.method->basis).moves_corners);
    }
    if (body.cut == Body::Cut::clipped) return mpm::clipped_lattice(*ring, h, body.per_cell);
  }
  return whole_cells(scene);
}

}  // namespace

mpm::Seeds<2> seeds_of(const Scene& scene) {
  mpm::Seeds<2> seeds = still_seeds_of(scene);
  if (ring_of(scene.motion) && !is_vortex(scene.motion)) mpm::add_face_arcs(*ring_of(scene.motion), seeds);
  const bool jittered = scene.body.lattice == Body::Lattice::jittered;
  const bool turned = scene.frame && scene.frame->angle != 0;
  if ((jittered || turned) && !seeds.domains && is_averaged(scene) &&
      ring_of(scene.motion)) {  // the domains as they are before
    seeds.domains = std::make_shared<const ReferenceDomains>(mpm::rectangles_of(seeds, *ring_of(scene.motion)));
  }
  if (jittered) {
    std::function<bool(const Point&)> inside;
    if (scene.body.domain == Body::Domain::ring) {
      inside = [ring = *ring_of(scene.motion)](const Point& X) { return ring.holds(std::hypot(X[0], X[1])); };
    }
    mpm::disturb(seeds, scene.body.jitter, static_cast<std::uint64_t>(scene.body.seed), inside);
  }
  if (turned) mpm::turn(seeds, scene.frame->angle, mpm::traits_of<2>(scene.method->basis).convects);
  return seeds;
}

}  // namespace assay::drivers
