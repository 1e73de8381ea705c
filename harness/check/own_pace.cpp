// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/own_pace.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "harness/check/march.hpp"
#include "harness/check/state_variable.hpp"
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

/// What knows no time.
template <class Extension, class Result, class... Arguments>
Result passed_on(void* self, Arguments... arguments) {
  return of(self).offered<Extension>()(arguments...);
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
  const std::vector<StatePlace> places = state_of(*i.table);
  const std::size_t variables = places.empty() ? 0 : places.back().end();
  std::for_each(cauchy_rate, cauchy_rate + 9 * n, [=](double& each) { each *= pace; });
  std::for_each(state_rate, state_rate + variables * n, [=](double& each) { each *= pace; });
  return found;
}

const void* extension_of_clock(const assay_material* table, const char* id) {
  static const assay_rate rates{sizeof rates, rate};
  static const assay_tangent tangents{sizeof tangents, tangent};
  static const assay_energy energies{sizeof energies, passed_on<assay_energy>};
  static const assay_wave_speed speeds{sizeof speeds, passed_on<assay_wave_speed>};
  static const assay_closed_form forms{sizeof forms, passed_on<assay_closed_form>};
  static const assay_reason reasons{sizeof reasons, passed_on<assay_reason>};
  const void* const offered = extension_of(static_cast<const ClockTable*>(table)->inner, id);
  const std::pair<const char*, const void*> own[] = {
      {ASSAY_EXTENSION_RATE, &rates},        {ASSAY_EXTENSION_TANGENT, &tangents},  {ASSAY_EXTENSION_ENERGY, &energies},
      {ASSAY_EXTENSION_WAVE_SPEED, &speeds}, {ASSAY_EXTENSION_CLOSED_FORM, &forms}, {ASSAY_EXTENSION_REASON, &reasons},
      {ASSAY_EXTENSION_EXAMPLE, offered},    {ASSAY_EXTENSION_SYMMETRY, offered}};  // the last two: no functions
  const auto* found =
      std::find_if(std::begin(own), std::end(own), [&](const auto& each) { return each.first == std::string(id); });
  return offered && found != std::end(own) ? found->second : nullptr;
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

std::optional<double> own_pace(const Material& material, const Report& report) {
  constexpr double shortest = 1e-12, longest = 1e-3;  // [s]; the usual tests resolve what takes more
  constexpr double alike = 0.02, usual_strain = 0.01;
  constexpr double per_length = 250;  // what decays as exp(-t / T) has lost `alike` in T / 25: steps of T to 10 T
  if (!material.has(ASSAY_RATE_DEPENDENT)) return std::nullopt;
  const Tensor I = Tensor::Identity();
  const Tensor strained = Space(material).stretch(report.strain > 0 ? report.strain : usual_strain, 1);
  const auto stress_of_step = [&](double length) {
    return stepped(material, 0, length, I, strained, state_at_rest(material, report.pressure)).cauchy;
  };
  const auto pace = [&]() -> std::optional<double> {
    const Tensor sudden = stress_of_step(shortest);
    const double size = largest_of(sudden);
    double same = 0;
    for (double length = 10 * shortest; length < 2 * longest; length *= 10) {
      const Tensor stress = stress_of_step(length);
      const bool differs = !(distance(stress, sudden) <= alike * size);
      if (differs && same > 0 && largest_of(stress) < size) return per_length * same;  // it has relaxed
      if (differs) return std::nullopt;
      same = length;
    }
    return std::nullopt;
  };
  return if_taken(pace, std::nullopt);  // a refusal says nothing of time
}

Material at_pace(const Material& material, double pace) {
  return Material(table_at_pace(material.table(), pace), material.named_parameters());
}

}  // namespace assay::check
