// SPDX-License-Identifier: BSD-3-Clause
// F and volume after a step, of many particles.
#include "mpm/kernels/kernels.hpp"
#include "mpm/kernels/variants/basis_of.hpp"

namespace assay::mpm::ASSAY_INSTRUCTIONS {

template <int Dim>
std::size_t advance(const Deformations<Dim>& d, std::size_t n, double dt);

namespace {

template <int Dim, bool RateOfF>
ASSAY_INLINE std::size_t advance_by(const Deformations<Dim>& d, std::size_t n, double dt) {
  constexpr int N = Dim * Dim;
  double *F[N], *before[N], *now[N];
  const double* rate[N];
  for (int c = 0; c < N; ++c) {
    const auto k = static_cast<std::size_t>(c);
    F[c] = d.F[k], before[c] = d.before[k], now[c] = d.now[k], rate[c] = d.rate[k];
  }
  double good = 1;
  ASSAY_INDEPENDENT
  for (std::size_t p = 0; p < n; ++p) {
    double old[N];
    Mat<Dim> after;
    for (int c = 0; c < N; ++c) old[c] = F[c][p];
    for (int i = 0; i < Dim; ++i) {
      for (int j = 0; j < Dim; ++j) {
        double change = 0;
        if constexpr (RateOfF) {
          change = rate[i * Dim + j][p];
        } else {
          for (int k = 0; k < Dim; ++k) change += rate[i * Dim + k][p] * old[k * Dim + j];
        }
        after[i * Dim + j] = old[i * Dim + j] + dt * change;
      }
    }
    good = determinant<Dim>(after) > 0 ? good : 0;
    for (int c = 0; c < N; ++c) before[c][p] = old[c], F[c][p] = now[c][p] = after[c];
  }
  if (good > 0) return n;
  for (std::size_t p = 0; p < n; ++p) {
    Mat<Dim> after;
    for (int c = 0; c < N; ++c) after[c] = now[c][p];
    if (!(determinant<Dim>(after) > 0)) return p;
  }
  return n;
}

}  // namespace

template <int Dim>
std::size_t advance(const Deformations<Dim>& d, std::size_t n, double dt) {
  return d.rate_of_F ? advance_by<Dim, true>(d, n, dt) : advance_by<Dim, false>(d, n, dt);
}

template std::size_t advance(const Deformations<ASSAY_DIMENSION>&, std::size_t, double);

}  // namespace assay::mpm::ASSAY_INSTRUCTIONS
