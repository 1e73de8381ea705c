// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/material/stress_blocks.hpp"

#include <algorithm>
#include <cmath>

#include "mpm/kernels/kernels.hpp"

namespace assay::mpm {

namespace {

/// Row of the ABI's nine components for in-plane component c of the columns.
template <int Dim>
constexpr std::size_t row_of(int c) {
  return static_cast<std::size_t>(3 * (c / Dim) + c % Dim);
}

/// F of a block after the step, F before and after as batches. The first particle whose det F is not positive.
template <int Dim>
std::optional<std::size_t> advance_block(const StressColumns<Dim>& columns, std::size_t begin, std::size_t n, double dt,
                                         BlockScratch<Dim>& scratch) {
  static const AdvanceDeformation<Dim> advance = advance_deformation<Dim>(best_instructions());
  Deformations<Dim> d;
  d.rate_of_F = columns.rate_of_F;
  for (int c = 0; c < Dim * Dim; ++c) {
    const auto k = static_cast<std::size_t>(c);
    d.F[k] = columns.deformation_gradient[k] + begin;
    d.rate[k] = columns.velocity_gradient[k] + begin;
    d.before[k] = scratch.F0() + row_of<Dim>(c) * n;
    d.now[k] = scratch.F1() + row_of<Dim>(c) * n;
  }
  const std::size_t bad = advance(d, n, dt);
  return bad == n ? std::nullopt : std::optional(begin + bad);
}

/// F scaled in the plane: for the material alone at both ends of the step, or for good at its end.
template <int Dim>
void scale_block(const StressColumns<Dim>& columns, std::size_t begin, std::size_t n, BlockScratch<Dim>& scratch) {
  const auto scale = [n](double* component, const double* factors) {
    for (std::size_t p = 0; p < n; ++p) component[p] *= factors[p];
  };
  for (int c = 0; c < Dim * Dim; ++c) {
    scale(scratch.F1() + row_of<Dim>(c) * n, columns.volume_scale + begin);
    if (columns.volume_scale_before) {
      scale(scratch.F0() + row_of<Dim>(c) * n, columns.volume_scale_before + begin);
    } else {
      scale(columns.deformation_gradient[static_cast<std::size_t>(c)] + begin, columns.volume_scale + begin);
    }
  }
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
  outcome.inverted = advance_block(columns, begin, n, now.dt, scratch);
  if (outcome.inverted) return outcome;
  if (columns.volume_scale) scale_block<Dim>(columns, begin, n, scratch);
  const double* state0 = state_size ? columns.history[0] + begin * state_size : nullptr;
  double* state1 = state_size ? columns.history[1] + begin * state_size : nullptr;
  const double length = std::abs(now.dt);  // back in time go models that ask for F alone, and the ABI promises dt > 0
  const UpdateReport report =
      material.update(now.t, length, n, scratch.F0(), scratch.F1(), state0, state1, scratch.cauchy());
  if (report.worst == ASSAY_FAILED) {
    outcome.refused = begin + report.worst_point;
    outcome.message = report.message;
    outcome.step = failed_step(now.t, length, n, report.worst_point, scratch.F0(), scratch.F1(), state0, state_size);
    return outcome;
  }
  if (state_size) std::copy_n(state1, n * state_size, columns.history[0] + begin * state_size);
  for (int c = 0; c < stress_components<Dim>; ++c) {
    std::copy_n(scratch.cauchy() + stress_row<Dim>(c) * n, n, columns.stress[static_cast<std::size_t>(c)] + begin);
  }
  return outcome;
}

template class BlockScratch<ASSAY_DIMENSION>;
template BlockOutcome update_block<ASSAY_DIMENSION>(const StressColumns<ASSAY_DIMENSION>&, const Material&, std::size_t,
                                                    std::size_t, const Instant&, BlockScratch<ASSAY_DIMENSION>&);

}  // namespace assay::mpm
