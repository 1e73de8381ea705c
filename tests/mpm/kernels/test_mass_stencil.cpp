// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/kernels/mass_stencil.hpp"

#include <gtest/gtest.h>

#include "mpm/mass/mass_matrix.hpp"
#include "mpm/patch/methods.hpp"
#include "tests/mpm/basis_cases.hpp"
#include "tests/mpm/vortex_setup.hpp"

namespace assay::mpm::test_mass_stencil {
namespace {

Method total_with(Basis basis) {
  Method method;
  method.basis = basis, method.formulation = Formulation::total, method.mass = Mass::series;
  return method;
}

/// The largest difference between the stencil's product and the particles', relative to the largest of these.
template <int Dim>
double difference(Setup<Dim> setup, int threads) {
  Simulation<Dim> simulation(std::move(setup));
  simulation.step(0, 1e-4);
  State<Dim>& s = simulation.state();
  const auto by_particles = [&](const GridField<Dim>& x, GridField<Dim>& y) {
    y.zero();
    kernels_for(s).multiply_mass(s, Block{0, s.particles, nullptr, y.data()}, x.data());
  };
  const auto add_rows = [&](const MassRows<Dim>& rows) {
    kernels_for(s).add_mass_rows(s, Block{0, s.particles, nullptr, nullptr}, rows);
  };
  const MassStencil<Dim> stencil(s.setup.grid, mass_nodes_across<Dim>(s.method), by_particles, add_rows);
  GridField<Dim> x, expected, found;
  for (auto* field : {&x, &expected, &found}) field->allocate(s.setup.grid.nodes());
  Random random{5};
  for (std::size_t i = 0; i < x.nodes(); ++i) {
    for (int d = 0; d < Dim; ++d) x.node(i)[d] = random(), found.node(i)[d] = 7;
  }
  by_particles(x, expected);
  stencil.multiply(x, found, threads);
  double worst = 0, scale = 0;
  for (std::size_t i = 0; i < x.nodes(); ++i) {
    for (int d = 0; d < Dim; ++d) {
      worst = std::max(worst, std::abs(found.node(i)[d] - expected.node(i)[d]));
      scale = std::max(scale, std::abs(expected.node(i)[d]));
    }
  }
  EXPECT_GT(scale, 0);
  return worst / scale;
}

TEST(MassStencil, IsTheMatrixOfTheParticles) {
  for (const Basis basis :
       {Basis::linear, Basis::ugimp, Basis::cpgimp, Basis::bspline2, Basis::bspline3, Basis::bspline4}) {
    SCOPED_TRACE(names_of(basis)[static_cast<std::size_t>(basis)]);
    for (const int threads : {1, 3}) EXPECT_LT(difference(vortex_setup(10, total_with(basis)), threads), 1e-14);
    EXPECT_LT(difference(block_setup<3>(total_with(basis)), 1), 1e-14);
  }
}

// Particles of their own masses up to the grid's edge, where B-splines are other ones.
TEST(MassStencil, IsTheMatrixAtTheGridsEdge) {
  for (const Basis basis : {Basis::linear, Basis::bspline2, Basis::bspline3, Basis::bspline4}) {
    SCOPED_TRACE(names_of(basis)[static_cast<std::size_t>(basis)]);
    mpm::Setup<2> setup = block_setup<2>(total_with(basis));
    setup.grid.first.fill(-1);
    setup.grid.count.fill(5);
    for (auto& X : setup.seeds.X) {
      for (double& x : X) x += 0.02;
    }
    for (std::size_t p = 0; p < setup.seeds.size(); ++p)
      setup.seeds.volumes.push_back(0.001 * static_cast<double>(p + 1));
    EXPECT_LT(difference(std::move(setup), 1), 1e-14);
  }
}

TEST(MassStencil, BasesWithCornersAndUpdatedFormulationsHaveNone) {
  EXPECT_EQ(mass_nodes_across<2>(total_with(Basis::cpdi)), 0);
  Method updated = total_with(Basis::bspline2);
  updated.formulation = Formulation::updated;
  EXPECT_EQ(mass_nodes_across<2>(updated), 0);
  Method lumped = total_with(Basis::bspline2);
  lumped.mass = Mass::lumped;
  EXPECT_EQ(mass_nodes_across<2>(lumped), 0);
}

}  // namespace
}  // namespace assay::mpm::test_mass_stencil
