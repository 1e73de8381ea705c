// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/mass/mass_preconditioner.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mpm/mass/mass_matrix.hpp"
#include "tests/mpm/basis_cases.hpp"
#include "tests/mpm/grid_fields.hpp"
#include "tests/mpm/vortex_setup.hpp"

namespace assay::mpm::test_mass_preconditioner {
namespace {

/// Symbols from 0.03 (as for cubic splines) to one.
const std::vector<double> cubic{0.48, 0.236, 0.0236, 0.0004}, linear{2.0 / 3, 1.0 / 6};

/// y = T x of a Toeplitz matrix along one axis.
template <int Dim>
GridField<Dim> product(const GridGeometry<Dim>& grid, const GridField<Dim>& x, std::size_t axis,
                       const std::vector<double>& mean) {
  GridField<Dim> y;
  y.allocate(x.nodes());
  std::size_t stride = 1;
  for (std::size_t d = 0; d < axis; ++d) stride *= static_cast<std::size_t>(grid.count[d]);
  for (std::size_t i = 0; i < x.nodes(); ++i) {
    const auto at = static_cast<int>(i / stride) % grid.count[axis], reach = static_cast<int>(mean.size()) - 1;
    for (int step = -reach; step <= reach; ++step) {
      if (at + step < 0 || at + step >= grid.count[axis]) continue;
      const std::size_t j = i + static_cast<std::size_t>(step) * stride;
      for (std::size_t d = 0; d < Dim; ++d)
        y.node(i)[d] += mean[static_cast<std::size_t>(std::abs(step))] * x.node(j)[d];
    }
  }
  return y;
}

template <int Dim>
void expect_inverse(const GridGeometry<Dim>& grid, const std::array<std::vector<double>, Dim>& means) {
  GridField<Dim> x;
  x.allocate(grid.nodes());
  Random random{3};
  for (std::size_t i = 0; i < x.nodes(); ++i) {
    for (std::size_t d = 0; d < Dim; ++d) x.node(i)[d] = random();
  }
  GridField<Dim> y = copied(x);
  for (std::size_t d = 0; d < Dim; ++d) y = product<Dim>(grid, y, d, means[d]);
  MassPreconditioner<Dim>(grid, means).solve(y);
  // round-off times the condition of the product, at most 1 / 0.03^Dim
  const double bound = 1e-15 * std::pow(40, Dim);
  for (std::size_t i = 0; i < x.nodes(); ++i) {
    for (std::size_t d = 0; d < Dim; ++d) EXPECT_NEAR(y.node(i)[d], x.node(i)[d], bound);
  }
}

TEST(MassPreconditioner, InvertsTheProductOfItsLines) {
  expect_inverse<2>({1, {0, 0}, {17, 9}}, {cubic, cubic});
  expect_inverse<2>({1, {-4, 7}, {2, 30}}, {cubic, linear});
  expect_inverse<2>({1, {0, 0}, {5, 6}}, {std::vector{1.0}, linear});
  expect_inverse<3>({1, {0, 0, 0}, {6, 7, 8}}, {linear, cubic, linear});
}

TEST(MassPreconditioner, ItsMeansAreSharesOfTheMatrix) {
  for (const Basis basis : {Basis::linear, Basis::bspline2, Basis::bspline3, Basis::bspline4}) {
    Method method;
    method.basis = basis, method.formulation = Formulation::total, method.mass = Mass::series;
    Simulation<2> simulation(square_setup(4, true, method));
    simulation.step(0, 1e-4);
    State<2>& s = simulation.state();
    const MassStencil<2> stencil(s.setup.grid, mass_nodes_across<2>(method),
                                 [&](const GridField<2>& x, GridField<2>& y) {
                                   y.zero();
                                   kernels_for(s).multiply_mass(s, Block{0, s.particles, nullptr, y.data()}, x.data());
                                 },
                                 {});
    for (const auto& mean : stencil.means()) {
      double symbol = 0, sum = 0;  // of the shortest wave, and of the longest
      for (std::size_t k = 0; k < mean.size(); ++k) {
        sum += (k == 0 ? 1 : 2) * mean[k];
        symbol += (k == 0 ? 1 : 2) * (k % 2 == 0 ? 1 : -1) * mean[k];
      }
      EXPECT_NEAR(sum, 1, 1e-14);
      EXPECT_GT(symbol, 0);
      if (basis != Basis::linear) continue;
      EXPECT_NEAR(mean[0], 2.0 / 3, 1e-14);  // two Gauss points integrate it exactly
    }
  }
}

}  // namespace
}  // namespace assay::mpm::test_mass_preconditioner
