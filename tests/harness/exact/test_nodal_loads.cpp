// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/nodal_loads.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/motion/kinds/rigid.hpp"
#include "harness/motion/kinds/rotating_stretch.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "tests/harness/elastic_material.hpp"
#include "tests/harness/exact/element_meshes.hpp"

namespace assay::test_nodal_loads {
namespace {

using namespace assay::element_meshes;
using Shape = ElementMesh::Shape;

constexpr double rho = 1000, now = 0.4;
constexpr double of_rounding = 1e-12;   ///< of the largest load, or of sums of sizes
constexpr double of_quadrature = 1e-9;  ///< of so many points, of the largest load
constexpr int many_points = 10;

constexpr std::array shapes{Shape::triangle, Shape::quadrilateral, Shape::tetrahedron, Shape::hexahedron};

RotatingStretch stretch() {
  RotatingStretch motion;
  motion.stretch = 0.3, motion.shear = 0.2, motion.rotation = 0.8;
  return motion;
}

ExactSolutionPtr uniform() {
  return exact_uniform(stretch(), rho, elastic_material(1e5, 0.3), Motion(stretch())->baseline(), 1, 1e-12);
}

/// A vortex of the power, in the plane or in space, of a neo-Hookean material.
ExactSolutionPtr vortex(bool in_space, int power = 4) {
  const auto response = [](const Motion& motion) {
    return std::make_shared<const Response>(*ClosedForm::of(elastic_material(1e5, 0.3), motion->baseline()));
  };
  if (!in_space) {
    Vortex ring;
    ring.profile_power = power;
    return exact_polar(ring, rho, response(ring));
  }
  const Vortex3d ball{{.profile_power = power, .axis = {1, 2, 3}}, {}, {Amplitude::Type::sine, 1, 1}};
  return exact_meridian(ball, rho, response(ball));
}

/// Of elements within the ring, or the ball.
ElementMesh mesh_within(Shape shape, int n) {
  return is_plane(shape) ? lattice(shape, {0.62, 0.55, 0}, {0.85, 0.75, 0}, n)
                         : lattice(shape, {0.1, 0.15, 0.2}, {0.45, 0.5, 0.4}, n);
}

double largest(const std::vector<Vector3>& forces) {
  double size = 0;
  for (const Vector3& f : forces) size = std::max(size, f.norm());
  return size;
}

double deviation(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

/// Integral of rho0 b N_I and of the tractions on all faces that belong to one element.
std::vector<Vector3> from_force_and_tractions(const ElementMesh& mesh, const ExactSlice& slice) {
  std::vector<Vector3> force(mesh.X.size(), Vector3::Zero());
  for_each_point(mesh, many_points, [&](const Vector3& X, const std::vector<NodeShare>& shares, double dV) {
    const Vector3 b = slice.at(X).stress.body_force;
    for (const auto& [node, N] : shares) force[node] += rho * dV * N * b;
  });
  for_each_face_point(mesh, many_points,
                      [&](const Vector3& X, const std::vector<NodeShare>& shares, const Vector3& dS) {
                        const Vector3 traction = slice.first_piola_kirchhoff(X) * dS;
                        for (const auto& [node, N] : shares) force[node] += N * traction;
                      });
  return force;
}

TEST(NodalLoads, AreTheBodyForceAndTheTractionsTogether) {
  for (const Shape shape : shapes) {
    const auto exact = vortex(!is_plane(shape));
    const auto slice = exact->slice(now);
    const ElementMesh mesh = mesh_within(shape, 2);
    const auto wanted = from_force_and_tractions(mesh, *slice);
    const double scale = largest(wanted);
    EXPECT_LT(deviation(NodalLoads(mesh, *exact, rho, {.gauss = many_points}).at(*slice), wanted),
              of_quadrature * scale);
    // the controls: what is left out is seen
    const auto quasi_static = NodalLoads(mesh, *exact, rho, {.gauss = many_points, .quasi_static = true}).at(*slice);
    EXPECT_GT(deviation(quasi_static, wanted), 1e-3 * scale);
    std::vector<Vector3> without_tractions(mesh.X.size(), Vector3::Zero());
    for_each_point(mesh, many_points, [&](const Vector3& X, const std::vector<NodeShare>& shares, double dV) {
      for (const auto& [node, N] : shares) without_tractions[node] += rho * dV * N * slice->at(X).stress.body_force;
    });
    EXPECT_GT(deviation(without_tractions, wanted), 1e-2 * scale);
  }
}

/// Their difference is the inertia alone.
TEST(NodalLoads, WithoutInertiaAreThoseOfTheStaticForce) {
  for (const Shape shape : shapes) {
    const auto exact = vortex(!is_plane(shape));
    const auto slice = exact->slice(now);
    const ElementMesh mesh = mesh_within(shape, 2);
    auto wanted = from_force_and_tractions(mesh, *slice);
    for_each_point(mesh, many_points, [&](const Vector3& X, const std::vector<NodeShare>& shares, double dV) {
      const ExactPoint at = slice->at(X);
      for (const auto& [node, N] : shares)
        wanted[node] += rho * dV * N * (at.stress.static_force - at.stress.body_force);
    });
    const auto found = NodalLoads(mesh, *exact, rho, {.gauss = many_points, .quasi_static = true}).at(*slice);
    EXPECT_LT(deviation(found, wanted), of_quadrature * largest(wanted));
  }
}

TEST(NodalLoads, OfAUniformStressStandOnTheSurfaceAlone) {
  for (const Shape shape : shapes) {
    const auto exact = uniform();
    const auto slice = exact->slice(now);
    const Tensor P = slice->first_piola_kirchhoff(Vector3::Zero());
    const Vector3 upper = is_plane(shape) ? Vector3(1.2, 0.9, 0) : Vector3(1.2, 0.9, 0.7);
    const ElementMesh mesh = distorted(lattice(shape, Vector3::Zero(), upper, 4), upper);
    std::vector<Vector3> wanted(mesh.X.size(), Vector3::Zero());
    for_each_outer_face(mesh, [&](const std::vector<std::size_t>& nodes) {
      for (const std::size_t node : nodes) wanted[node] += P * area_of(mesh, nodes) / static_cast<double>(nodes.size());
    });
    const auto found = NodalLoads(mesh, *exact, rho, {.quasi_static = true}).at(*slice);
    EXPECT_LT(deviation(found, wanted), of_rounding * largest(wanted));
    std::size_t inner = 0;
    for (const Vector3& f : wanted) inner += f == Vector3::Zero() ? 1 : 0;
    EXPECT_EQ(inner, is_plane(shape) ? 9U : 27U);
  }
}

/// Functions of all nodes are 1 together; where F is the same everywhere the nodes' positions tell those in between.
TEST(NodalLoads, TogetherHoldTheInertiaAndItsMoment) {
  for (const Shape shape : shapes) {
    const Vector3 upper = is_plane(shape) ? Vector3(1.2, 0.9, 0) : Vector3(1.2, 0.9, 0.7);
    for (const bool is_uniform : {true, false}) {
      const auto exact = is_uniform ? uniform() : vortex(!is_plane(shape));
      const auto slice = exact->slice(now);
      const ElementMesh mesh = distorted(lattice(shape, Vector3::Zero(), upper, 3), upper);
      for (const bool quasi_static : {false, true}) {
        constexpr int points = 4;
        const auto found = NodalLoads(mesh, *exact, rho, {points, 0, quasi_static}).at(*slice);
        Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
        double sizes = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
          force += found[i], moment += slice->state(mesh.X[i]).x.cross(found[i]);
          sizes += found[i].norm();
        }
        Vector3 inertia = Vector3::Zero(), its_moment = Vector3::Zero();
        for_each_point(mesh, points, [&](const Vector3& X, const std::vector<NodeShare>&, double dV) {
          if (quasi_static) return;
          const ExactState state = slice->state(X);
          inertia += rho * dV * state.a, its_moment += rho * dV * state.x.cross(state.a);
        });
        // of the vortex the two rules see different points of triangles and tetrahedra
        const double tolerance = is_uniform || quasi_static ? of_rounding : 1e-2;
        EXPECT_LT((force - inertia).norm(), tolerance * sizes) << quasi_static;
        if (is_uniform) {
          EXPECT_LT((moment - its_moment).norm(), of_rounding * sizes) << quasi_static;
        }
        if (is_uniform && !quasi_static) {
          EXPECT_GT(inertia.norm(), 1e-3 * sizes);
        }
      }
    }
  }
}

/// A body that spins without stress: the acceleration is linear, and the mass matrix of a simplex is known.
TEST(NodalLoads, OfALinearAccelerationAreTheMassMatrixTimesIt) {
  const Motion spinning = Rigid{{}, 1.7, {0, 0, 1}, 1};
  const auto exact = exact_uniform(spinning, rho, [](double) { return Tensor::Zero(); });
  const auto slice = exact->slice(now);
  const ElementMesh triangle{Shape::triangle, {{0.1, 0.2, 0}, {1.3, 0.4, 0}, {0.5, 1.1, 0}}, {0, 1, 2}};
  const ElementMesh tetrahedron{
      Shape::tetrahedron, {{0.1, 0.2, 0}, {1.3, 0.4, 0.1}, {0.5, 1.1, -0.2}, {0.4, 0.6, 0.9}}, {0, 1, 2, 3}};
  for (const ElementMesh& mesh : {triangle, tetrahedron}) {
    const bool plane = is_plane(mesh.shape);
    const Vector3 a = mesh.X[1] - mesh.X[0], b = mesh.X[2] - mesh.X[0];
    const double volume = plane ? a.cross(b).z() / 2 : (mesh.X[3] - mesh.X[0]).dot(a.cross(b)) / 6;
    const double share = rho * volume / (plane ? 12 : 20);
    std::vector<Vector3> wanted(mesh.X.size(), Vector3::Zero());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      for (std::size_t j = 0; j < wanted.size(); ++j) wanted[i] += share * (i == j ? 2 : 1) * slice->state(mesh.X[j]).a;
    }
    EXPECT_LT(deviation(NodalLoads(mesh, *exact, rho).at(*slice), wanted), of_rounding * largest(wanted));
  }
}

/// On the nodes of a coarse mesh, whose functions a finer one has.
std::vector<Vector3> gathered(const ElementMesh& coarse, const ElementMesh& fine, const std::vector<Vector3>& force) {
  std::vector<Vector3> sum(coarse.X.size(), Vector3::Zero());
  const Vector3 cell = coarse.X.back() - coarse.X.front();  // of the one cell of it
  for (std::size_t j = 0; j < fine.X.size(); ++j) {
    for (std::size_t i = 0; i < coarse.X.size(); ++i) {
      double N = 1;
      for (int d = 0; d < 3; ++d)
        if (cell(d) > 0) N *= 1 - std::abs(fine.X[j](d) - coarse.X[i](d)) / cell(d);
      sum[i] += N * force[j];
    }
  }
  return sum;
}

TEST(NodalLoads, OfAFinerMeshHoldThoseOfACoarserOne) {
  for (const Shape shape : {Shape::quadrilateral, Shape::hexahedron}) {
    const auto exact = vortex(!is_plane(shape));
    const auto slice = exact->slice(now);
    const ElementMesh coarse = mesh_within(shape, 1);
    const auto wanted = NodalLoads(coarse, *exact, rho, {.gauss = NodalLoadRule::most_points}).at(*slice);
    const auto error = [&](int n, int gauss) {
      const ElementMesh fine = mesh_within(shape, n);
      return deviation(gathered(coarse, fine, NodalLoads(fine, *exact, rho, {.gauss = gauss}).at(*slice)), wanted);
    };
    EXPECT_LT(error(2, many_points), of_quadrature * largest(wanted));
    EXPECT_GT(error(4, 0) / error(8, 0), 12);  // of fourth order
    EXPECT_LT(error(8, 0), 1e-4 * largest(wanted));
  }
}

/// Of a ring whose stress has a kink at its edge.
TEST(NodalLoads, ElementsThatAnEdgeCutsAreDivided) {
  for (const Shape shape : {Shape::triangle, Shape::quadrilateral}) {
    const auto exact = vortex(false, 2);
    const auto slice = exact->slice(now);
    ASSERT_TRUE(slice->has_parts(ExactSlice::Smooth::stress));
    const ElementMesh mesh = lattice(shape, {1.1, 0.05, 0}, {1.4, 0.35, 0}, 4);
    const auto of = [&](const NodalLoadRule& rule) { return NodalLoads(mesh, *exact, rho, rule).at(*slice); };
    const auto wanted = of({4, 8});
    EXPECT_LT(deviation(of({}), wanted), 0.25 * deviation(of({0, 0}), wanted));
  }
}

TEST(NodalLoads, AreTheSameInAnyNumberOfPieces) {
  const auto exact = vortex(true);
  const auto slice = exact->slice(now);
  const NodalLoads loads(mesh_within(Shape::tetrahedron, 3), *exact, rho);
  const InPieces backwards = [](std::size_t n, const std::function<void(std::size_t, std::size_t)>& body) {
    constexpr std::size_t piece = 7;
    for (std::size_t end = n; end > 0; end -= std::min(end, piece)) body(end - std::min(end, piece), end);
  };
  EXPECT_EQ(loads.at(*slice), loads.at(*slice, backwards));
}

TEST(NodalLoads, SayWhatIsWrongWithAMesh) {
  const ElementMesh square{Shape::quadrilateral, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 1, 2, 3}};
  const auto exact = vortex(false);
  const auto fault = [&](const auto& change, double density = rho, const NodalLoadRule& rule = {}) -> std::string {
    ElementMesh mesh = square;
    change(mesh);
    try {
      NodalLoads(mesh, *exact, density, rule);
      return "none";
    } catch (const MeshFault& found) {
      return found.argument + " " + std::to_string(found.index) + ": " + found.what();
    }
  };
  const auto nothing = [](ElementMesh&) {};
  EXPECT_EQ(fault(nothing), "none");
  EXPECT_TRUE(NodalLoads({Shape::triangle, {}, {}}, *exact, rho).at(*exact->slice(now)).empty());
  EXPECT_EQ(fault([](ElementMesh& m) { m.connectivity = {0, 1, 2, 2}; }), "none");  // a triangle
  EXPECT_EQ(fault([](ElementMesh& m) { m.X[2].y() = std::nan(""); }),
            "X 2: node 2 has a coordinate that is not a finite number");
  EXPECT_EQ(fault([](ElementMesh& m) { m.X[1].z() = 0.5; }), "X 1: node 1 of plane elements must have Z = 0");
  EXPECT_EQ(fault([](ElementMesh& m) { m.connectivity[3] = 4; }),
            "connectivity 0: element 0 has node 4 of nodes 0 to 3");
  EXPECT_EQ(fault([](ElementMesh& m) { m.connectivity[0] = -1; }),
            "connectivity 0: element 0 has node -1 of nodes 0 to 3");
  EXPECT_EQ(fault([](ElementMesh& m) { m.connectivity.pop_back(); }),
            "connectivity -1: elements of this shape have 4 nodes each, found 3 in all");
  const std::string inverted =
      "connectivity 0: element 0 is inverted or flat: its nodes must go in VTK's order, counterclockwise";
  EXPECT_EQ(fault([](ElementMesh& m) { m.connectivity = {0, 3, 2, 1}; }), inverted);
  EXPECT_EQ(fault([](ElementMesh& m) { m.connectivity = {0, 1, 3, 2}; }), inverted);
  EXPECT_EQ(fault([](ElementMesh& m) { m.X[2] = {0.2, 0.2, 0}; }), inverted);  // at one corner
  EXPECT_EQ(fault([](ElementMesh& m) { m.connectivity = {0, 1, 1, 0}; }), inverted);
  EXPECT_EQ(fault(nothing, 0), "density -1: the density must be a positive number");
  EXPECT_EQ(fault(nothing, std::nan("")), "density -1: the density must be a positive number");
  EXPECT_EQ(fault(nothing, rho, {.gauss = 17}), "gauss -1: must be 0 to 16 points along each direction");
  EXPECT_EQ(fault(nothing, rho, {.gauss = -1}), "gauss -1: must be 0 to 16 points along each direction");
  for (const Shape shape : shapes) {
    ElementMesh mesh = mesh_within(shape, 1);
    std::swap(mesh.connectivity[0], mesh.connectivity[1]);
    EXPECT_THROW(NodalLoads(mesh, *exact, rho), MeshFault);
  }
}

}  // namespace
}  // namespace assay::test_nodal_loads
