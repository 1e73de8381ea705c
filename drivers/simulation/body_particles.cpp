// SPDX-License-Identifier: BSD-3-Clause
// The particles that a scene's body and lattice call for.
#include <algorithm>
#include <cmath>
#include <optional>

#include "drivers/scene/body_box.hpp"
#include "drivers/simulation/body_faces.hpp"
#include "drivers/simulation/problem.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
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

template <int Dim>
mpm::BoxOfAxes<Dim> around(const std::array<double, Dim>& X, const std::array<double, Dim>& half) {
  mpm::BoxOfAxes<Dim> box;
  for (std::size_t d = 0; d < Dim; ++d) box.lower[d] = X[d] - half[d], box.upper[d] = X[d] + half[d];
  return box;
}

bool is_averaged(const Scene& scene) { return scene.force.evaluation == ForceChoice::Evaluation::domain_average; }

/// The edges or faces of a box that bear tractions.
template <int Dim>
void add_faces(const Scene& scene, const auto& domain_of, mpm::Seeds<Dim>& seeds) {
  const auto box = body_box<Dim>(scene);
  const auto ends = ends_of<Dim>(scene);
  const mpm::BoxOfAxes<Dim> body{box.lower, box.upper};
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    std::array<double, Dim> X;
    for (std::size_t d = 0; d < Dim; ++d) X[d] = seeds.X[d][p];
    mpm::add_surface_edges(body, ends, domain_of(X), static_cast<std::uint32_t>(p), seeds.surface);
  }
}

/// Particles in the cells of the grid, whole.
mpm::Seeds<2> whole_cells(const Scene& scene) {
  const Annulus ring = *ring_of(scene.motion);
  const Body& body = scene.body;
  const double h = scene.grid->spacing;
  const bool gauss = body.lattice == Body::Lattice::gauss;
  const mpm::GaussCells<2> cells(h, body.per_cell.in<2>());
  const auto domain_of = [&](const std::array<double, 2>& X) {
    if (gauss) return cells.box_around(X);
    return around<2>(X, {0.5 * h / body.per_cell[0], 0.5 * h / body.per_cell[1]});
  };
  const auto fate = [&](const std::array<double, 2>& X) {
    if (ring.holds(std::hypot(X[0], X[1]))) return mpm::Fate::stepped;
    if (body.domain == Body::Domain::ring) return mpm::Fate::absent;
    if (body.outside == Body::Outside::free) return mpm::Fate::stepped;
    return is_averaged(scene) && partly_inside(ring, domain_of(X)) ? mpm::Fate::stepped : mpm::Fate::held;
  };
  const Box box = body_box(scene);
  const auto per_cell = body.per_cell.in<2>();
  mpm::Seeds<2> seeds = gauss ? mpm::gauss_lattice(box.lower, box.upper, h, per_cell, fate)
                              : mpm::cartesian_lattice(box.lower, box.upper, h, per_cell, fate);
  if (body.domain != Body::Domain::ring && scene.bears_tractions()) add_faces<2>(scene, domain_of, seeds);
  if (gauss && is_averaged(scene)) {
    seeds.domains = std::make_shared<const ReferenceDomains>(mpm::gauss_domains(seeds, cells, ring));
  }
  return seeds;
}

/// A box full of particles, every one stepped, with the edges or faces that bear tractions.
template <int Dim>
mpm::Seeds<Dim> box_seeds(const Scene& scene) {
  const auto box = body_box<Dim>(scene);
  const double h = scene.grid->spacing;
  const bool gauss = scene.body.lattice == Body::Lattice::gauss;
  const auto per_cell = scene.body.per_cell.in<Dim>();
  const auto all = [](const auto&) { return mpm::Fate::stepped; };
  mpm::Seeds<Dim> seeds = gauss ? mpm::gauss_lattice(box.lower, box.upper, h, per_cell, all)
                                : mpm::cartesian_lattice(box.lower, box.upper, h, per_cell, all);
  const mpm::GaussCells<Dim> cells(h, per_cell);
  const auto domain_of = [&](const std::array<double, Dim>& X) {
    return gauss ? cells.box_around(X) : around<Dim>(X, seeds.half_size);
  };
  add_faces<Dim>(scene, domain_of, seeds);
  return seeds;
}

/// A vortex in space, alone or in a box, or one in the plane in a box: whole cells whose middle, or with an averaged
/// force some corner, moves; and those around it as the scene says.
mpm::Seeds<3> vortex_seeds(const Scene& scene) {
  const Body& body = scene.body;
  const auto* vortex = scene.motion.as<Vortex3d>();
  const auto finder = vortex ? std::optional<VortexFinder>(*vortex) : std::nullopt;
  const auto ring = ring_of(scene.motion);
  const auto moves = [&](const Vector3& X) {
    return finder ? finder->place(X).has_value() : ring->holds(std::hypot(X.x(), X.y()));
  };
  const double h = scene.grid->spacing;
  const auto per_cell = body.per_cell.in<3>();
  const bool gauss = body.lattice == Body::Lattice::gauss;
  const mpm::GaussCells<3> cells(h, per_cell);
  const std::array<double, 3> half{0.5 * h / per_cell[0], 0.5 * h / per_cell[1], 0.5 * h / per_cell[2]};
  const auto domain_of = [&](const std::array<double, 3>& X) {
    return gauss ? cells.box_around(X) : around<3>(X, half);
  };
  const auto partly_moves = [&](const std::array<double, 3>& X) {
    const auto domain = domain_of(X);
    const auto corners = BoxOf<3>{domain.lower, domain.upper}.corners();
    return std::ranges::any_of(corners, moves);
  };
  const auto fate = [&](const std::array<double, 3>& X) {
    if (moves({X[0], X[1], X[2]})) return mpm::Fate::stepped;
    if (body.is_vortex_alone()) return mpm::Fate::absent;
    if (body.outside == Body::Outside::free) return mpm::Fate::stepped;
    return is_averaged(scene) && partly_moves(X) ? mpm::Fate::stepped : mpm::Fate::held;
  };
  const auto box = body_box<3>(scene);
  mpm::Seeds<3> seeds = gauss ? mpm::gauss_lattice(box.lower, box.upper, h, per_cell, fate)
                              : mpm::cartesian_lattice(box.lower, box.upper, h, per_cell, fate);
  if (scene.bears_tractions()) add_faces<3>(scene, domain_of, seeds);
  if (!gauss || !is_averaged(scene)) return seeds;
  std::vector<std::array<Vector3, 8>> domains;
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    const auto domain = domain_of({seeds.X[0][p], seeds.X[1][p], seeds.X[2][p]});
    const Vector3 lower(domain.lower.data()), upper(domain.upper.data());
    domains.push_back(boxes_around(std::array{Vector3(0.5 * (lower + upper))}, 0.5 * (upper - lower)).front());
  }
  seeds.domains = std::make_shared<const Hexahedra>(domains);
  return seeds;
}

/// Of the body in its own frame, before any jitter.
mpm::Seeds<2> still_seeds_of(const Scene& scene) {
  const auto ring = ring_of(scene.motion);
  if (!ring) return box_seeds<2>(scene);
  const Body& body = scene.body;
  if (body.domain == Body::Domain::ring) {
    const double h = scene.grid->spacing;
    if (body.lattice == Body::Lattice::polar) {
      return mpm::polar_lattice(*ring, h, body.per_cell.in<2>(), mpm::traits_of<2>(scene.method->basis).moves_corners);
    }
    if (body.cut == Body::Cut::clipped) return mpm::clipped_lattice(*ring, h, body.per_cell.in<2>());
  }
  return whole_cells(scene);
}

}  // namespace

namespace {

void disturb_as(const Scene& scene, auto& seeds, const auto& inside) {
  mpm::disturb(seeds, scene.body.jitter, static_cast<std::uint64_t>(scene.body.seed), inside);
}

mpm::Seeds<3> seeds_in_space(const Scene& scene) {
  const auto* vortex = scene.motion.as<Vortex3d>();
  mpm::Seeds<3> seeds = vortex || ring_of(scene.motion) ? vortex_seeds(scene) : box_seeds<3>(scene);
  const bool jittered = scene.body.lattice == Body::Lattice::jittered;
  const bool turned = scene.frame && scene.frame->angle != 0;
  if ((jittered || turned) && !seeds.domains && is_averaged(scene)) {  // the domains as they are before
    std::vector<Vector3> X;
    for (std::size_t p = 0; p < seeds.size(); ++p) X.emplace_back(seeds.X[0][p], seeds.X[1][p], seeds.X[2][p]);
    seeds.domains = std::make_shared<const Hexahedra>(boxes_around(X, Vector3(seeds.half_size.data())));
  }
  if (jittered) {
    std::function<bool(const std::array<double, 3>&)> inside;
    if (scene.body.is_vortex_alone())
      inside = [finder = VortexFinder(*vortex)](const auto& X) { return finder.place({X[0], X[1], X[2]}).has_value(); };
    disturb_as(scene, seeds, inside);
  }
  if (turned) mpm::turn(seeds, scene.frame->rotation(0), mpm::traits_of<3>(scene.method->basis).convects);
  return seeds;
}

mpm::Seeds<2> seeds_in_plane(const Scene& scene) {
  mpm::Seeds<2> seeds = still_seeds_of(scene);
  if (ring_of(scene.motion) && scene.body.domain == Body::Domain::ring && scene.bears_tractions())
    mpm::add_face_arcs(*ring_of(scene.motion), seeds);
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
    disturb_as(scene, seeds, inside);
  }
  if (turned) mpm::turn(seeds, scene.frame->angle, mpm::traits_of<2>(scene.method->basis).convects);
  return seeds;
}

}  // namespace

template <>
mpm::Seeds<2> seeds_of<2>(const Scene& scene) {
  return seeds_in_plane(scene);
}
template <>
mpm::Seeds<3> seeds_of<3>(const Scene& scene) {
  return seeds_in_space(scene);
}

}  // namespace assay::drivers
