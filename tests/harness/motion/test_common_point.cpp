// SPDX-License-Identifier: BSD-3-Clause
// Bodies of revolution that have points in common are told from those that have none, against brute force.
#include "harness/motion/common_point.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "harness/numeric/norms.hpp"
#include "harness/numeric/stopwatch.hpp"

namespace assay::test_common_point {
namespace {

using Profile = Revolution::Profile;

class Chance {
 public:
  double between(double lower, double upper) { return std::uniform_real_distribution(lower, upper)(generator_); }
  Vector3 in_cube(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }
  Revolution body() {
    Revolution r;
    r.profile = static_cast<Profile>(generator_() % 3);
    r.radius = between(0.05, 0.6);
    if (r.profile == Profile::torus) r.ring_radius = r.radius * between(1.05, 8);
    if (r.profile == Profile::drum) r.height = r.radius * between(0.05, 4);
    const int kind = static_cast<int>(generator_() % 3);  // along a coordinate, or anywhere
    r.axis = kind == 0 ? Vector3::UnitZ() : kind == 1 ? Vector3::UnitX() : in_cube(1);
    r.center = in_cube(1.5);
    if (generator_() % 4 == 0) r.center.head<2>().setZero();
    return r;
  }

 private:
  std::mt19937 generator_{5};
};

/// Points of the body, near its surface too.
std::vector<Vector3> points_of(const Revolution& r, Chance& chance, int count) {
  const auto [outer, high] = r.reach();
  const Tensor turn = Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), r.axis).toRotationMatrix();
  std::vector<Vector3> points;
  for (int k = 0; k < 40 * count && static_cast<int>(points.size()) < count; ++k) {
    const double R = chance.between(0, outer), Z = chance.between(-high, high), angle = chance.between(0, 2 * M_PI);
    const Vector3 X = r.center + turn * Vector3(R * std::cos(angle), R * std::sin(angle), Z);
    if (r.depth(X) > 0) points.push_back(X);
  }
  return points;
}

TEST(CommonPoint, IsFoundWhereABruteForceFindsOne) {
  Chance chance;
  int disjoint = 0, common = 0;
  for (int k = 0; k < 3000; ++k) {
    const Revolution a = chance.body(), b = chance.body();
    if (const auto X = common_point(a, b)) {
      ++common;
      EXPECT_GT(a.depth(*X), 0) << k;
      EXPECT_GT(b.depth(*X), 0) << k;
      EXPECT_TRUE(common_point(b, a)) << k;
      continue;
    }
    ++disjoint;
    EXPECT_FALSE(common_point(b, a)) << k;
    for (const Vector3& X : points_of(a, chance, 300)) EXPECT_LE(b.depth(X), 1e-6) << k;
  }
  EXPECT_GT(disjoint, 500);
  EXPECT_GT(common, 400);
}

/// Bodies that just touch, moved apart or together by little.
TEST(CommonPoint, IsToldFromATouch) {
  const Revolution ball{.radius = 0.4};
  const Revolution torus{.profile = Profile::torus, .radius = 0.1, .ring_radius = 0.7};
  const Revolution drum{.profile = Profile::drum, .radius = 0.5, .height = 0.2};
  const Revolution plate{.profile = Profile::drum, .radius = 0.9, .height = 0.2};
  const double corner = std::sqrt(0.5);
  struct Row {
    Revolution a, b;
    Vector3 touches;  ///< centre of the second where it touches
    Vector3 axis = {0, 0, 1};
  };
  const std::vector<Row> rows{
      {ball, ball, {0.8, 0, 0}},
      {ball, torus, {1.2, 0, 0}},
      {ball, drum, {0, 0, 0.6}},
      {torus, torus, {0, 0, 0.2}},             // along all of a circle
      {torus, torus, {1.6, 0, 0}},             // at a point
      {torus, torus, {1.6, 0, 0}, {0, 1, 0}},  // the second stands on edge
      {torus, plate, {0, 0, 0.3}},             // along all of a circle
      {torus, drum, {0.2, 0.1, 0.3}},
      {drum, drum, {0, 0, 0.4}},                            // face to face
      {drum, drum, {0.3, 0.1, 0.4}},                        // face to face, shifted
      {drum, drum, {1.0, 0, 0.1}},                          // side to side
      {drum, drum, {0.7, 0, 0}, {1, 0, 0}},                 // side to face
      {drum, drum, {0, 0, 0.2 + 0.7 * corner}, {1, 0, 1}},  // edge to face
  };
  constexpr double little = 1e-5;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    Row row = rows[k];
    row.b.axis = row.axis;
    for (const double share : {1.0, 1 + little}) {
      row.b.center = share * row.touches;
      EXPECT_FALSE(common_point(row.a, row.b)) << k << " " << share;
      EXPECT_FALSE(common_point(row.b, row.a)) << k << " " << share;
    }
    row.b.center = (1 - little) * row.touches;
    EXPECT_TRUE(common_point(row.a, row.b)) << k;
    EXPECT_TRUE(common_point(row.b, row.a)) << k;
  }
}

/// Depths below 1e-6 count as touching: of two balls half of that of their radii.
TEST(CommonPoint, OfAShallowerOverlapIsNone) {
  const Revolution ball{.radius = 1};
  Revolution other = ball;
  other.center = {2 - 0.9e-6, 0, 0};
  EXPECT_FALSE(common_point(ball, other));
  other.center = {2 - 1.1e-6, 0, 0};
  EXPECT_TRUE(common_point(ball, other));
}

/// Each of a thousand thin bodies reaches into the boxes of many others.
TEST(CommonPoint, IsSoughtQuicklyInThinBodiesThatInterleave) {
  std::vector<Revolution> tori, drums;
  for (int k = 0; k < 1000; ++k) {
    tori.push_back({.profile = Profile::torus, .radius = 0.002, .ring_radius = 1});
    tori.back().center = {0.003 * (k % 2), 0, 0.005 * k};
    drums.push_back({.profile = Profile::drum, .radius = 1, .height = 0.002, .axis = {1, 2, 3}});
    drums.back().center = 0.005 * k * Vector3(1, 2, 3).normalized() + 0.01 * (k % 3) * Vector3(3, 0, -1);
  }
  for (const std::vector<Revolution>& bodies : {tori, drums}) {
    const BodyBoxes boxes(bodies);
    const Stopwatch watch;
    std::size_t pairs = 0;
    for (const Revolution& body : bodies) {
      boxes.meeting(body, [&](std::size_t k) {
        if (&bodies[k] == &body) return;
        ++pairs;
        EXPECT_FALSE(common_point(bodies[k], body)) << k;
      });
    }
    EXPECT_LT(watch.seconds(), 10) << pairs << " pairs; a search through space took milliseconds for each";
  }
}

TEST(BodyBoxes, HoldAllPointsOfTheirBodies) {
  Chance chance;
  std::vector<Revolution> bodies;
  for (int k = 0; k < 200; ++k) bodies.push_back(chance.body());
  const BodyBoxes boxes(bodies);
  std::size_t others = 0;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    for (const Vector3& X : points_of(bodies[k], chance, 50)) {
      std::set<std::size_t> around;
      boxes.around(X, [&](std::size_t found) { around.insert(found); });
      EXPECT_TRUE(around.contains(k)) << k;
      others += around.size() - 1;
      for (std::size_t j = 0; j < bodies.size(); ++j) EXPECT_TRUE(bodies[j].depth(X) < 0 || around.contains(j));
    }
    std::set<std::size_t> meeting;
    boxes.meeting(bodies[k], [&](std::size_t found) { meeting.insert(found); });
    for (std::size_t j = 0; j < bodies.size(); ++j)
      EXPECT_TRUE(meeting.contains(j) || !common_point(bodies[k], bodies[j])) << k << " " << j;
  }
  EXPECT_LT(others, 200U * 50U * 150U) << "no box is much larger than its body";
}

}  // namespace
}  // namespace assay::test_common_point
