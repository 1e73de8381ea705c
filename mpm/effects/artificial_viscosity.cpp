// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <cmath>

#include "mpm/kernels/affine.hpp"
#include "mpm/kernels/kernel_state.hpp"
#include "mpm/step/effect.hpp"

namespace assay::mpm {

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
void add_viscosity(State<Dim>& s, const Block& block, double linear, double quadratic, bool thins) {
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

/// After `stress`: an isotropic pressure q where the volume shrinks.
template <int Dim>
Pass<Dim> viscosity_pass(const Method& method) {
  return {{.name = "artificial_viscosity",
           .slot = {stress_phase(method), Part::last},
           .doc = "a pressure against shrinking, von Neumann and Richtmyer's",
           .reads = {Column::velocity_gradient, Column::deformation_gradient, Column::stress},
           .writes = {Column::stress}},
          [](State<Dim>& s) {
            const BasisTraits traits = traits_of<Dim>(s.method.basis);
            const bool thins = s.method.is_total() || traits.moves_corners || traits.uses_deformation;
            const auto [C1, C2] = option<ArtificialViscosity>(s.setup).C;
            const double linear = C1 * s.setup.wave_speed, quadratic = C2;
            return Kernel::over_blocks([&s, linear, quadratic, thins](const Instant&, const Block& block) {
              add_viscosity(s, block, linear, quadratic, thins);
              return none_bad;
            });
          }};
}

}  // namespace

template <int Dim>
EffectRecord<Dim> artificial_viscosity_effect() {
  EffectRecord<Dim> effect{230, "a viscous pressure in compression", "remedies.artificial_viscosity"};
  effect.called_for = [](const Setup<Dim>& s) { return option<ArtificialViscosity>(s).acts(); };
  effect.keys = [](EffectOptions& options, Keys& key) {
    auto& own = options.tell<ArtificialViscosity>();
    key("remedies.artificial_viscosity",
        "C1, C2 of the pressure rho h (C1 c + C2 h dV) dV in compression; dV is the rate of volume loss", own.C,
        {.range = {.lower = 0, .upper = 100}, .derived = "none", .shown = own.acts()});
  };
  effect.example = "[0.1, 1.5]";
  effect.refusal = [](const Method& method, const EffectOptions&) -> std::string {
    if (!method.has_stages()) return {};
    return "takes energy, which symplectic_rkn4 keeps: take leapfrog or symplectic_euler";
  };
  effect.in_title = [](const EffectOptions&) -> std::string { return "artificial viscosity"; };
  effect.passes = [](const Setup<Dim>& s) { return std::vector{viscosity_pass<Dim>(s.method)}; };
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> artificial_viscosity_effect();

}  // namespace assay::mpm
