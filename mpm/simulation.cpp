// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/simulation.hpp"

#include "mpm/material/stress_blocks.hpp"
#include "mpm/step/run_kernels.hpp"

namespace assay::mpm {

namespace {

template <int Dim>
Vector3 initial_velocity(const Setup<Dim>& setup, const Vector3& X) {
  if (const auto& given = setup.initial_velocity) {
    Vector3 v = Vector3::Zero();
    for (int d = 0; d < Dim; ++d) {
      v(d) = given->velocity[static_cast<std::size_t>(d)];
      for (int c = 0; c < Dim; ++c) v(d) += given->gradient[static_cast<std::size_t>(d * Dim + c)] * X(c);
    }
    return v;
  }
  if (!setup.frame) return (*setup.motion)->at(X, 0).v;
  return setup.frame->seen((*setup.motion)->at(setup.frame->body_point(X), 0), 0).v;
}

}  // namespace

template <int Dim>
Simulation<Dim>::Simulation(Setup<Dim> setup) : Simulation(setup, compose(setup)) {}

template <int Dim>
Simulation<Dim>::Simulation(Setup<Dim> setup, const std::vector<Pass<Dim>>& passes) : state_(std::move(setup)) {
  allocate(passes);
  fill();
  for (const EffectRecord<Dim>& effect : effects<Dim>()) {
    if (effect.prepare && effect.called_for(state_.setup)) effect.prepare(state_);
  }
  for (const auto& pass : passes) {
    kernels_.push_back(pass.bind(state_));
    PassTime time{pass.name, 0, 0, pass.updates_material};
    for (const auto* list : {&pass.reads, &pass.writes}) {
      for (const Column column : *list) time.bytes_per_particle += bytes_of(column, state_.setup);
    }
    time.bytes_per_particle *= times_a_step(pass, state_.setup.method);
    times_.push_back(std::move(time));
  }
  plan(passes);
}

template <int Dim>
void Simulation<Dim>::plan(const std::vector<Pass<Dim>>& passes) {
  const std::vector<SymplecticStage> parts = stages_of(state_.setup.method);
  for (const bool later : {false, true}) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
      Stage stage{parts[k], {}, {}, {}};
      for (std::size_t p = 0; p < passes.size(); ++p) {
        if (!runs_in(passes[p], k, parts.size(), later)) continue;
        stage.kernels.push_back(&kernels_[p]);
        stage.passes.push_back(p);
        stage.seconds.push_back(0);
      }
      steps_[later ? 1 : 0].push_back(std::move(stage));
    }
  }
}

template <int Dim>
void Simulation<Dim>::allocate(const std::vector<Pass<Dim>>& passes) {
  State<Dim>& s = state_;
  for (const ColumnUse& use : columns_of(passes, s.setup)) {
    if (use.column == Column::weights || use.column == Column::history) continue;  // the basis and its effect keep them
    const bool shared = s.setup.offload && (record_of<Dim>(use.column).roles & of_stress) != 0;
    const auto memory = shared ? s.setup.offload->allocate : nullptr;
    s.columns[static_cast<std::size_t>(use.column)].allocate(s.particles, static_cast<int>(use.bytes / sizeof(double)),
                                                             memory);
  }
  const std::size_t nodes = s.setup.grid.nodes();
  s.inertia.allocate(nodes);
  s.force.allocate(nodes);
  s.motion.allocate(nodes);
  s.tile_copies.resize(tile_copies(s.particles, s.setup.threads));
  for (TileCopy<Dim>& copy : s.tile_copies) {
    copy.inertia.allocate(nodes);
    copy.force.allocate(nodes);
  }
}

/// Particles in the reference configuration with the exact initial velocity: not zero, v = g'(0) h(R) E_z x X.
template <int Dim>
void Simulation<Dim>::fill() {
  State<Dim>& s = state_;
  const Seeds<Dim>& seeds = s.setup.seeds;
  for (std::size_t p = 0; p < s.particles; ++p) {
    Vector3 X = Vector3::Zero();
    for (int d = 0; d < Dim; ++d) {
      X(d) = seeds.X[static_cast<std::size_t>(d)][p];
      s.column(Column::reference_position, d)[p] = s.column(Column::position, d)[p] = X(d);
      s.column(Column::deformation_gradient, d * Dim + d)[p] = 1;
    }
    const double volume = seeds.volume(p);
    s.column(Column::mass)[p] = s.setup.density * volume;
    s.column(Column::volume)[p] = volume;
    for (int c = 0; s.setup.is_stressed() && c < stress_components<Dim>; ++c)
      s.column(Column::stress, c)[p] = component(s.setup.initial_cauchy, static_cast<int>(stress_row<Dim>(c)));
    if (!s.setup.motion && !s.setup.initial_velocity) continue;
    const Vector3 v = initial_velocity(s.setup, X);
    for (int d = 0; d < Dim; ++d) s.column(Column::velocity, d)[p] = v(d);
  }
}

template <int Dim>
const std::optional<Finding>& Simulation<Dim>::step(double t, double dt) {
  const bool staggered = state_.setup.method.integrator == Integrator::leapfrog;
  velocity_time_ = staggered ? t + 0.5 * dt : t + dt;
  for (Stage& stage : steps_[begun_ ? 1 : 0]) {
    const SymplecticStage& part = stage.part;
    const double kick = staggered ? 0.5 * (last_dt_ + dt) : part.kick * dt;  // from one half step to the next
    const Instant now(t + part.begin * dt, part.drift * dt, kick);
    run<Dim>(state_, stage.kernels, now, stage.seconds);
    for (std::size_t k = 0; k < stage.passes.size(); ++k) {
      times_[stage.passes[k]].seconds += stage.seconds[k];
      stage.seconds[k] = 0;
    }
  }
  begun_ = true;
  last_dt_ = dt;
  return state_.finding;
}

template class Simulation<ASSAY_DIMENSION>;

}  // namespace assay::mpm
