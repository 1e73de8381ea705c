// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/space_drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/response_source.hpp"
#include "mpm/simulation.hpp"

namespace assay::drivers::test_space_drawing {
namespace {

using mpm::Column;

constexpr int across = 6;  ///< particles along each edge of the cube [-0.75, 0.75]^3
constexpr double area = 1.5 * 1.5;

/// A cube that nothing has moved yet, and what pictures show of it.
struct Drawn {
  explicit Drawn(const std::string& more, const std::string& basis = "cpdi")
      : problem(assemble<3>(
            scene_from_text(
                "dimension: 3\nmotion: {type: rigid}\ngrid: {spacing: 0.5}\n"
                "material: {adapter: neo_hookean, parameters: {E: 1000, nu: 0.3}, density: 1000}\n"
                "body: {domain: box, lower: [-0.75, -0.75, -0.75], upper: [0.75, 0.75, 0.75], per_cell: [2, 2, 2]}\n"
                "method: {basis: " +
                    basis + ", transfer: flip}\n" + more,
                "cube.yaml", {}),
            1)),
        simulation(setup_of(problem)),
        drawing(problem) {}

  static mpm::Setup<3> setup_of(const ProblemIn<3>& problem) {
    mpm::Setup<3> setup = problem.setup;
    if (problem.compared) setup.exact = exact_solution_of(problem.scene, problem.material, problem.scene.time.end);
    return setup;
  }

  mpm::State<3>& state() { return simulation.state(); }
  Vector3 reference(std::size_t p) {
    const auto X = state().at<3>(Column::reference_position, p);
    return {X[0], X[1], X[2]};
  }
  void put(std::size_t p, const Vector3& x, const Tensor& F) {
    for (int d = 0; d < 3; ++d) state().column(Column::position, d)[p] = x(d);
    for (int c = 0; c < 9; ++c) state().column(Column::deformation_gradient, c)[p] = F(c / 3, c % 3);
  }
  /// x = F X + c for all particles, or for those that are asked for.
  void move(const Tensor& F, const Vector3& c, const std::function<bool(const Vector3&)>& which = {}) {
    for (std::size_t p = 0; p < state().particles; ++p) {
      if (!which || which(reference(p))) put(p, F * reference(p) + c, F);
    }
  }

  ProblemIn<3> problem;
  mpm::Simulation<3> simulation;
  SpaceDrawing drawing;
};

double area_of(const std::vector<Point>& polygon) {
  double twice = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * std::abs(twice);
}

double area_of(const SpaceShapes& shapes) {
  double sum = 0;
  for (const auto& polygon : shapes.frame.polygons) sum += area_of(polygon);
  return sum;
}

Tensor sheared() {
  Tensor F;
  F << 1.2, 0.3, 0.1, 0, 0.9, -0.2, 0.15, 0, 1.1;
  return F;
}

/// Without gaps and without anything twice.
TEST(SpaceDrawing, a_cut_has_the_area_of_the_body_in_its_plane) {
  for (const char* basis : {"cpdi", "cpdi2", "bspline2", "ugimp"}) {
    Drawn cube("", basis);
    const SpaceShapes cut = cube.drawing.cut(cube.state(), 0);
    EXPECT_EQ(cut.particles.size(), std::size_t{across} * across) << basis;
    EXPECT_NEAR(area_of(cut), area, 1e-12) << basis;
  }
}

/// F has no 31 and 32 here, so that the plane of the cut is a plane of the lattice.
TEST(SpaceDrawing, a_deformed_body_is_cut_where_it_is_now) {
  Tensor F = sheared();
  F(2, 0) = 0;
  for (const char* basis : {"cpdi", "bspline2"}) {
    Drawn cube("", basis);
    cube.move(F, Vector3::Zero());
    const SpaceShapes cut = cube.drawing.cut(cube.state(), 0);
    EXPECT_NEAR(area_of(cut), area * (F(0, 0) * F(1, 1) - F(0, 1) * F(1, 0)), 1e-12) << basis;
  }
  F(2, 2) = 1;
  Drawn rigid_boxes("", "ugimp");
  rigid_boxes.move(F, Vector3::Zero());
  EXPECT_NEAR(area_of(rigid_boxes.drawing.cut(rigid_boxes.state(), 0)), area, 1e-12) << "uGIMP's boxes do not deform";
}

bool is_in_quarter(const Vector3& X) { return X.z() > 0 && X.x() - 1.4 * X.y() > 0; }

/// Along each of the three axes each row of particles, or what the quarter leaves of it, ends once on the side that is
/// seen.
TEST(SpaceDrawing, a_view_shows_each_face_of_the_surface_once) {
  Drawn cube("");
  std::set<std::array<long, 3>> rows;  // axis, and the place across it
  for (std::size_t p = 0; p < cube.state().particles; ++p) {
    const Vector3 X = cube.reference(p);
    for (int d = 0; d < 3 && !is_in_quarter(X); ++d)
      rows.insert({d, std::lround(8 * X((d + 1) % 3)), std::lround(8 * X((d + 2) % 3))});
  }
  const SpaceShapes view = cube.drawing.view(cube.state(), 0);
  EXPECT_EQ(rows.size(), std::size_t{3} * across * across - 3) << "three rows lie in the quarter";
  EXPECT_EQ(view.particles.size(), rows.size());
  for (const std::uint32_t p : view.particles) {
    const Vector3 X = cube.reference(p);
    EXPECT_FALSE(is_in_quarter(X)) << "of the quarter that is left out: " << X.transpose();
  }
  const std::set<double> shades(view.frame.shade.begin(), view.frame.shade.end());
  EXPECT_LT(*shades.begin(), 0.1) << "the top is bright";
  EXPECT_GT(*shades.rbegin(), 0.2) << "a side is not";
}

TEST(SpaceDrawing, particles_that_have_come_apart_show_their_faces) {
  Drawn cube("");
  const std::size_t whole = cube.drawing.view(cube.state(), 0).particles.size();
  const auto upper = [](const Vector3& X) { return X.z() > 0.5; };
  cube.move(Tensor::Identity(), Vector3(0, 0, 0.05), upper);
  EXPECT_EQ(cube.drawing.view(cube.state(), 0).particles.size(), whole) << "a fifth of a particle is no gap";
  cube.move(Tensor::Identity(), Vector3(0, 0, 1), upper);
  const std::size_t all = across * across;  // tops of the layer beneath
  std::size_t left_out = 0;
  for (std::size_t p = 0; p < cube.state().particles; ++p) {
    const Vector3 X = cube.reference(p);
    left_out += X.z() < 0.25 && is_in_quarter(X);
  }
  EXPECT_EQ(cube.drawing.view(cube.state(), 0).particles.size(), whole + all - left_out);
}

TEST(SpaceDrawing, a_lost_particle_is_drawn_and_one_that_is_nowhere_is_not) {
  Drawn cube("");
  const std::size_t whole = cube.drawing.view(cube.state(), 0).particles.size();
  std::size_t inner = 0;  // one inside, beneath the quarter
  while ((cube.reference(inner) - Vector3(-0.375, 0.375, -0.375)).norm() > 1e-9) ++inner;
  cube.put(inner, {5, 5, 5}, Tensor::Identity());
  EXPECT_EQ(cube.drawing.view(cube.state(), 0).particles.size(), whole + 6)
      << "its own three, and three around its hole";
  cube.put(inner, {NAN, 0, 0}, Tensor::Identity());
  EXPECT_EQ(cube.drawing.view(cube.state(), 0).particles.size(), whole + 3);
  EXPECT_NEAR(area_of(cube.drawing.cut(cube.state(), 0)), area, 1e-12);
}

/// A frame turns, spins and flies; its pictures are those of the body's own frame.
TEST(SpaceDrawing, pictures_follow_a_frame) {
  const double t = 0.7;
  for (const char* basis : {"cpdi", "bspline2"}) {
    Drawn own("", basis),
        seen("frame: {angle: 0.4, spin: 1.3, velocity: [0.4, -0.2, 0.3], axis: [-2, 1, 0.5]}\n", basis);
    const Frame& frame = *seen.problem.scene.frame;
    const Tensor F = sheared(), F_seen = frame.rotation(t) * F * frame.rotation(0).transpose();
    own.move(F, Vector3::Zero());
    seen.move(F_seen, frame.velocity * t);
    for (const auto of : {&SpaceDrawing::cut, &SpaceDrawing::view}) {
      const SpaceShapes a = (own.drawing.*of)(own.state(), t), b = (seen.drawing.*of)(seen.state(), t);
      ASSERT_EQ(a.particles.size(), b.particles.size()) << basis;
      EXPECT_NEAR(area_of(a), area_of(b), 1e-12) << basis;
    }
  }
}

TEST(SpaceDrawing, parts_around_gauss_points_tile_the_body) {
  const ProblemIn<3> gauss =
      assemble<3>(scene_from_text("dimension: 3\nmotion: {type: rigid}\ngrid: {spacing: 0.5}\n"
                                  "material: {adapter: neo_hookean, parameters: {E: 1000, nu: 0.3}, density: 1000}\n"
                                  "body: {domain: box, lower: [-1, -1, -1], upper: [1, 1, 1], "
                                  "per_cell: [3, 3, 3], lattice: gauss}\n"
                                  "method: {basis: bspline2, formulation: total, transfer: flip}\n",
                                  "gauss.yaml", {}),
                  1);
  const mpm::Simulation<3> simulation(Drawn::setup_of(gauss));
  EXPECT_NEAR(area_of(SpaceDrawing(gauss).cut(simulation.state(), 0)), 4, 1e-12);
}

TEST(SpaceDrawing, says_where_it_cuts_and_how_it_looks) {
  const Drawn cube("");
  EXPECT_EQ(cube.drawing.cut_words(), "at z = 0 m");
  EXPECT_EQ(cube.drawing.labels(), (std::array<std::string, 2>{"x", "y"}));
  const auto axes = cube.drawing.axes_of_view();
  ASSERT_EQ(axes.size(), 3U);
  EXPECT_GT(axes[0].right, 0.5);
  EXPECT_GT(axes[1].up, 0.2);
  EXPECT_NEAR(axes[2].right, 0, 1e-12);
  EXPECT_GT(axes[2].up, 0.8);
  const Box reach = cube.drawing.reach_of_view();
  EXPECT_NEAR(reach.upper[0], 0.75 * (std::abs(axes[0].right) + std::abs(axes[1].right)), 1e-12);
}

}  // namespace
}  // namespace assay::drivers::test_space_drawing
