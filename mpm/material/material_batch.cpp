// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/material/material_batch.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "harness/material/material_failure.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "mpm/data/blocks.hpp"
#include "mpm/data/crew.hpp"

namespace assay::mpm {

namespace {

template <int Dim>
StressColumns<Dim> columns_of(State<Dim>& s) {
  StressColumns<Dim> columns;
  for (int c = 0; c < tensor_components<Dim>; ++c) {
    const auto k = static_cast<std::size_t>(c);
    columns.deformation_gradient[k] = s.column(Column::deformation_gradient, c);
    columns.velocity_gradient[k] = s.column(Column::velocity_gradient, c);
  }
  for (int c = 0; c < stress_components<Dim>; ++c) {
    columns.stress[static_cast<std::size_t>(c)] = s.column(Column::stress, c);
  }
  auto& history = s.template own<MaterialHistory>();
  columns.history = {history.begin.data(), history.end.data()};
  if (s.has(Column::volume_scale)) {
    columns.volume_scale = s.column(Column::volume_scale, 0);
    if (s.setup.method.is_total()) columns.volume_scale_before = s.column(Column::volume_scale, 1);
  }
  columns.rate_of_F = s.setup.method.is_total();
  return columns;
}

template <int Dim>
void end_stress(State<Dim>& s, BlockOutcome outcome) {
  s.material_calls += static_cast<std::int64_t>(s.particles);
  if (outcome.inverted) {
    const std::size_t p = *outcome.inverted;
    bool number = true;
    for (int c = 0; c < tensor_components<Dim>; ++c) {
      number = number && std::isfinite(s.column(Column::deformation_gradient, c)[p]);
    }
    s.finding = Finding{
        Finding::Kind::unstable, number ? "det F <= 0" : "F is not a finite number", static_cast<std::int64_t>(p), {}};
  } else if (outcome.refused) {
    s.finding = Finding{Finding::Kind::material_failed, outcome.message, static_cast<std::int64_t>(*outcome.refused),
                        std::move(outcome.step)};
  }
}

template <int Dim>
Kernel stress_kernel(State<Dim>& s) {
  auto materials = std::make_shared<MaterialBatches<Dim>>(s);
  if (s.setup.offload) return [&s, materials](const Instant& now) { end_stress(s, materials->update_elsewhere(now)); };
  return Kernel::over_blocks(
      [materials](const Instant& now, const Block& block) { return materials->update(block.begin, block.end, now); },
      [&s, materials](const Instant&, std::optional<std::size_t>) { end_stress(s, materials->take_first()); });
}

}  // namespace

template <int Dim>
MaterialBatches<Dim>::MaterialBatches(State<Dim>& state) : state_(&state), columns_(columns_of(state)) {
  const int threads = state.setup.threads;
  const int instances = state.setup.material->has(ASSAY_THREAD_SAFE) ? 1 : threads;
  try {
    for (int k = 0; k < instances; ++k) instances_.push_back(state.setup.material->clone());
  } catch (const std::runtime_error& error) {  // with parameters that it has taken before
    MaterialFailure failure(error.what(), 0, 0);
    failure.final = true;
    throw failure;
  }
  for (int k = 0; k < threads; ++k) scratch_.emplace_back();
  const std::size_t state_size = state.setup.material->state_size();
  const bool directed = has_direction(state.setup.material->table());
  for (std::size_t begin = 0; state_size && begin < state.particles; begin += block_size) {
    const std::size_t n = std::min(block_size, state.particles - begin);
    std::vector<double> stress(state.setup.is_stressed() ? 9 * n : 0);
    for (std::size_t p = 0; !stress.empty() && p < n; ++p) put_tensor(state.setup.initial_cauchy, stress.data(), n, p);
    const std::vector<double> rest =
        instances_[0].initial_state(n, stress, directed ? directions(begin, n) : std::vector<double>());
    std::copy(rest.begin(), rest.end(), columns_.history[0] + begin * state_size);
  }
  if (state.setup.offload) state.setup.offload->place(columns_);
}

namespace {

/// At the particles of a motion in space, as the frame sees them at rest. What no vortex holds is never stressed.
template <int Dim>
std::vector<double> directions_in_space(const State<Dim>& s, std::size_t begin, std::size_t n) {
  const Vector3 given(s.setup.material_direction[0], s.setup.material_direction[1], s.setup.material_direction[2]);
  const Motion* motion = s.setup.motion ? &*s.setup.motion : nullptr;
  const Vortex3d* vortex = motion ? motion->as<Vortex3d>() : nullptr;
  const std::optional<Annulus> ring = motion ? ring_of(*motion) : std::nullopt;
  const Tensor turn = s.setup.frame ? s.setup.frame->rotation(0) : Tensor(Tensor::Identity());
  std::vector<double> found(3 * n);
  for (std::size_t p = 0; p < n; ++p) {
    const std::array<double, 3> at = s.template at<3>(Column::reference_position, begin + p);
    const Vector3 X = turn.transpose() * Vector3(at[0], at[1], at[2]);
    Tensor axes = Tensor::Identity();
    if (const auto place = vortex ? vortex->place(X) : std::nullopt) axes = place->axes();
    if (ring) axes = Eigen::AngleAxisd(std::atan2(X.y(), X.x()), Vector3::UnitZ()).toRotationMatrix();
    const Vector3 direction = turn * axes * given;
    for (int d = 0; d < 3; ++d) found[static_cast<std::size_t>(d) * n + p] = direction(d);
  }
  return found;
}

}  // namespace

/// The material direction of n particles at rest, 3 * n. The vortex's response is the same all around the ring because
/// it turns with the reference angle.
template <int Dim>
std::vector<double> MaterialBatches<Dim>::directions(std::size_t begin, std::size_t n) const {
  const State<Dim>& s = *state_;
  if constexpr (Dim == 3) return directions_in_space(s, begin, n);
  const auto& d = s.setup.material_direction;
  const bool polar = s.setup.motion && ring_of(*s.setup.motion);
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

template <int Dim>
std::size_t MaterialBatches<Dim>::update(std::size_t begin, std::size_t end, const Instant& now) {
  const auto thread = static_cast<std::size_t>(crew_member());
  const Material& material = instances_[instances_.size() == 1 ? 0 : thread];
  BlockOutcome outcome = update_block(columns_, material, begin, end, now, scratch_[thread]);
  const std::size_t bad = FirstOutcome::place(outcome);
  if (bad != none_bad) first_.note(std::move(outcome));
  return bad;
}

template <int Dim>
BlockOutcome MaterialBatches<Dim>::update_elsewhere(const Instant& now) {
  const Setup<Dim>& setup = state_->setup;
  const std::size_t blocks = blocks_of(state_->particles);
  const auto threads = static_cast<std::size_t>(setup.threads);
  share_out(setup.threads, threads, [&](std::size_t k) {
    const std::size_t begin = k * blocks / threads * block_size;
    const std::size_t end = std::min(state_->particles, (k + 1) * blocks / threads * block_size);
    if (begin < end) first_.note(setup.offload->update(k, begin, end, now));
  });
  return first_.take();
}

template class MaterialBatches<ASSAY_DIMENSION>;

template <int Dim>
Pass<Dim> stress_pass(bool with_history) {
  Pass<Dim> pass{{.name = "stress",
                  .doc = "deformation gradient from L, Cauchy stress from the material",
                  .called_for_by = "material.adapter",
                  .reads = {Column::velocity_gradient, Column::deformation_gradient},
                  .writes = {Column::deformation_gradient, Column::stress},
                  .updates_material = true},
                 stress_kernel<Dim>};
  if (with_history) {
    pass.reads.push_back(Column::history);
    pass.writes.push_back(Column::history);
  }
  return pass;
}

template Pass<ASSAY_DIMENSION> stress_pass<ASSAY_DIMENSION>(bool);

}  // namespace assay::mpm
