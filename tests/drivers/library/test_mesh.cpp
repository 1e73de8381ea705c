// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "tests/drivers/library/handles.hpp"

namespace assay::library_test::test_mesh {
namespace {

/// Squares that divide [.8, 1] x [0, .2].
struct Squares {
  static constexpr int across = 4;
  std::vector<double> X;
  std::vector<std::int64_t> nodes;
  Squares() {
    for (int j = 0; j <= across; ++j) {
      for (int i = 0; i <= across; ++i) X.insert(X.end(), {.8 + .2 * i / across, .2 * j / across});
    }
    for (int j = 0; j < across; ++j) {
      for (int i = 0; i < across; ++i) {
        const int first = j * (across + 1) + i;
        for (const int node : {first, first + 1, first + across + 2, first + across + 1}) nodes.push_back(node);
      }
    }
  }
  assay_mesh_options options() const {
    assay_mesh_options mesh{};
    mesh.struct_size = sizeof mesh;
    mesh.element = ASSAY_QUADRILATERAL;
    mesh.nodes = X.size() / 2, mesh.elements = nodes.size() / 4;
    mesh.X = X.data(), mesh.connectivity = nodes.data();
    return mesh;
  }
};

std::vector<double> loads_of(const Owned<assay_problem>& problem, const assay_mesh_options& mesh, double t) {
  assay_mesh* handle = nullptr;
  assay_error error = ASSAY_ERROR_INIT;
  EXPECT_EQ(assay_mesh_open(problem.get(), &mesh, &handle, &error), ASSAY_DONE) << error.message;
  const Owned<assay_mesh> owned(handle);
  std::vector<double> force(2 * mesh.nodes);
  const assay_field field{force.data(), 2, 1};
  EXPECT_EQ(assay_nodal_loads(handle, t, &field, &error), ASSAY_DONE) << error.message;
  return force;
}

TEST(Mesh, ForcesAddUpToTheMassTimesTheAcceleration) {
  constexpr double gauss = 1e-3;  // of two points along an element's edge
  const auto problem = opened(vortex_text());
  const Squares squares;
  const std::vector<double> force = loads_of(problem, squares.options(), .3);
  double sum = 0, inertia = 0;
  for (std::size_t i = 0; i < force.size(); i += 2) sum += force[i];
  std::vector<double> middles;
  for (int k = 0; k < 16; ++k) middles.insert(middles.end(), {.8 + .05 * (k % 4 + .5), .05 * (k / 4 + .5)});
  for (const Fields& f : evaluated(points_at(problem, middles, 2), .3, 16)) inertia += 1000 * .05 * .05 * f.a[0];
  EXPECT_NEAR(sum, inertia, 1e2 * gauss * std::abs(inertia));
  assay_mesh_options still = squares.options();
  still.quasi_static = 1;
  sum = 0;
  const std::vector<double> at_rest = loads_of(problem, still, .3);
  for (std::size_t i = 0; i < at_rest.size(); i += 2) sum += at_rest[i];
  EXPECT_NEAR(sum, 0, 1e-9 * std::abs(inertia) + 1e-9);
}

TEST(Mesh, ThatIsDamagedIsRefused) {
  const auto problem = opened(vortex_text());
  const Squares squares;
  const auto refused = [&](const char* key, const auto& damage) {
    assay_mesh_options mesh = squares.options();
    damage(mesh);
    assay_mesh* handle = nullptr;
    assay_error error = ASSAY_ERROR_INIT;
    EXPECT_EQ(assay_mesh_open(problem.get(), &mesh, &handle, &error), ASSAY_BAD_INPUT) << key;
    EXPECT_STREQ(error.key, key) << error.message;
    EXPECT_EQ(handle, nullptr);
  };
  std::vector<std::int64_t> beyond = squares.nodes;
  beyond[5] = 99;
  std::vector<double> torn = squares.X;
  torn[3] = NAN;
  refused("mesh.element", [](auto& mesh) { mesh.element = 7; });
  refused("mesh.element", [](auto& mesh) { mesh.element = ASSAY_HEXAHEDRON; });
  refused("mesh.connectivity", [&](auto& mesh) { mesh.connectivity = beyond.data(); });
  refused("mesh.X", [&](auto& mesh) { mesh.X = torn.data(); });
  refused("mesh.X", [](auto& mesh) { mesh.X = nullptr; });
  refused("mesh.gauss", [](auto& mesh) { mesh.gauss = -1; });
  refused("mesh", [](auto& mesh) { mesh.struct_size = 4; });
}

}  // namespace
}  // namespace assay::library_test::test_mesh
