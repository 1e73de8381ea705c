// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/polar_radii.hpp"

#include <cmath>

#include "harness/numeric/vector_clones.h"

namespace assay {

namespace {

/// balances: of the vortex.
ASSAY_VECTOR_CLONES void static_force(std::size_t n, const double* __restrict R, const double* __restrict h,
                                      const double* __restrict h_prime, const double* __restrict xi,
                                      const double* __restrict xi_slope, const double* __restrict tau,
                                      const double* __restrict slopes, double g, double density, bool balances,
                                      double* __restrict r, double* __restrict theta, double* __restrict z) {
  constexpr double error_at_most = 1e-5;
  const double *t11 = tau, *t12 = tau + n, *t21 = tau + 3 * n, *t22 = tau + 4 * n, *t31 = tau + 6 * n;
  const double *d11 = slopes, *d12 = slopes + n, *d21 = slopes + 3 * n, *d22 = slopes + 4 * n, *d31 = slopes + 6 * n;
  const double balanced = balances ? 1 : 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double pushed = 2 * g * xi[i] * t11[i], pushed_slope = 2 * g * xi[i] * d11[i] + 2 * g * t11[i];
    const double half = 0.5 * (t12[i] + pushed - t21[i]), half_slope = 0.5 * (d12[i] + pushed_slope - d21[i]);
    double most = std::abs(t11[i]), most_slope = std::abs(d11[i]);
    most = std::abs(t12[i]) > most ? std::abs(t12[i]) : most;
    most = std::abs(t21[i]) > most ? std::abs(t21[i]) : most;
    most = std::abs(t22[i]) > most ? std::abs(t22[i]) : most;
    most_slope = std::abs(d12[i]) > most_slope ? std::abs(d12[i]) : most_slope;
    most_slope = std::abs(d21[i]) > most_slope ? std::abs(d21[i]) : most_slope;
    most_slope = std::abs(d22[i]) > most_slope ? std::abs(d22[i]) : most_slope;
    const double near = std::abs(half) > error_at_most * most ? 0 : balanced;
    const double fits = std::abs(half_slope) > error_at_most * most_slope ? 0 : near;
    const double s21 = t21[i] + fits * half, s12 = fits > 0 ? s21 - pushed : t12[i];
    const double s21_slope = d21[i] + fits * half_slope;
    const double turned = g * h_prime[i];
    const double along_r = xi_slope[i] * d11[i] - turned * s21 + (t11[i] - t22[i]) / R[i];      // (26)
    const double along_theta = xi_slope[i] * s21_slope + turned * t11[i] + (s12 + s21) / R[i];  // (27)
    const double along_z = xi_slope[i] * d31[i] + t31[i] / R[i];
    const bool moves = !balances || h[i] != 0 || xi_slope[i] != 0;
    r[i] = moves ? -along_r / density : 0;
    theta[i] = moves ? -along_theta / density : 0;
    z[i] = moves ? -along_z / density : 0;
  }
}

}  // namespace

void ForceColumns::set(const RadiusColumns& radii, const std::vector<double>& tau, const std::vector<double>& slopes,
                       double g, double density) {
  const std::size_t n = radii.R.size();
  for (auto* column : {&r, &theta, &z}) column->resize(n);
  static_force(n, radii.R.data(), radii.h.data(), radii.h_prime.data(), radii.xi.data(), radii.xi_slope.data(),
               tau.data(), slopes.data(), g, density, radii.radial.empty(), r.data(), theta.data(), z.data());
}

}  // namespace assay
