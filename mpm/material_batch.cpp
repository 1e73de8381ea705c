// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/material_batch.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>

#include "mpm/blocks.hpp"

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

}  // namespace

template <int Dim>
void MaterialBatches<Dim>::Scratch::resize(std::size_t n) {
  if (points == n) return;
  points = n;
  for (std::vector<double>* tensor : {&F0, &F1}) {  // out-of-plane components of plane strain, once
    tensor->assign(9 * n, 0.0);
    for (const std::size_t diagonal : {0, 4, 8}) {
      std::fill_n(tensor->begin() + static_cast<std::ptrdiff_t>(diagonal * n), n, 1.0);
    }
  }
  cauchy.assign(9 * n, 0.0);
}

template <int Dim>
MaterialBatches<Dim>::MaterialBatches(State<Dim>& state, bool reads_increment)
    : state_(&state), reads_increment_(reads_increment), state_size_(state.setup.material->state_size()) {
  const int threads = state.setup.threads;
  const int instances = state.setup.material->has(ASSAY_THREAD_SAFE) ? 1 : threads;
  for (int k = 0; k < instances; ++k) instances_.push_back(state.setup.material->clone());
  scratch_.resize(static_cast<std::size_t>(threads));
  if (state_size_ == 0) return;
  for (std::size_t begin = 0; begin < state.particles; begin += block_size) {
    const std::size_t n = std::min(block_size, state.particles - begin);
    const std::vector<double> rest = instances_[0].initial_state(n, {}, directions(begin, n));
    std::copy(rest.begin(), rest.end(), state.history[0].begin() + static_cast<std::ptrdiff_t>(begin * state_size_));
  }
}

/// The material direction of n particles at rest, 3 * n. The vortex's response is the same all around the ring because
/// it turns with the reference angle.
template <int Dim>
std::vector<double> MaterialBatches<Dim>::directions(std::size_t begin, std::size_t n) const {
  const State<Dim>& s = *state_;
  const auto& d = s.setup.material_direction;
  const bool polar = s.setup.motion && std::holds_alternative<Vortex>(*s.setup.motion);
  std::vector<double> found(3 * n);
  for (std::size_t p = 0; p < n; ++p) {
    const double X = s.column(Column::reference_position, 0)[begin + p];
    const double Y = s.column(Column::reference_position, 1)[begin + p], R = std::hypot(X, Y);
    const double c = polar && R > 0 ? X / R : 1, sine = polar && R > 0 ? Y / R : 0;
    found[p] = c * d[0] - sine * d[1];
    found[n + p] = sine * d[0] + c * d[1];
    found[2 * n + p] = d[2];
  }
  return found;
}

/// det F <= 0 or not a number: the first such particle.
template <int Dim>
std::optional<std::size_t> MaterialBatches<Dim>::advance_deformation(std::size_t begin, std::size_t n, double dt,
                                                                     Scratch& scratch) {
  State<Dim>& s = *state_;
  std::array<double*, Dim * Dim> F, L, F1;
  for (int c = 0; c < Dim * Dim; ++c) {
    const auto k = static_cast<std::size_t>(c);
    F[k] = s.column(Column::deformation_gradient, c) + begin;
    L[k] = s.column(Column::velocity_gradient, c) + begin;
    F1[k] = scratch.F1.data() + row_of<Dim>(c) * n;
    std::copy_n(F[k], n, scratch.F0.data() + row_of<Dim>(c) * n);
  }
  std::optional<std::size_t> inverted;
  for (std::size_t p = 0; p < n; ++p) {
    Mat<Dim> now;
    for (std::size_t i = 0; i < Dim; ++i) {
      for (std::size_t j = 0; j < Dim; ++j) {
        double sum = 0;
        for (std::size_t k = 0; k < Dim; ++k) sum += L[i * Dim + k][p] * F[k * Dim + j][p];
        now[i * Dim + j] = F[i * Dim + j][p] + dt * sum;
      }
    }
    for (std::size_t c = 0; c < Dim * Dim; ++c) F[c][p] = F1[c][p] = now[c];
    if (!(determinant<Dim>(now) > 0) && !inverted) inverted = begin + p;
  }
  return inverted;
}

template <int Dim>
typename MaterialBatches<Dim>::Outcome MaterialBatches<Dim>::update(std::size_t begin, std::size_t end,
                                                                    const Instant& now) {
  State<Dim>& s = *state_;
  const std::size_t n = end - begin;
  const auto thread = static_cast<std::size_t>(omp_get_thread_num());
  Scratch& scratch = scratch_[thread];
  scratch.resize(n);
  Outcome outcome;
  outcome.inverted = advance_deformation(begin, n, now.dt, scratch);
  if (outcome.inverted) return outcome;
  const Material& material = instances_[instances_.size() == 1 ? 0 : thread];
  const double* state0 = state_size_ ? s.history[0].data() + begin * state_size_ : nullptr;
  double* state1 = state_size_ ? s.history[1].data() + begin * state_size_ : nullptr;
  const UpdateReport report =
      material.update(now.t, now.dt, n, scratch.F0.data(), scratch.F1.data(), state0, state1, scratch.cauchy.data());
  if (report.worst == ASSAY_FAILED) {
    outcome.refused = begin + report.worst_point;
    outcome.message = report.message;
    outcome.step =
        failed_step(now.t, now.dt, n, report.worst_point, scratch.F0.data(), scratch.F1.data(), state0, state_size_);
    return outcome;
  }
  if (state_size_) std::copy_n(state1, n * state_size_, s.history[0].data() + begin * state_size_);
  for (int c = 0; c < stress_components<Dim>; ++c) {
    std::copy_n(scratch.cauchy.data() + stress_row<Dim>(c) * n, n, s.column(Column::stress, c) + begin);
  }
  return outcome;
}

template class MaterialBatches<2>;
template class MaterialBatches<3>;

}  // namespace assay::mpm
