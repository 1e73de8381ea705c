// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "harness/motion/kinds/homogeneous.hpp"
#include "mpm/effects/tractions.hpp"
#include "mpm/seeding/lattice.hpp"
#include "mpm/simulation.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::mpm::test_virtual_stress {
namespace {

constexpr double of_stress = 1e-12;  ///< relative

/// A body that is stretched, sheared and turned, under virtual stress.
Setup<2> stretched_setup(TractionForm form) {
  Setup<2> setup;
  setup.grid = grid_around<2>({0, 0}, {1, 1}, 0.5, 4);
  setup.seeds = cartesian_lattice<2>({0, 0}, {1, 1}, 0.5, {2, 2}, [](const auto&) { return Fate::stepped; });
  setup.density = 1000;
  setup.material = elastic_material(1e4, 0.3);
  Homogeneous motion;
  motion.final << 1.4, 0.5, 0, -0.3, 0.8, 0, 0, 0, 1;
  setup.motion = motion;
  setup.traction = Traction{TractionAlgorithm::virtual_stress, form};
  setup.exact = exact_uniform(motion, setup.density, setup.material, motion.baseline(), 1, 1e-12);
  return setup;
}

/// Neither the particles' F nor their stress is the exact one: sigma - sigma_e, or sigma - P_e F^T / J.
TEST(VirtualStress, IsTakenFromTheStressOfParticlesThatErr) {
  const double t = 0.7;
  for (const TractionForm form : {TractionForm::follower, TractionForm::reference}) {
    const auto setup = stretched_setup(form);
    const ExactStress exact = setup.exact->at(Vector3::Zero(), t).stress;
    Pass<2> pass = virtual_stress_pass<2>(form);
    for (const Column filled : {Column::position, Column::velocity, Column::mass, Column::volume}) {
      pass.reads.push_back(filled);
    }
    Simulation<2> simulation(setup, {pass});
    auto& s = simulation.state();
    Tensor F = (*setup.motion)->at(Vector3::Zero(), t).F, sigma = exact.cauchy;
    F(0, 0) += 0.05, F(0, 1) -= 0.08, F(1, 0) += 0.03, F(1, 1) -= 0.02;
    sigma(0, 0) *= 1.2, sigma(0, 1) = sigma(1, 0) = sigma(0, 1) + 77;
    for (std::size_t p = 0; p < s.particles; ++p) {
      for (int c = 0; c < 4; ++c) {
        s.column(Column::deformation_gradient, c)[p] = F(c / 2, c % 2);
        s.column(Column::stress, c)[p] = sigma(c / 2, c % 2);
      }
    }
    ASSERT_FALSE(simulation.step(t, 1e-3));
    const Tensor taken = form == TractionForm::follower
                             ? exact.cauchy
                             : Tensor(exact.first_piola_kirchhoff * F.transpose() / F.determinant());
    for (int c = 0; c < 4; ++c) {
      const double expected = sigma(c / 2, c % 2) - taken(c / 2, c % 2);
      EXPECT_NEAR(s.column(Column::excess_stress, c)[0], expected, of_stress * taken.norm()) << c;
    }
  }
}

}  // namespace
}  // namespace assay::mpm::test_virtual_stress
