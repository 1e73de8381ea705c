// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/seeds.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/scene/body_box.hpp"
#include "mpm/lattice.hpp"

namespace assay::drivers {

namespace {

/// A cell that reaches into the ring by less [relative to the radius] lies outside it.
constexpr double edge_rounding = 1e-12;

/// Whether a part of the lattice cell around X lies in the ring.
bool partly_inside(const Scene& scene, const std::array<double, 2>& X) {
  const auto& vortex = std::get<Vortex>(scene.motion);
  std::array<double, 2> nearest{}, farthest{};
  for (std::size_t d = 0; d < 2; ++d) {
    const double half = 0.5 * scene.grid->spacing / scene.body.per_cell[d];
    nearest[d] = std::max(0.0, std::abs(X[d]) - half);
    farthest[d] = std::abs(X[d]) + half;
  }
  return std::hypot(nearest[0], nearest[1]) < vortex.outer * (1 - edge_rounding) &&
         std::hypot(farthest[0], farthest[1]) > vortex.inner * (1 + edge_rounding);
}

/// Of the body in its own frame.
mpm::Seeds<2> own_seeds_of(const Scene& scene) {
  const auto& vortex = std::get<Vortex>(scene.motion);
  const Body& body = scene.body;
  const double h = scene.grid->spacing;
  if (body.domain == Body::Domain::ring) {
    const Annulus ring{vortex.inner, vortex.outer};
    if (body.lattice == Body::Lattice::polar) return mpm::polar_lattice(ring, h, body.per_cell);
    if (body.cut == Body::Cut::clipped) return mpm::clipped_lattice(ring, h, body.per_cell);
  }
  const bool averaged = scene.force.evaluation == ForceChoice::Evaluation::domain_average;
  const auto fate = [&](const std::array<double, 2>& X) {
    if (vortex.moves({X[0], X[1], 0})) return mpm::Fate::stepped;
    if (body.domain == Body::Domain::ring) return mpm::Fate::absent;
    if (body.outside == Body::Outside::free || (averaged && partly_inside(scene, X))) return mpm::Fate::stepped;
    return mpm::Fate::held;
  };
  const Box box = body_box(scene);
  return mpm::cartesian_lattice(box.lower, box.upper, h, body.per_cell, fate);
}

}  // namespace

mpm::Seeds<2> seeds_of(const Scene& scene) {
  mpm::Seeds<2> seeds = own_seeds_of(scene);
  if (!scene.frame || scene.frame->angle == 0) return seeds;
  const auto& vortex = std::get<Vortex>(scene.motion);
  if (!seeds.domains && scene.force.evaluation == ForceChoice::Evaluation::domain_average) {
    seeds.domains = std::make_shared<const ReferenceDomains>(mpm::rectangles_of(seeds, {vortex.inner, vortex.outer}));
  }
  mpm::turn(seeds, scene.frame->angle,
            scene.method->basis == Method::Basis::cpdi || scene.method->basis == Method::Basis::cpdi2);
  return seeds;
}

}  // namespace assay::drivers
