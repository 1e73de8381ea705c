// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/mass/mass_preconditioner.hpp"

#include <algorithm>
#include <type_traits>

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

/// Of lines that follow each other, whose nodes are `inner` numbers apart.
template <int Dim>
void MassPreconditioner<Dim>::solve_lines(const Factor& f, double* x, auto inner, std::size_t lines) {
  const auto each_line = [&](std::size_t i, const auto& body) {
    for (std::size_t line = 0; line < lines; ++line) body(x + (line * f.nodes + i) * inner);
  };
  for (std::size_t i = 0; i < f.nodes; ++i) {
    for (std::size_t k = 1; k <= std::min(i, f.reach); ++k) {
      each_line(i, [l = f.lower[i * f.reach + k - 1], back = k * inner, inner](double* to) {
        for (std::size_t c = 0; c < inner; ++c) to[c] -= l * (to - back)[c];
      });
    }
  }
  for (std::size_t i = f.nodes; i-- > 0;) {
    each_line(i, [by = f.inverse_diagonal[i], inner](double* to) {
      for (std::size_t c = 0; c < inner; ++c) to[c] *= by;
    });
    for (std::size_t k = 1; k <= std::min(f.nodes - 1 - i, f.reach); ++k) {
      each_line(i, [l = f.lower[(i + k) * f.reach + k - 1], on = k * inner, inner](double* to) {
        for (std::size_t c = 0; c < inner; ++c) to[c] -= l * (to + on)[c];
      });
    }
  }
}

/// Along the first axis each number waits for the one before it: several lines at once do not.
template <int Dim>
void MassPreconditioner<Dim>::solve(GridField<Dim>& x) const {
  constexpr std::size_t at_once = 8;
  constexpr std::integral_constant<std::size_t, GridField<Dim>::stride> narrow;
  std::size_t line = narrow * factors_[0].nodes;
  const std::size_t all = x.nodes() * narrow, lines = all / line;
  for (std::size_t first = 0; first < lines; first += at_once) {
    solve_lines(factors_[0], x.data() + first * line, narrow, std::min(at_once, lines - first));
  }
  for (std::size_t d = 1; d < Dim; ++d) {
    const std::size_t inner = line;
    line *= factors_[d].nodes;
    for (std::size_t begin = 0; begin < all; begin += line) solve_lines(factors_[d], x.data() + begin, inner, 1);
  }
}

template class MassPreconditioner<ASSAY_DIMENSION>;

}  // namespace assay::mpm
