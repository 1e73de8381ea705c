// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/space_drawing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "drivers/text/numbers.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::drivers {

namespace {

using mpm::Column;

constexpr std::uint32_t no_particle = 0xffffffff;
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
  LatticePlaces(const std::vector<Vector3>& X, const Vector3& distance) : X_(&X), distance_(distance) {
    known_.reserve(X.size());
    for (std::size_t p = 0; p < X.size(); ++p) known_.emplace(key(p, {0, 0, 0}), static_cast<std::uint32_t>(p));
  }
  /// The neighbour a step away.
  std::uint32_t neighbour(std::size_t p, std::size_t d, int step) const {
    std::array<int, 3> steps{};
    steps[d] = step;
    const auto found = known_.find(key(p, steps));
    return found == known_.end() ? no_particle : found->second;
  }

 private:
  std::uint64_t key(std::size_t p, const std::array<int, 3>& steps) const {
    std::uint64_t all = 0;
    for (int d = 0; d < 3; ++d) {
      const double at = std::floor((*X_)[p](d) / distance_(d)) + steps[static_cast<std::size_t>(d)];
      all = all << 21 | (static_cast<std::uint64_t>(static_cast<std::int64_t>(at) + (1 << 20)) & 0x1fffff);
    }
    return all;
  }
  const std::vector<Vector3>* X_;
  Vector3 distance_;
  std::unordered_map<std::uint64_t, std::uint32_t> known_;
};

ColumnView columns_of(const mpm::State<3>& s) {
  return [&s](Column which, int component) { return s.column(which, component); };
}

Vector3 in_body(const Scene& scene, const Vector3& x, double t) {
  return scene.frame ? scene.frame->body_position(x, t) : x;
}

std::string caption_at(const Scene& scene, double t) { return "t = " + scene.units.text(t, "s", 4); }

}  // namespace

struct SpaceDrawing::Face {
  std::array<Vector3, 4> corners;  ///< along the axes of the view
  double depth = 0, shade = 0;
  std::uint32_t particle = 0;
};

SpaceDrawing::SpaceDrawing(const ProblemIn<3>& problem) : problem_(&problem), domains_(problem) {
  Scene still = problem.scene;  // in the body's own frame
  still.frame.reset();
  const BoxOf<3> box = body_box<3>(still);
  ends_ = swept_box<3>(still).corners();
  middle_ = 0.5 * (Vector3(box.lower.data()) + Vector3(box.upper.data()));
  const auto* vortex = still.motion.as<Vortex3d>();
  by_axis_ = vortex && vortex->vortices.empty();
  Vector3 normal = Vector3::UnitZ();
  if (by_axis_) middle_ = vortex->one.center, normal = unit_along(vortex->one.axis);
  const bool along_z = std::abs(normal.z()) > 0.999;
  const Vector3 first = along_z ? Vector3(Vector3::UnitX()) : Vector3(Vector3::UnitZ().cross(normal).normalized());
  axes_ << first.transpose(), normal.cross(first).transpose(), normal.transpose();

  const mpm::Seeds<3>& seeds = problem.setup.seeds;
  std::vector<Vector3> X(seeds.size());
  for (std::size_t p = 0; p < X.size(); ++p) {
    X[p] = {seeds.X[0][p], seeds.X[1][p], seeds.X[2][p]};
    if (problem.scene.frame) X[p] = problem.scene.frame->body_point(X[p]);
  }
  const auto per_cell = still.body.per_cell.in<3>();
  const double h = still.grid->spacing;
  const LatticePlaces places(X, {h / per_cell[0], h / per_cell[1], h / per_cell[2]});
  // The quarter towards whoever looks, above the middle.
  const Tensor seen = view_axes();
  neighbours_.resize(seeds.size());
  for (std::size_t p = 0; p < X.size(); ++p) {
    const Vector3 from = X[p] - middle_;
    neighbours_[p].left_out = from.z() > 0 && seen.row(2).dot(Vector3(from.x(), from.y(), 0)) > 0;
    for (std::size_t d = 0; d < 3; ++d) {
      neighbours_[p].above[d] = places.neighbour(p, d, 1);
      neighbours_[p].has_below[d] = places.neighbour(p, d, -1) != no_particle;
    }
  }
}

SpaceShapes SpaceDrawing::cut(const mpm::State<3>& s, double t) const {
  SpaceShapes shapes;
  shapes.frame.caption = caption_at(problem_->scene, t);
  const SpaceDomains::Now now = domains_.now(columns_of(s), true);
  const Scene& scene = problem_->scene;
  const Vector3 normal = axes_.row(2);
  const Tensor turned_back = scene.frame ? Tensor(scene.frame->rotation(t).transpose()) : Tensor(Tensor::Identity());
  // In the plane itself domains of a lattice have faces: it is looked at a little beside it.
  const double beside = 1e-3 * problem_->setup.seeds.half_size[0];
  constexpr double bent = 1.5;  // a domain whose corners move one by one reaches farther than its mean half edges
  for (std::size_t p = 0; p < s.particles; ++p) {
    const SpaceDomains::Shape shape = now.shape(p);
    const double off = normal.dot(in_body(scene, shape.middle, t) - middle_) - beside;
    const double reach = (normal.transpose() * turned_back * shape.half).cwiseAbs().sum();
    if (!(std::abs(off) < bent * reach)) continue;
    SpaceDomains::Corners at = now.corners(p);
    for (Vector3& corner : at) corner = axes_ * (in_body(scene, corner, t) - middle_) - Vector3(0, 0, beside);
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

/// Those that are turned to whoever looks.
std::vector<SpaceDrawing::Face> SpaceDrawing::faces_of(const mpm::State<3>& s, double t) const {
  const SpaceDomains::Now now = domains_.now(columns_of(s), true);
  const Tensor seen = view_axes();
  const Vector3 light = Vector3(-0.3, 0.5, 0.8).normalized();  // along the picture's axes
  constexpr double darkest = 0.3;
  std::vector<Face> faces;
  const auto add = [&](std::size_t p, std::size_t face_of_domain) {
    const SpaceDomains::Corners at = now.corners(p);
    Face face;
    face.particle = static_cast<std::uint32_t>(p);
    for (std::size_t k = 0; k < 4; ++k) {
      face.corners[k] = seen * (in_body(problem_->scene, at[corners_of_face[face_of_domain][k]], t) - middle_);
      face.depth += 0.25 * face.corners[k].z();
    }
    const Vector3 normal = (face.corners[2] - face.corners[0]).cross(face.corners[3] - face.corners[1]).normalized();
    if (!(normal.z() > 0)) return;
    face.shade = darkest * (1 - std::max(0.0, normal.dot(light)));
    faces.push_back(face);
  };
  // Beyond this part of its half edge from where it belongs beside a particle the next one is apart.
  constexpr double apart = 0.6;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Neighbours& own = neighbours_[p];
    const SpaceDomains::Shape shape = now.shape(p);
    const auto x = s.at<3>(Column::position, p);
    for (std::size_t d = 0; d < 3; ++d) {
      if (!own.left_out && !own.has_below[d]) add(p, 2 * d);
      const std::uint32_t next = own.above[d];
      if (next == no_particle) {
        if (!own.left_out) add(p, 2 * d + 1);
        continue;
      }
      const bool next_left_out = neighbours_[next].left_out;
      if (own.left_out && next_left_out) continue;
      const auto there = s.at<3>(Column::position, next);
      const Vector3 half = shape.half.col(static_cast<int>(d));
      const Vector3 off = Vector3(there.data()) - Vector3(x.data()) - 2 * half;
      if (own.left_out == next_left_out && off.squaredNorm() <= apart * apart * half.squaredNorm()) continue;
      if (!own.left_out) add(p, 2 * d + 1);
      if (!next_left_out) add(next, 2 * d);
    }
  }
  std::ranges::stable_sort(faces, {}, &Face::depth);
  return faces;
}

SpaceShapes SpaceDrawing::view(const mpm::State<3>& s, double t) const {
  SpaceShapes shapes;
  shapes.frame.caption = caption_at(problem_->scene, t);
  for (const Face& face : faces_of(s, t)) {
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

std::string SpaceDrawing::cut_words() const {
  return by_axis_ ? "across the axis of the vortex" : "at z = " + problem_->scene.units.text(middle_.z(), "m", 4);
}

std::vector<SpaceAxis> SpaceDrawing::axes_of_view() const {
  const Tensor seen = view_axes();
  std::vector<SpaceAxis> axes;
  for (const char* name : {"x", "y", "z"}) {
    const auto d = static_cast<int>(axes.size());
    axes.push_back({name, seen(0, d), seen(1, d)});
  }
  return axes;
}

Box SpaceDrawing::reach_of_view() const { return reach(view_axes()); }

Box SpaceDrawing::reach(const Tensor& axes) const {
  constexpr double far = std::numeric_limits<double>::infinity();
  Box box{{far, far}, {-far, -far}};
  for (const Vector3& end : ends_) box.hold(axes * (end - middle_));
  return box;
}

}  // namespace assay::drivers
