// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/picture_frames.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "drivers/text/numbers.hpp"
#include "mpm/seeding/gauss_lattice.hpp"

namespace assay::drivers {

using mpm::Column;

ParticleFrame plane_frame(const Problem& problem, const mpm::State<2>& s, double t) {
  ParticleFrame frame;
  frame.caption = "t = " + problem.scene.units.text(t, "s", 4);
  const mpm::Seeds<2>& seeds = problem.setup.seeds;
  // F is that of the edges, or of the diagonals
  const bool convects = mpm::traits_of<2>(problem.setup.method.basis).convects;
  const double *x = s.column(Column::position, 0), *y = s.column(Column::position, 1);
  frame.x.assign(x, x + s.particles);
  frame.y.assign(y, y + s.particles);
  if (const auto& seen = problem.scene.frame) {  // pictures follow the body's centre
    for (double& at : frame.x) at -= seen->velocity.x() * t;
    for (double& at : frame.y) at -= seen->velocity.y() * t;
  }
  std::optional<mpm::GaussCells<2>> gauss;
  const Scene& scene = problem.scene;
  if (scene.body.lattice == Body::Lattice::gauss) gauss.emplace(scene.grid->spacing, scene.body.per_cell.in<2>());
  for (auto* edge : {&frame.r1x, &frame.r1y, &frame.r2x, &frame.r2y}) edge->resize(s.particles);
  for (std::size_t p = 0; p < s.particles; ++p) {
    std::array<double, 4> H{seeds.half_size[0], 0, 0, seeds.half_size[1]};
    if (!seeds.half_edges.empty()) H = seeds.half_edges[p];
    if (gauss) {  // the part of its cell that its weight stands for is not around it
      const std::array<double, 2> X = s.at<2>(Column::reference_position, p);
      const Rectangle r = gauss->box_around(X);
      H = {0.5 * (r.upper[0] - r.lower[0]), 0, 0, 0.5 * (r.upper[1] - r.lower[1])};
      frame.x[p] += 0.5 * (r.lower[0] + r.upper[0]) - X[0];
      frame.y[p] += 0.5 * (r.lower[1] + r.upper[1]) - X[1];
    }
    std::array<double, 4> F{1, 0, 0, 1};
    if (convects) F = s.at<4>(Column::deformation_gradient, p);
    frame.r1x[p] = F[0] * H[0] + F[1] * H[2];
    frame.r2x[p] = F[0] * H[1] + F[1] * H[3];
    frame.r1y[p] = F[2] * H[0] + F[3] * H[2];
    frame.r2y[p] = F[2] * H[1] + F[3] * H[3];
  }
  return frame;
}

Box plane_window(const PosedScene& problem) {
  const Scene& scene = problem.scene;
  if (!ring_of(scene.motion)) {
    Box box = swept_box(scene);
    const double margin = 0.05 * std::max(box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]);
    for (std::size_t d = 0; d < 2; ++d) box.lower[d] -= margin, box.upper[d] += margin;
    return box;
  }
  double reach = 1.1 * ring_of(scene.motion)->outer;
  if (scene.body.domain != Body::Domain::ring && scene.body.outside != Body::Outside::held) {
    for (const double x : {scene.body.lower[0], scene.body.upper[0]}) {
      for (const double y : {scene.body.lower[1], scene.body.upper[1]}) {
        reach = std::max(reach, 1.03 * (scene.frame ? std::hypot(x, y) : std::max(std::abs(x), std::abs(y))));
      }
    }
  }
  return {{-reach, -reach}, {reach, reach}};
}

void show_all(const std::vector<const ParticleFrame*>& frames, const Box& reach, ParticlePicture& picture) {
  constexpr double margin = 0.05, strip = 0.06, flattest = 0.45;
  Box box{reach.upper, reach.lower};
  for (const ParticleFrame* frame : frames) {
    for (const auto& polygon : frame->polygons)
      for (const Point& at : polygon) box.hold({at.x, at.y, 0});
  }
  const double far = margin * std::max(reach.upper[0] - reach.lower[0], reach.upper[1] - reach.lower[1]);
  for (std::size_t d = 0; d < 2; ++d) {
    box.lower[d] = std::max(box.lower[d], reach.lower[d] - far);
    box.upper[d] = std::min(box.upper[d], reach.upper[d] + far);
    if (!(box.upper[d] > box.lower[d])) box.lower[d] = reach.lower[d], box.upper[d] = reach.upper[d];
  }
  const double wide = std::max(box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]);
  if (!picture.space_axes.empty()) box.lower[0] -= strip * wide, box.lower[1] -= strip * wide;
  for (std::size_t d = 0; d < 2; ++d) {
    const double least = flattest * wide - (box.upper[d] - box.lower[d]);
    const double more = margin * wide + 0.5 * std::max(least, 0.0);
    picture.lower[d] = box.lower[d] - more, picture.upper[d] = box.upper[d] + more;
  }
}

}  // namespace assay::drivers
