// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/mass/mass_preconditioner.hpp"

#include <algorithm>

#include "mpm/data/dimension.hpp"

namespace assay::mpm {

template <int Dim>
MassPreconditioner<Dim>::MassPreconditioner(const GridGeometry<Dim>& grid,
                                            const std::array<std::vector<double>, Dim>& means) {
  for (std::size_t d = 0; d < Dim; ++d) factors_[d] = factor_of(static_cast<std::size_t>(grid.count[d]), means[d]);
}

template <int Dim>
auto MassPreconditioner<Dim>::factor_of(std::size_t nodes, const std::vector<double>& mean) -> Factor {
  Factor f{nodes, mean.size() - 1, {}, std::vector<double>(nodes)};
  f.lower.assign(nodes * f.reach, 0.0);
  const auto lower = [&](std::size_t i, std::size_t k) -> double& { return f.lower[i * f.reach + k - 1]; };
  std::vector<double> diagonal(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    diagonal[i] = mean[0];
    for (std::size_t k = std::min(i, f.reach); k > 0; --k) {
      double value = mean[k];
      for (std::size_t m = k + 1; m <= std::min(i, f.reach); ++m) {
        value -= lower(i, m) * diagonal[i - m] * lower(i - k, m - k);
      }
      lower(i, k) = value / diagonal[i - k];
      diagonal[i] -= lower(i, k) * value;
    }
    f.inverse_diagonal[i] = 1 / diagonal[i];
  }
  return f;
}

/// Of lines whose nodes are `inner` numbers apart, side by side.
template <int Dim>
void MassPreconditioner<Dim>::solve_lines(const Factor& f, double* x, std::size_t inner) {
  for (std::size_t i = 0; i < f.nodes; ++i) {
    for (std::size_t k = 1; k <= std::min(i, f.reach); ++k) {
      const double l = f.lower[i * f.reach + k - 1], *from = x + (i - k) * inner;
      double* to = x + i * inner;
      for (std::size_t c = 0; c < inner; ++c) to[c] -= l * from[c];
    }
  }
  for (std::size_t i = f.nodes; i-- > 0;) {
    double* to = x + i * inner;
    for (std::size_t c = 0; c < inner; ++c) to[c] *= f.inverse_diagonal[i];
    for (std::size_t k = 1; k <= std::min(f.nodes - 1 - i, f.reach); ++k) {
      const double l = f.lower[(i + k) * f.reach + k - 1], *from = x + (i + k) * inner;
      for (std::size_t c = 0; c < inner; ++c) to[c] -= l * from[c];
    }
  }
}

template <int Dim>
void MassPreconditioner<Dim>::solve(GridField<Dim>& x) const {
  std::size_t inner = GridField<Dim>::stride;
  const std::size_t all = x.nodes() * inner;
  for (const Factor& factor : factors_) {
    const std::size_t line = inner * factor.nodes;
    for (std::size_t begin = 0; begin < all; begin += line) solve_lines(factor, x.data() + begin, inner);
    inner = line;
  }
}

template class MassPreconditioner<ASSAY_DIMENSION>;

}  // namespace assay::mpm
