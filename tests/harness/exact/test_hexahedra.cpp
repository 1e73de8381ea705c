// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/hexahedra.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "harness/motion/kinds/rotating_stretch.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "tests/harness/builtin_material.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::test_hexahedra {
namespace {

constexpr double rho = 1000, now = 0.5;
constexpr double of_rounding = 1e-12;  ///< of sums over the body, against sums of sizes

Vortex3d ball(int power) { return {{.profile_power = power, .axis = {1, 2, 3}}, {}, {Amplitude::Type::sine, 1, 1}}; }

Vortex3d torus(int power) {
  Vortex3d motion = ball(power);
  motion.one.profile = Revolution::Profile::torus;
  motion.one.ring_radius = 1, motion.one.radius = 0.25;
  motion.amplitude.peak = 0.3;
  return motion;
}

ExactSolutionPtr elastic(const Vortex3d& motion) {
  const auto form = ClosedForm::of(elastic_material(1e3, 0.3), motion.baseline());
  return exact_meridian(motion, rho, std::make_shared<const Response>(*form));
}

/// Centres of a lattice of cubes with this edge that have a corner in the body.
std::vector<Vector3> centres(const Vortex3d& motion, double edge) {
  const auto [wide, high] = motion.one.reach();
  const double far = std::hypot(wide, high);
  std::vector<Vector3> found;
  const int n = static_cast<int>(std::ceil(far / edge));
  for (int i = -n; i < n; ++i) {
    for (int j = -n; j < n; ++j) {
      for (int k = -n; k < n; ++k) {
        const Vector3 lower = edge * Vector3(i, j, k);
        bool inside = false;
        for (int c = 0; c < 8; ++c) inside |= motion.place(lower + edge * Vector3(c % 2, c / 2 % 2, c / 4)).has_value();
        if (inside) found.push_back(lower + Vector3::Constant(0.5 * edge));
      }
    }
  }
  return found;
}

/// Mean of b at points, over a cube that is halved where the edge of the body goes through it.
Vector3 integral_of_points(const ExactSlice& slice, const Vortex3d& motion, const Vector3& lower, double edge,
                           int divisions) {
  int inside = 0;
  constexpr int looks = 4;
  for (int c = 0; c < looks * looks * looks; ++c) {
    const Vector3 share(c % looks, c / looks % looks, c / looks / looks);
    inside += motion.place(lower + edge / (looks - 1) * share) ? 1 : 0;
  }
  Vector3 sum = Vector3::Zero();
  if (inside > 0 && inside < looks * looks * looks && divisions > 0) {
    for (int c = 0; c < 8; ++c)
      sum += integral_of_points(slice, motion, lower + edge / 2 * Vector3(c % 2, c / 2 % 2, c / 4), edge / 2,
                                divisions - 1);
    return sum;
  }
  for (const GaussPoint& u : gauss_rule<5>()) {
    for (const GaussPoint& v : gauss_rule<5>()) {
      for (const GaussPoint& w : gauss_rule<5>())
        sum += u.weight * v.weight * w.weight * std::pow(edge / 2, 3) *
               slice.at(lower + edge / 2 * Vector3(1 + u.at, 1 + v.at, 1 + w.at)).stress.body_force;
    }
  }
  return sum;
}

struct Errors {
  double rms = 0, largest = 0;  ///< of the largest b
};

/// Of some cubes of the lattice with h = 1/16, two along each direction of a cell, that the edge cuts or not.
Errors errors_of(const Vortex3d& motion, const HexahedronRule& rule) {
  constexpr double edge = 1.0 / 32;
  constexpr int some = 30, divisions = 3;
  const auto exact = elastic(motion);
  const auto slice = exact->slice(now);
  std::vector<Vector3> points = centres(motion, edge);
  std::shuffle(points.begin(), points.end(), std::mt19937(7));
  double largest_b = 0;
  for (const Vector3& X : points) largest_b = std::max(largest_b, slice->at(X).stress.body_force.norm());
  points.resize(some);
  const HexahedronAverage average(Hexahedra(boxes_around(points, Vector3::Constant(edge / 2))), rho, rule);
  const auto found = average.at(*slice);
  Errors errors;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Vector3 lower = points[p] - Vector3::Constant(edge / 2);
    const Vector3 wanted = integral_of_points(*slice, motion, lower, edge, divisions) / std::pow(edge, 3);
    const double error = (found[p].b - wanted).norm() / largest_b;
    errors.rms += error * error / some;
    errors.largest = std::max(errors.largest, error);
  }
  errors.rms = std::sqrt(errors.rms);
  return errors;
}

TEST(LongHexahedra, MeansOfTheBodyForceAreThoseOfPoints) {
  struct Row {
    Vortex3d motion;
    HexahedronRule rule;
    double rms, largest;  ///< what the facts of the vortex in three dimensions have, or better
  };
  const Row rows[] = {{torus(2), {2, 0}, 1e-2, 5e-2}, {torus(3), {2, 0}, 8e-4, 3e-3}, {torus(4), {2, 0}, 1e-4, 3e-4},
                      {ball(4), {2, 0}, 2e-5, 6e-5},  {torus(4), {3, 0}, 1e-5, 5e-5}, {torus(2), {}, 1e-3, 5e-3},
                      {torus(3), {}, 2e-5, 1e-4},     {ball(3), {3, 4}, 1e-6, 1e-5}};
  for (const Row& row : rows) {
    const Errors errors = errors_of(row.motion, row.rule);
    const std::string name = std::to_string(row.motion.one.profile_power) + ", gauss " +
                             std::to_string(row.rule.gauss) + ", divisions " + std::to_string(row.rule.divisions);
    EXPECT_LT(errors.rms, row.rms) << name;
    EXPECT_LT(errors.largest, row.largest) << name;
  }
}

/// Integral of h R^2 dV over a ball of radius 1: (4 pi/3) B(5/2, m + 1).
double ball_moment(int m) {
  return 4 * std::numbers::pi / 3 * std::exp(std::lgamma(2.5) + std::lgamma(m + 1) - std::lgamma(m + 3.5));
}

struct Total {
  Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
  double sizes = 0, sizes_of_moments = 0;
};

Total total_of(const HexahedronAverage& average, const std::vector<DomainForce>& forces) {
  Total total;
  for (std::size_t p = 0; p < forces.size(); ++p) {
    const Vector3 force = rho * average.volume(p) * forces[p].b;
    total.force += force, total.moment += forces[p].moment;
    total.sizes += force.norm(), total.sizes_of_moments += forces[p].moment.norm();
  }
  return total;
}

HexahedronAverage lattice(const Vortex3d& motion, double edge, const HexahedronRule& rule = {}) {
  return {Hexahedra(boxes_around(centres(motion, edge), Vector3::Constant(edge / 2))), rho, rule};
}

/// What the stress exerts on the whole of a body free of traction is nothing: faces are shared.
TEST(Hexahedra, TheStressOfAFreeBodyHasNoTotal) {
  for (const Vortex3d& motion : {ball(2), ball(4), torus(3)}) {
    const auto moved = exact_meridian(motion, rho, nullptr), stressed = elastic(motion);
    const HexahedronAverage average = lattice(motion, 1.0 / 8);
    const Total with = total_of(average, average.at(*stressed->slice(0.3)));
    const Total without = total_of(average, average.at(*moved->slice(0.3)));
    EXPECT_LT((with.force - without.force).norm(), of_rounding * with.sizes);
    EXPECT_LT((with.moment - without.moment).norm(), of_rounding * with.sizes_of_moments);
    EXPECT_GT(std::abs(with.sizes - without.sizes), 1e-2 * with.sizes);  // it is there
  }
}

/// What its inertia needs is known: no force, and the moment rho0 g'' integral of h R^2 dV about the axis.
TEST(Hexahedra, TheWholeBodyFeelsItsInertia) {
  const Vector3 axis = Vector3(1, 2, 3).normalized();
  const auto wanted = [](const Vortex3d& motion) {
    return rho * motion.amplitude.at(0.3).acceleration * ball_moment(motion.one.profile_power);
  };
  struct Row {
    int power;
    double tolerance;  ///< of the moment: at the edge of the body the rule sees a power of the distance
  };
  for (const Row& row : {Row{2, 1e-4}, Row{4, 5e-6}}) {
    const Vortex3d motion = ball(row.power);
    const HexahedronAverage average = lattice(motion, 1.0 / 8);
    const Total total = total_of(average, average.at(*exact_meridian(motion, rho, nullptr)->slice(0.3)));
    EXPECT_LT(total.force.norm(), of_rounding * total.sizes);
    EXPECT_LT((total.moment - wanted(motion) * axis).norm(), row.tolerance * total.sizes_of_moments) << row.power;
  }
}

/// To rounding with a fine rule: an octant about an axis of the lattice has an eighth of the moment.
TEST(Hexahedra, TheMomentOfTheInertiaIsExact) {
  Vortex3d motion = ball(3);
  motion.one.axis = {0, 0, 1};
  std::vector<Vector3> points = centres(motion, 1.0 / 8);
  std::erase_if(points, [](const Vector3& X) { return X.minCoeff() < 0; });
  constexpr HexahedronRule fine{6, 6};
  const HexahedronAverage average(Hexahedra(boxes_around(points, Vector3::Constant(1.0 / 16))), rho, fine);
  const Total total = total_of(average, average.at(*exact_meridian(motion, rho, nullptr)->slice(0.3)));
  const double wanted = rho * motion.amplitude.at(0.3).acceleration * ball_moment(3) / 8;
  EXPECT_NEAR(total.moment.z(), wanted, of_rounding * total.sizes_of_moments);
}

/// Uniform stress exerts nothing, whatever the shape of the domains: b is the mean acceleration.
TEST(Hexahedra, UniformStressExertsNothingOnDistortedDomains) {
  RotatingStretch stretch;
  stretch.stretch = 0.3, stretch.shear = 0.2, stretch.rotation = 0.8, stretch.axis = {1, 2, 3};
  const auto exact = exact_uniform(stretch, rho, elastic_material(1e3, 0.3), Motion(stretch)->baseline(), 1, 1e-12);
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> off(-0.15, 0.15);
  std::vector<std::array<Vector3, 8>> domains =
      boxes_around(std::vector{Vector3(0.5, 0.5, 0.5)}, Vector3::Constant(0.5));
  for (Vector3& corner : domains[0]) corner += Vector3(off(generator), off(generator), off(generator));
  const HexahedronAverage average(Hexahedra(domains), rho);
  const auto found = average.at(*exact->slice(now));
  Vector3 centroid = Vector3::Zero();  // by tetrahedra about the middle: an independent way
  double volume = 0;
  constexpr int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}, {1, 2, 6, 5}, {3, 0, 4, 7}};
  for (const auto& face : faces) {
    constexpr int fine = 64;  // the bilinear face as triangles
    const auto at = [&](double u, double v) {
      const auto& c = domains[0];
      return Vector3((1 - v) * ((1 - u) * c[std::size_t(face[0])] + u * c[std::size_t(face[1])]) +
                     v * ((1 - u) * c[std::size_t(face[3])] + u * c[std::size_t(face[2])]));
    };
    for (int i = 0; i < fine; ++i) {
      for (int j = 0; j < fine; ++j) {
        const Vector3 a = at(double(i) / fine, double(j) / fine), b = at(double(i + 1) / fine, double(j) / fine),
                      c = at(double(i + 1) / fine, double(j + 1) / fine),
                      d = at(double(i) / fine, double(j + 1) / fine);
        for (const auto& [p, q, r] : {std::array{a, b, c}, std::array{a, c, d}}) {
          const double part = p.dot(q.cross(r)) / 6;
          volume += part, centroid += part * (p + q + r) / 4;
        }
      }
    }
  }
  centroid /= volume;
  constexpr double of_triangles = 1e-4;  // of so many
  EXPECT_NEAR(average.volume(0), volume, of_triangles * volume);
  const Vector3 wanted = exact->state(centroid, now).a;
  EXPECT_LT((found[0].b - wanted).norm(), of_triangles * wanted.norm());
  std::vector<std::array<Vector3, 8>> turned = domains;  // another order of the corners is the same domain
  for (std::size_t k = 0; k < 8; ++k) turned[0][k] = domains[0][k < 4 ? (k + 1) % 4 : 4 + (k + 1) % 4];
  const auto again = HexahedronAverage(Hexahedra(turned), rho).at(*exact->slice(now));
  EXPECT_LT((found[0].b - again[0].b).norm(), of_rounding * wanted.norm());
}

ExactSolutionPtr yielding(const Vortex3d& motion) {
  const auto material = builtin_material(
      assay_builtin_j2_jaumann, {{"E", 1e6}, {"nu", 0.3}, {"yield_stress", 1.5e4}, {"hardening_modulus", 1e5}});
  const Sheet sheet(*material, motion.baseline(), {.tolerance = 1e-9, .end = now});
  EXPECT_TRUE(sheet.has_kinks());
  return exact_meridian(motion, rho, std::make_shared<const Response>(sheet));
}

/// The motion is smooth at a front of the material: what its inertia is integrated to does not depend on the stress.
TEST(Hexahedra, TheStressOfAFreeBodyThatYieldsHasNoTotal) {
  for (Vortex3d motion : {ball(4), ball(2)}) {
    motion.amplitude.peak = 0.1;
    const HexahedronAverage average = lattice(motion, 1.0 / 8);
    const Total with = total_of(average, average.at(*yielding(motion)->slice(now)));
    const Total without = total_of(average, average.at(*exact_meridian(motion, rho, nullptr)->slice(now)));
    EXPECT_LT((with.force - without.force).norm(), of_rounding * with.sizes);
    EXPECT_LT((with.moment - without.moment).norm(), of_rounding * with.sizes_of_moments);
    EXPECT_GT(std::abs(with.sizes - without.sizes), 1e-2 * with.sizes);
  }
}

/// A front of J2 between elastic and plastic points goes through the domains.
TEST(Hexahedra, FrontsOfAMaterialAreDivided) {
  Vortex3d motion = ball(4);
  motion.amplitude.peak = 0.1;
  const auto exact = yielding(motion);
  const auto slice = exact->slice(now);
  constexpr auto of_stress = ExactSlice::Smooth::stress;
  ASSERT_TRUE(slice->has_parts(of_stress));
  EXPECT_FALSE(slice->has_parts(ExactSlice::Smooth::motion));
  std::vector<Vector3> points;
  constexpr double edge = 1.0 / 16;
  for (const Vector3& X : centres(motion, edge)) {
    std::set<std::size_t> parts;
    for (int c = 0; c < 8; ++c)
      parts.insert(slice->part(X + edge / 2 * Vector3(c % 2 ? 1 : -1, c / 2 % 2 ? 1 : -1, c / 4 ? 1 : -1), of_stress));
    if (parts.size() > 1 && points.size() < 40) points.push_back(X);
  }
  ASSERT_GT(points.size(), 20U);
  const auto boxes = boxes_around(points, Vector3::Constant(edge / 2));
  const auto of = [&](const HexahedronRule& rule) { return HexahedronAverage(Hexahedra(boxes), rho, rule).at(*slice); };
  const auto wanted = of({4, 7}), divided = of({}), whole = of({2, 0});
  double error = 0, error_of_whole = 0, scale = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    error = std::max(error, (divided[p].b - wanted[p].b).norm());
    error_of_whole = std::max(error_of_whole, (whole[p].b - wanted[p].b).norm());
    scale = std::max(scale, wanted[p].b.norm());
  }
  EXPECT_LT(error, 0.1 * error_of_whole);
}

/// Each domain for itself, with faces of its own: what two of them say of a common face would be the same, and a wrong
/// sign is seen.
TEST(Hexahedra, NeighboursShareTheirFaces) {
  const std::vector<Vector3> points{{0.3, 0.1, 0.2}, {0.4, 0.1, 0.2}, {0.4, 0.2, 0.2}};
  const Hexahedra domains(boxes_around(points, Vector3::Constant(0.05)));
  EXPECT_EQ(domains.faces().size(), 16U);
  EXPECT_EQ(domains.corners().size(), 16U);
  const auto exact = elastic(ball(4));
  const auto slice = exact->slice(now);
  const auto together = HexahedronAverage(domains, rho).at(*slice);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto alone =
        HexahedronAverage(Hexahedra(boxes_around(std::vector{points[p]}, Vector3::Constant(0.05))), rho).at(*slice);
    EXPECT_LT((together[p].b - alone[0].b).norm(), of_rounding * alone[0].b.norm() * 100) << p;
    const Vector3 at_point = slice->at(points[p]).stress.body_force;
    EXPECT_LT((together[p].b - at_point).norm(), 0.05 * at_point.norm()) << p;
  }
}

}  // namespace
}  // namespace assay::test_hexahedra
