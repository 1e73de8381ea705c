// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/space_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "drivers/scene/body_box.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::drivers {

namespace {

using mpm::Column;

constexpr std::uint8_t left_out = 0xff;
/// The corners of face 2 d + side of a domain, around it.
constexpr std::size_t corners_of_face[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                               {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
constexpr std::size_t edges_of_domain[12][2] = {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3},
                                                {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};

/// Rows: to the right, upwards, towards whoever looks, of a picture from aside and above.
Tensor view_axes() {
  const Vector3 towards = Vector3(1, -1.4, 0.9).normalized(), right = Vector3(1.4, 1, 0).normalized();
  Tensor axes;
  axes << right.transpose(), towards.cross(right).transpose(), towards.transpose();
  return axes;
}

/// Particles by their place on the lattice.
class LatticePlaces {
 public:
  explicit LatticePlaces(const mpm::Seeds<3>& seeds) : seeds_(&seeds) {
    for (std::size_t p = 0; p < seeds.size(); ++p) known_.emplace(key(p, {0, 0, 0}), static_cast<std::uint32_t>(p));
  }
  /// The neighbour a step away; none where there is none.
  std::optional<std::uint32_t> neighbour(std::size_t p, std::size_t d, int step) const {
    std::array<int, 3> steps{};
    steps[d] = step;
    const auto found = known_.find(key(p, steps));
    return found == known_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  std::uint64_t key(std::size_t p, const std::array<int, 3>& steps) const {
    std::uint64_t all = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      const double at = std::floor(seeds_->X[d][p] / (2 * seeds_->half_size[d])) + steps[d];
      all = all << 21 | (static_cast<std::uint64_t>(static_cast<std::int64_t>(at) + (1 << 20)) & 0x1fffff);
    }
    return all;
  }
  const mpm::Seeds<3>* seeds_;
  std::unordered_map<std::uint64_t, std::uint32_t> known_;
};

}  // namespace

SpaceDrawing::SpaceDrawing(const ProblemIn<3>& problem) : problem_(&problem) {
  const Scene& scene = problem.scene;
  const BoxOf<3> box = body_box<3>(scene), swept = swept_box<3>(scene);
  middle_ = 0.5 * (Vector3(box.lower.data()) + Vector3(box.upper.data()));
  const auto* vortex = scene.motion.as<Vortex3d>();
  by_axis_ = vortex && vortex->vortices.empty();
  Vector3 normal = Vector3::UnitZ();
  if (by_axis_) middle_ = vortex->one.center, normal = unit_along(vortex->one.axis);
  if (scene.frame) middle_ = scene.frame->rotation(0) * middle_, normal = scene.frame->rotation(0) * normal;
  const bool along_z = std::abs(normal.z()) > 0.999;
  const Vector3 first = along_z ? Vector3(Vector3::UnitX()) : Vector3(Vector3::UnitZ().cross(normal).normalized());
  axes_ << first.transpose(), normal.cross(first).transpose(), normal.transpose();
  for (const Vector3& corner : swept.corners()) reach_ = std::max(reach_, (corner - middle_).cwiseAbs().maxCoeff());
  const mpm::Seeds<3>& seeds = problem.setup.seeds;
  const bool is_lattice = !scene.frame || scene.frame->angle == 0;
  const LatticePlaces places(seeds);
  // The quarter towards whoever looks, above the middle.
  const Tensor seen = view_axes();
  const auto in_quarter = [&](std::size_t p) {
    const Vector3 from = reference_of(p) - middle_;
    return from.z() > 0 && seen.row(2).dot(Vector3(from.x(), from.y(), 0)) > 0;
  };
  open_.assign(seeds.size(), 0), inner_.assign(seeds.size(), 0);
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    if (in_quarter(p)) inner_[p] = left_out;
    for (std::size_t face = 0; face < 6; ++face) {
      const auto next = is_lattice ? places.neighbour(p, face / 2, face % 2 == 0 ? -1 : 1) : std::nullopt;
      const auto bit = static_cast<std::uint8_t>(1u << face);
      if (!next) open_[p] |= bit;
      if (next && inner_[p] != left_out && in_quarter(*next)) inner_[p] |= bit;
    }
  }
}

Vector3 SpaceDrawing::reference_of(std::size_t p) const {
  const mpm::Seeds<3>& seeds = problem_->setup.seeds;
  return {seeds.X[0][p], seeds.X[1][p], seeds.X[2][p]};
}

/// As the picture follows the body's flight.
SpaceDrawing::Corners SpaceDrawing::corners_of(const mpm::State<3>& s, std::size_t p, double t) const {
  Corners corners;
  const auto& frame = problem_->scene.frame;
  const Vector3 flown = frame ? Vector3(frame->velocity * t) : Vector3(Vector3::Zero());
  if (s.has(Column::corners)) {
    for (int c = 0; c < 8; ++c) {
      for (int d = 0; d < 3; ++d)
        corners[static_cast<std::size_t>(c)](d) = s.column(Column::corners, 3 * c + d)[p] - flown(d);
    }
    return corners;
  }
  const mpm::Seeds<3>& seeds = problem_->setup.seeds;
  Tensor half = Vector3(seeds.half_size.data()).asDiagonal();
  if (!seeds.half_edges.empty()) half = tensor_of(seeds.half_edges[p].data());
  const auto F = s.at<9>(Column::deformation_gradient, p);
  half = tensor_of(F.data()) * half;
  const auto x = s.at<3>(Column::position, p);
  for (std::size_t c = 0; c < 8; ++c) {
    const Vector3 sign(c & 1 ? 1 : -1, c & 2 ? 1 : -1, c & 4 ? 1 : -1);
    corners[c] = Vector3(x.data()) - flown + half * sign;
  }
  return corners;
}

SpaceShapes SpaceDrawing::cut(const mpm::State<3>& s, double t) const {
  SpaceShapes shapes;
  shapes.frame.caption = "t = " + rounded_text(t, 4) + " s";
  // In the plane itself domains of a lattice have faces: it is looked at a little beside it.
  const double beside = 1e-3 * problem_->setup.seeds.half_size[0];
  std::vector<std::pair<double, Point>> around;
  for (std::size_t p = 0; p < s.particles; ++p) {
    Corners at = corners_of(s, p, t);
    for (Vector3& corner : at) corner = axes_ * (corner - middle_) - Vector3(0, 0, beside);
    const auto [lowest, highest] =
        std::minmax_element(at.begin(), at.end(), [](const auto& a, const auto& b) { return a.z() < b.z(); });
    if (!(lowest->z() < 0 && highest->z() > 0)) continue;
    std::vector<Point> polygon;
    Point centre;
    for (const auto& [from, to] : edges_of_domain) {
      const Vector3 &a = at[from], &b = at[to];
      if ((a.z() < 0) == (b.z() < 0)) continue;
      const Vector3 x = a + a.z() / (a.z() - b.z()) * (b - a);
      polygon.push_back({x.x(), x.y()});
      centre.x += x.x(), centre.y += x.y();
    }
    if (polygon.size() < 3) continue;
    centre.x /= static_cast<double>(polygon.size()), centre.y /= static_cast<double>(polygon.size());
    std::ranges::sort(polygon, {}, [&](const Point& x) { return std::atan2(x.y - centre.y, x.x - centre.x); });
    shapes.frame.polygons.push_back(std::move(polygon));
    shapes.particles.push_back(static_cast<std::uint32_t>(p));
  }
  return shapes;
}

SpaceShapes SpaceDrawing::view(const mpm::State<3>& s, double t) const {
  struct Face {
    std::array<Vector3, 4> corners;
    double depth, shade;
    std::uint32_t particle;
  };
  const Tensor seen = view_axes();
  const Vector3 light = Vector3(-0.3, 0.5, 0.8).normalized();  // along the picture's axes
  std::vector<Face> faces;
  for (std::size_t p = 0; p < s.particles; ++p) {
    if (inner_[p] == left_out || !(open_[p] | inner_[p])) continue;
    const Corners at = corners_of(s, p, t);
    for (std::size_t f = 0; f < 6; ++f) {
      if (!((open_[p] | inner_[p]) >> f & 1)) continue;
      Face face{{}, 0, 0, static_cast<std::uint32_t>(p)};
      for (std::size_t k = 0; k < 4; ++k) {
        face.corners[k] = seen * (at[corners_of_face[f][k]] - middle_);
        face.depth += 0.25 * face.corners[k].z();
      }
      const Vector3 normal = (face.corners[2] - face.corners[0]).cross(face.corners[3] - face.corners[1]).normalized();
      if (!(normal.z() > 0)) continue;  // turned away
      face.shade = 0.45 * (1 - std::max(0.0, normal.dot(light)));
      faces.push_back(face);
    }
  }
  std::ranges::stable_sort(faces, {}, &Face::depth);
  SpaceShapes shapes;
  shapes.frame.caption = "t = " + rounded_text(t, 4) + " s";
  for (const Face& face : faces) {
    std::vector<Point> polygon;
    for (const Vector3& x : face.corners) polygon.push_back({x.x(), x.y()});
    shapes.frame.polygons.push_back(std::move(polygon));
    shapes.frame.shade.push_back(face.shade);
    shapes.particles.push_back(face.particle);
  }
  return shapes;
}

std::array<std::string, 2> SpaceDrawing::labels() const {
  if (!by_axis_ || std::abs(axes_.row(2).z()) > 0.999) return {"x", "y"};
  return {"across the axis", "across it, upwards"};
}

}  // namespace assay::drivers
