// SPDX-License-Identifier: BSD-3-Clause
// Plane vortices with their exact body force, and random points to compare at.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "drivers/export/force_pieces.hpp"
#include "drivers/export/force_sources.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/response_source.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers {

struct VortexForces {
  Scene scene;
  ExactSolutionPtr exact;

  explicit VortexForces(const std::string& text) {
    scene = scene_from_text(text, "scene.yaml");
    std::string library;
    const auto material = material_of(scene, library);
    exact = exact_solution_of_points(scene, material, scene.time.end);
  }
  ForcePieces pieces(double tolerance = 1e-6) const {
    ForceFit fit;
    fit.end = scene.time.end, fit.tolerance = tolerance, fit.quasi_static = scene.force.quasi_static;
    return fit_force(*exact, fit);
  }
};

inline const std::string smooth_vortex = R"(
motion:   {type: vortex, inner: 0.75, outer: 1.25, period: 1.0, profile_power: 4, amplitude: {type: sine, peak: 0.25}}
material: {adapter: neo_hookean, parameters: {E: 1.0e+3, nu: 0.3}, density: 1000}
)";

/// Memory, an amplitude of another form, and a time that goes on beyond the period.
inline const std::string viscous_vortex = R"(
motion:   {type: vortex, inner: 0.5, outer: 1.4, period: 0.8, profile_power: 3,
           amplitude: {type: one_minus_cosine, peak: 0.7}}
material: {adapter: zener, parameters: {E: 1.0e+3, nu: 0.3, viscous_ratio: 1.0, relaxation_time: 0.2}, density: 900}
time:     {end: 1.1}
)";

inline const std::string static_ramp = R"(
motion:   {type: vortex, inner: 0.25, outer: 1.25, period: 1.0, profile_power: 4, amplitude: {type: ramp, peak: 0.4}}
material: {adapter: mooney_rivlin, parameters: {c10: 120, c01: 60, bulk_modulus: 900}, density: 1000}
force:    {quasi_static: true}
time:     {end: 1.5}
)";

/// A point of the body at a time, where it is, and b there.
struct ForcePoint {
  double X, Y, t, x, y, bx, by;
};

/// In and around the ring, at random times; the first ones at the edges, at the axis and at the ends of time.
inline std::vector<ForcePoint> force_points(const VortexForces& vortex, int count) {
  const Annulus ring = vortex.scene.motion->polar()->ring();
  std::mt19937 random(17);
  std::uniform_real_distribution<double> radius(0.8 * ring.inner, 1.1 * ring.outer), angle(-3.1, 3.1),
      time(0, vortex.scene.time.end);
  std::vector<ForcePoint> points;
  for (int k = 0; k < count; ++k) {
    double R = radius(random), t = time(random);
    const double Theta = angle(random);
    if (k < 3) R = std::array{0.0, 0.5 * ring.inner, 1.05 * ring.outer}[static_cast<std::size_t>(k)];
    if (k >= 3 && k < 5) t = k == 3 ? 0 : vortex.scene.time.end;
    const Vector3 X(R * std::cos(Theta), R * std::sin(Theta), 0);
    const ExactPoint exact = vortex.exact->at(X, t);
    const Vector3 b = vortex.scene.force.quasi_static ? exact.stress.static_force : exact.stress.body_force;
    points.push_back({X.x(), X.y(), t, exact.state.x.x(), exact.state.x.y(), b.x(), b.y()});
  }
  return points;
}

/// Of the tolerance: random points lie between those that were measured.
inline constexpr double tolerance_share = 1.5;

inline void expect_runs(const ScratchFolder& scratch, const std::string& command) {
  const std::string in_folder = "cd '" + scratch / "" + "' && (" + command + ") > said 2>&1";
  ASSERT_EQ(std::system(in_folder.c_str()), 0) << command << "\n" << bytes_of(scratch / "said");
}

/// "x y t" in lines.
inline std::string point_lines(const std::vector<ForcePoint>& points, ForceCoordinates at) {
  std::string lines;
  for (const ForcePoint& p : points) {
    const bool current = at == ForceCoordinates::current;
    std::array<char, 100> line;
    std::snprintf(line.data(), line.size(), "%.17g %.17g %.17g\n", current ? p.x : p.X, current ? p.y : p.Y, p.t);
    lines += line.data();
  }
  return lines;
}

/// What a command leaves in the file "b", "bx by ..." for each line of "points", against the exact b.
inline void expect_force(const VortexForces& vortex, const ForcePieces& pieces, ForceCoordinates at,
                         const ScratchFolder& scratch, const std::string& command, double factor = 1) {
  const std::vector<ForcePoint> points = force_points(vortex, 400);
  scratch.write("points", point_lines(points, at));
  expect_runs(scratch, command);
  if (testing::Test::HasFatalFailure()) return;
  std::ifstream found(scratch / "b");
  double largest = 0, bx = 0, by = 0;
  std::string rest;
  for (const ForcePoint& p : points) {
    ASSERT_TRUE(found >> bx >> by);
    std::getline(found, rest);
    largest = std::max({largest, std::abs(bx / factor - p.bx), std::abs(by / factor - p.by)});
  }
  EXPECT_LE(largest, tolerance_share * pieces.tolerance * pieces.largest) << command;
  EXPECT_GT(pieces.largest, 1);
}

}  // namespace assay::drivers
