// SPDX-License-Identifier: BSD-3-Clause
// Snapshots of bodies in space: cells that are the domains of the particles, of the state and of what is kept of it.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/simulation/snapshots.hpp"
#include "mpm/simulation.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/vtu_reader.hpp"

namespace assay::drivers::test_snapshots_in_space {
namespace {

using mpm::Column;

ProblemIn<3> cube(const std::string& basis) {
  return assemble<3>(scene_from_text("dimension: 3\nmotion: {type: rigid}\ngrid: {spacing: 0.5}\n"
                                     "material: {adapter: neo_hookean, parameters: {E: 1000, nu: 0.3}, density: 1000}\n"
                                     "body: {domain: box, lower: [0, 0, 0], upper: [1, 1, 1], per_cell: [2, 2, 2]}\n"
                                     "output: {particles: 1, pictures: false}\nmethod: {basis: " +
                                         basis + ", transfer: flip}\n",
                                     "cube.yaml", {}),
                     1);
}

/// The volume of the parallelepiped at corner 0 of a cell, and whether the other corners belong to it.
double volume_of(const double* corners, bool& is_one) {
  const auto x = [&](int k) { return Vector3(corners + 3 * k); };
  const Vector3 a = x(1) - x(0), b = x(3) - x(0), c = x(4) - x(0);
  const auto belongs = [&](int k, const Vector3& there) { return (x(k) - x(0) - there).norm() < 1e-6; };
  is_one = belongs(2, a + b) && belongs(5, a + c) && belongs(6, a + b + c) && belongs(7, b + c);
  return a.cross(b).dot(c);
}

/// The state's own file, and that of what is kept of it for a run that dies, which knows no corners.
TEST(SnapshotsInSpace, ShowTheDomainsAlsoOfTheLastGoodState) {
  Tensor F;
  F << 1.2, 0.3, 0.1, 0, 0.9, -0.2, 0.15, 0, 1.1;
  for (const char* basis : {"cpdi2", "cpdi", "bspline2"}) {
    const ScratchFolder scratch;
    const ProblemIn<3> problem = cube(basis);
    mpm::Setup<3> setup = problem.setup;
    setup.exact = exact_solution_of(problem.scene, problem.material, problem.scene.time.end);
    mpm::Simulation<3> simulation(setup);
    mpm::State<3>& s = simulation.state();
    for (std::size_t p = 0; p < s.particles; ++p) {
      for (int c = 0; c < 9; ++c) s.column(Column::deformation_gradient, c)[p] = F(c / 3, c % 3);
    }
    {
      OutputFolder folder(scratch / "out");
      Snapshots<3> snapshots(problem, folder);
      snapshots.keep_good(s, 0);
      EXPECT_EQ(snapshots.leave_last_good(nullptr), "last_good.vtu");
      snapshots.add(s, nullptr, 0, 0);
      folder.write("result.json", "{}");
      folder.commit();
    }
    for (const std::string name : {"last_good.vtu", "particles_0000.vtu"}) {
      const VtuFile file(bytes_of(scratch / ("out/" + name)));
      // Corners that move one by one have not moved.
      const bool is_still = std::string(basis) == "cpdi2" && name != "last_good.vtu";
      const double expected = is_still ? 1.0 / 64 : F.determinant() / 64;
      const std::vector<double> corners = file.array<double>("Points");
      ASSERT_EQ(corners.size(), 64U * 24);
      for (std::size_t p = 0; p < 64; ++p) {
        bool is_one = false;
        EXPECT_NEAR(volume_of(corners.data() + 24 * p, is_one), expected, 1e-7) << basis << ", " << name;
        EXPECT_TRUE(is_one) << basis << ", " << name;
      }
      EXPECT_EQ(file.array<double>("position").size(), 64U * 3);
    }
  }
}

}  // namespace
}  // namespace assay::drivers::test_snapshots_in_space
