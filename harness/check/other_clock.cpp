// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/other_clock.hpp"

#include <algorithm>
#include <cstring>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "harness/material/offer.hpp"

namespace assay::check {

namespace {

struct ClockTable : assay_material {
  const assay_material* inner;
  double pace;
};

/// What the model is, and what it offers.
struct Instance {
  const ClockTable* table;
  void* inner;

  template <class Extension>
  Offer<Extension> offered() const {
    return {*table->inner, inner};
  }
};

Instance& of(void* self) { return *static_cast<Instance*>(self); }

assay_step paced(const Instance& i, const assay_step& step) {
  return {i.table->pace * step.t, i.table->pace * step.dt, step.F0, step.F1};
}

void* create_of(const assay_material* table, const double* parameters, char* message) {
  const auto* own = static_cast<const ClockTable*>(table);
  void* inner = create_instance(own->inner, parameters, message);
  return inner ? new Instance{own, inner} : nullptr;
}

void destroy(void* self) {
  of(self).table->inner->destroy(of(self).inner);
  delete static_cast<Instance*>(self);
}

std::int32_t initial_state(void* self, std::size_t n, const double* cauchy, double* state) {
  return call_model(*of(self).table->inner, "initial_state", of(self).table->inner->initial_state, of(self).inner, n,
                    cauchy, state);
}

void update(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1, double* cauchy,
            std::int32_t* status, double* dt_factor, char* message) {
  const assay_step own = paced(of(self), *step);
  const assay_material& inner = *of(self).table->inner;
  const std::string thrown = thrown_by(
      inner.update, [&] { inner.update(of(self).inner, &own, n, state0, state1, cauchy, status, dt_factor, message); });
  if (!thrown.empty()) throw ModelThrew(inner.name, "update", thrown);
}

std::int32_t tangent(void* self, const assay_step* step, std::size_t n, const double* state0, double* found) {
  const assay_step own = paced(of(self), *step);
  return of(self).offered<assay_tangent>()(&own, n, state0, found);
}

std::int32_t energy(void* self, std::size_t n, const double* F, const double* state, double* found) {
  return of(self).offered<assay_energy>()(n, F, state, found);
}

std::int32_t wave_speed(void* self, double density, std::size_t n, const double* F, const double* cauchy,
                        const double* state, double* found) {
  return of(self).offered<assay_wave_speed>()(density, n, F, cauchy, state, found);
}

std::int32_t closed_form(void* self, std::int32_t baseline, std::size_t n, const double* eps, double* tau,
                         double* slope) {
  return of(self).offered<assay_closed_form>()(baseline, n, eps, tau, slope);
}

/// A rate per unit of this clock is `pace` times that per second.
std::int32_t rate(void* self, double t, std::size_t n, const double* F, const double* velocity_gradient,
                  const double* cauchy, const double* state, double* cauchy_rate, double* state_rate) {
  const Instance& i = of(self);
  const double pace = i.table->pace;
  std::vector<double> per_second(velocity_gradient, velocity_gradient + 9 * n);
  for (double& component : per_second) component /= pace;
  const std::int32_t found =
      i.offered<assay_rate>()(pace * t, n, F, per_second.data(), cauchy, state, cauchy_rate, state_rate);
  std::size_t variables = 0;
  for (std::size_t v = 0; v < i.table->state_count; ++v)
    variables += static_cast<std::size_t>(components_of_kind(i.table->state[v].kind));
  std::for_each(cauchy_rate, cauchy_rate + 9 * n, [=](double& each) { each *= pace; });
  std::for_each(state_rate, state_rate + variables * n, [=](double& each) { each *= pace; });
  return found;
}

const char* reason(void* self) { return of(self).offered<assay_reason>()(); }

const void* extension_of_clock(const assay_material* table, const char* id) {
  static const assay_rate rates{sizeof rates, rate};
  static const assay_tangent tangents{sizeof tangents, tangent};
  static const assay_energy energies{sizeof energies, energy};
  static const assay_wave_speed speeds{sizeof speeds, wave_speed};
  static const assay_closed_form forms{sizeof forms, closed_form};
  static const assay_reason reasons{sizeof reasons, reason};
  const std::pair<const char*, const void*> own[] = {
      {ASSAY_EXTENSION_RATE, &rates},        {ASSAY_EXTENSION_TANGENT, &tangents},  {ASSAY_EXTENSION_ENERGY, &energies},
      {ASSAY_EXTENSION_WAVE_SPEED, &speeds}, {ASSAY_EXTENSION_CLOSED_FORM, &forms}, {ASSAY_EXTENSION_REASON, &reasons}};
  const void* const offered = extension_of(static_cast<const ClockTable*>(table)->inner, id);
  if (!offered) return nullptr;
  for (const char* plain : {ASSAY_EXTENSION_EXAMPLE, ASSAY_EXTENSION_SYMMETRY}) {
    if (std::string(id) == plain) return offered;  // no functions
  }
  for (const auto& [name, ours] : own) {
    if (std::string(id) == name) return ours;
  }
  return nullptr;
}

const assay_material* table_at_pace(const assay_material& inner, double pace) {
  static std::mutex guard;
  static std::vector<std::unique_ptr<ClockTable>> all;
  auto table = std::make_unique<ClockTable>();
  static_cast<assay_material&>(*table) = assay_material{};
  std::memcpy(static_cast<assay_material*>(table.get()), &inner,
              std::min<std::size_t>(inner.struct_size, sizeof(assay_material)));
  table->struct_size = sizeof(assay_material);
  table->inner = &inner;
  table->pace = pace;
  table->create = nullptr;
  table->create_of = create_of;
  table->destroy = destroy;
  table->initial_state = inner.initial_state ? initial_state : nullptr;
  table->update = update;
  table->extension = nullptr;
  table->extension_of = extension_of_clock;
  const std::lock_guard lock(guard);
  all.push_back(std::move(table));
  return all.back().get();
}

}  // namespace

Material at_pace(const Material& material, double pace) {
  return Material(table_at_pace(material.table(), pace), material.named_parameters());
}

}  // namespace assay::check
