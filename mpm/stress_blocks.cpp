// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/stress_blocks.hpp"

#include <algorithm>

#include "mpm/basis.hpp"

namespace assay::mpm {

namespace {

/// Row of the ABI's nine components for in-plane component c of the columns.
template <int Dim>
constexpr std::size_t row_of(int c) {
  return static_cast<std::size_t>(3 * (c / Dim) + c % Dim);
}

/// Row of the ABI's nine components for component c of the stress column.
template <int Dim>
constexpr std::size_t stress_row(int c) {
  return c < Dim * Dim ? row_of<Dim>(c) : 8;  // 33 comes last in plane strain
}

/// F of a particle after the step.
template <int Dim>
Mat<Dim> advanced(const std::array<double*, Dim * Dim>& F, const std::array<const double*, Dim * Dim>& L, std::size_t p,
                  double dt, bool rate_of_F) {
  Mat<Dim> now;
  for (std::size_t i = 0; i < Dim; ++i) {
    for (std::size_t j = 0; j < Dim; ++j) {
      double rate = 0;
      if (rate_of_F) {
        rate = L[i * Dim + j][p];
      } else {
        for (std::size_t k = 0; k < Dim; ++k) rate += L[i * Dim + k][p] * F[k * Dim + j][p];
      }
      now[i * Dim + j] = F[i * Dim + j][p] + dt * rate;
    }
  }
  return now;
}

/// F of a block after the step, F before and after as batches. The first particle whose det F is not positive.
template <int Dim>
std::optional<std::size_t> advance_deformation(const StressColumns<Dim>& columns, std::size_t begin, std::size_t n,
                                               double dt, BlockScratch<Dim>& scratch) {
  std::array<double*, Dim * Dim> F, F1;
  std::array<const double*, Dim * Dim> L;
  for (int c = 0; c < Dim * Dim; ++c) {
    const auto k = static_cast<std::size_t>(c);
    F[k] = columns.deformation_gradient[k] + begin;
    L[k] = columns.velocity_gradient[k] + begin;
    F1[k] = scratch.F1() + row_of<Dim>(c) * n;
    std::copy_n(F[k], n, scratch.F0() + row_of<Dim>(c) * n);
  }
  std::optional<std::size_t> inverted;
  for (std::size_t p = 0; p < n; ++p) {
    const Mat<Dim> now = advanced<Dim>(F, L, p, dt, columns.rate_of_F);
    for (std::size_t c = 0; c < Dim * Dim; ++c) F[c][p] = F1[c][p] = now[c];
    if (!(determinant<Dim>(now) > 0) && !inverted) inverted = begin + p;
  }
  return inverted;
}

}  // namespace

template <int Dim>
BlockScratch<Dim>::BlockScratch(double* memory)
    : own_(memory ? 0 : doubles, 0.0), memory_(memory ? memory : own_.data()) {}

template <int Dim>
void BlockScratch<Dim>::resize(std::size_t n) {
  if (points_ == n) return;
  points_ = n;
  for (double* tensor : {F0(), F1()}) {
    std::fill_n(tensor, 9 * n, 0.0);
    for (const std::size_t diagonal : {0, 4, 8}) std::fill_n(tensor + diagonal * n, n, 1.0);
  }
  std::fill_n(cauchy(), 9 * n, 0.0);
}

template <int Dim>
BlockOutcome update_block(const StressColumns<Dim>& columns, const Material& material, std::size_t begin,
                          std::size_t end, const Instant& now, BlockScratch<Dim>& scratch) {
  const std::size_t n = end - begin, state_size = material.state_size();
  scratch.resize(n);
  BlockOutcome outcome;
  outcome.inverted = advance_deformation(columns, begin, n, now.dt, scratch);
  if (outcome.inverted) return outcome;
  const double* state0 = state_size ? columns.history[0] + begin * state_size : nullptr;
  double* state1 = state_size ? columns.history[1] + begin * state_size : nullptr;
  const UpdateReport report =
      material.update(now.t, now.dt, n, scratch.F0(), scratch.F1(), state0, state1, scratch.cauchy());
  if (report.worst == ASSAY_FAILED) {
    outcome.refused = begin + report.worst_point;
    outcome.message = report.message;
    outcome.step = failed_step(now.t, now.dt, n, report.worst_point, scratch.F0(), scratch.F1(), state0, state_size);
    return outcome;
  }
  if (state_size) std::copy_n(state1, n * state_size, columns.history[0] + begin * state_size);
  for (int c = 0; c < stress_components<Dim>; ++c) {
    std::copy_n(scratch.cauchy() + stress_row<Dim>(c) * n, n, columns.stress[static_cast<std::size_t>(c)] + begin);
  }
  return outcome;
}

template class BlockScratch<2>;
template class BlockScratch<3>;
template BlockOutcome update_block<2>(const StressColumns<2>&, const Material&, std::size_t, std::size_t,
                                      const Instant&, BlockScratch<2>&);
template BlockOutcome update_block<3>(const StressColumns<3>&, const Material&, std::size_t, std::size_t,
                                      const Instant&, BlockScratch<3>&);

}  // namespace assay::mpm
