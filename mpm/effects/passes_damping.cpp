// SPDX-License-Identifier: BSD-3-Clause
// What keeps light nodes and shocks from throwing particles about.
#include <Eigen/Eigenvalues>
#include <cmath>

#include "mpm/data/dimension.hpp"
#include "mpm/effects/passes_remedies.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/kernels/column_access.hpp"
#include "mpm/setup/with_basis.hpp"

namespace assay::mpm {

namespace {

template <int Dim>
void share_forces(State<Dim>& s, double whole, double kick) {
  std::array<double, Dim> left{};
  s.live.each([&](std::size_t i) {
    const double m = s.inertia.node(i)[0], least = whole * s.images.share(i);
    if (!(m > 0 && m < least)) return;
    double* force = s.force.node(i);
    for (std::size_t d = 0; d < Dim; ++d) {
      left[d] += kick * (1 - m / least) * force[d];
      force[d] *= m / least;
    }
  });
  for (std::size_t d = 0; d < Dim; ++d) s.ledger.impulse[d] -= left[d];
}

}  // namespace

template <int Dim>
Pass<Dim> small_mass_pass() {
  Pass<Dim> pass;
  pass.name = "small_mass";
  pass.doc = "light nodes take up force in proportion to their mass";
  pass.called_for_by = "remedies.small_mass";
  pass.effects = {Effect::small_mass};
  pass.grid_fields = {"mass", "force"};
  pass.bind = [](State<Dim>& s) -> Kernel {
    const double least = s.setup.remedies.small_mass * s.setup.density * std::pow(s.setup.grid.spacing, Dim);
    return [&s, least](const Instant& now) { share_forces(s, least, now.kick); };
  };
  return pass;
}

namespace {

/// The smallest stretch of F, by its inverse G: 1 / |G|.
template <int Dim>
double smallest_stretch(const Mat<Dim>& inverse_of_F) {
  using Matrix = Eigen::Matrix<double, Dim, Dim, Eigen::RowMajor>;
  const Eigen::Map<const Matrix> G(inverse_of_F.data());
  Eigen::SelfAdjointEigenSolver<Matrix> squares;
  squares.computeDirect(G * G.transpose(), Eigen::EigenvaluesOnly);
  return 1 / std::sqrt(squares.eigenvalues()[Dim - 1]);
}

/// q = rho h (C1 c + C2 h |tr D|) |tr D| where tr D < 0, rho = rho0/J; h a cell's width, where the cell
/// of the total formulation or the particle's domain deforms by F that where it is thinnest. [Pa]
template <int Dim>
void add_viscosity(State<Dim>& s, const Block& block, bool thins) {
  const Remedies& remedies = s.setup.remedies;
  const double linear = remedies.viscosity[0] * remedies.viscosity_speed, quadratic = remedies.viscosity[1];
  const auto F = components<Dim * Dim>(s, Column::deformation_gradient);
  const auto rate = components<Dim * Dim>(s, Column::velocity_gradient);
  const auto stress = components<stress_components<Dim>>(s, Column::stress);
  const bool rate_of_F = s.method.is_total();
  for (std::size_t p = block.begin; p < block.end; ++p) {
    const Mat<Dim> f = load(F, p);
    Mat<Dim> L = load(rate, p);
    double h = s.setup.grid.spacing;
    const Mat<Dim> inverse_of_F = inverse<Dim>(f);
    if (rate_of_F) L = product<Dim>(L, inverse_of_F);
    if (thins) h *= smallest_stretch<Dim>(inverse_of_F);
    double trace = 0;
    for (std::size_t d = 0; d < Dim; ++d) trace += L[d * (Dim + 1)];
    if (!(trace < 0)) continue;
    const double q = s.setup.density / determinant<Dim>(f) * h * (linear - quadratic * h * trace) * -trace;
    for (std::size_t d = 0; d < Dim; ++d) stress[stress_index<Dim>(d, d)][p] -= q;
    if constexpr (Dim == 2) stress[4][p] -= q;
  }
}

}  // namespace

template <int Dim>
Pass<Dim> viscosity_pass(const Method&) {
  Pass<Dim> pass;
  pass.name = "artificial_viscosity";
  pass.doc = "a pressure against shrinking, von Neumann and Richtmyer's";
  pass.called_for_by = "remedies.artificial_viscosity";
  pass.effects = {Effect::artificial_viscosity};
  pass.reads = {Column::velocity_gradient, Column::deformation_gradient, Column::stress};
  pass.writes = {Column::stress};
  pass.bind = [](State<Dim>& s) -> Kernel {
    const BasisTraits traits = traits_of<Dim>(s.method.basis);
    const bool thins = s.method.is_total() || traits.moves_corners || traits.uses_deformation;
    Kernel kernel;
    kernel.block = [&s, thins](const Instant&, const Block& block) {
      add_viscosity(s, block, thins);
      return none_bad;
    };
    return kernel;
  };
  return pass;
}

template Pass<ASSAY_DIMENSION> small_mass_pass<ASSAY_DIMENSION>();
template Pass<ASSAY_DIMENSION> viscosity_pass<ASSAY_DIMENSION>(const Method&);

}  // namespace assay::mpm
