// SPDX-License-Identifier: BSD-3-Clause
// The functions of a remote table.
#include <algorithm>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "adapters/worker/remote_histories.hpp"
#include "adapters/worker/remote_instance.hpp"

namespace assay::adapters {

namespace {

/// Inputs and outputs of calls, copied in and out.
void put(CallArrays& arrays, const double* values, std::size_t n, const char* name) {
  std::copy_n(values, n, arrays.next<double>(n, name));
}

Instance& of(void* self) { return *static_cast<Instance*>(self); }

void say(char* message, const std::string& text) { message[text.copy(message, ASSAY_MESSAGE_SIZE - 1)] = '\0'; }

}  // namespace

void* create_remote(const assay_material* table, const double* parameters, char* message) {
  try {
    auto& remote = *const_cast<RemoteTable*>(static_cast<const RemoteTable*>(table));
    auto made = std::make_unique<Instance>(remote, parameters);
    for (const bool again : {false, true}) {
      Lease lease(remote, 0);
      const bool known = made->known_to(lease.slot());
      if (known && again) note_killed_worker();
      if (known) return made.release();
      if (!lease.slot().worker.killed()) break;
    }
    say(message, made->reason);
  } catch (const std::exception& error) {
    say(message, error.what());
  }
  return nullptr;
}

void destroy_remote(void* self) { delete static_cast<Instance*>(self); }

namespace {

const char* reason_remote(void* self) { return of(self).reason.c_str(); }

std::int32_t tangent_remote(void* self, const assay_step* step, std::size_t n, const double* state0, double* tangent) {
  double* found = nullptr;
  return of(self).status_of(
      Operation::tangent, n,
      [&](CallArrays& arrays) {
        arrays.head().t = step->t;
        arrays.head().dt = step->dt;
        put(arrays, step->F0, 9 * n, "F0");
        put(arrays, step->F1, 9 * n, "F1");
        put(arrays, state0, of(self).table().state_size * n, "state0");
        found = arrays.next<double>(81 * n, "the tangent");
      },
      [&] { std::copy_n(found, 81 * n, tangent); });
}

std::int32_t energy_remote(void* self, std::size_t n, const double* F, const double* state, double* energy) {
  double* found = nullptr;
  return of(self).status_of(
      Operation::energy, n,
      [&](CallArrays& arrays) {
        put(arrays, F, 9 * n, "F");
        put(arrays, state, of(self).table().state_size * n, "state");
        found = arrays.next<double>(n, "the energy");
      },
      [&] { std::copy_n(found, n, energy); });
}

std::int32_t rate_remote(void* self, double t, std::size_t n, const double* F, const double* l, const double* cauchy,
                         const double* state, double* cauchy_rate, double* state_rate) {
  const std::size_t size = of(self).table().state_size * n;
  double *stress = nullptr, *variables = nullptr;
  return of(self).status_of(
      Operation::rate, n,
      [&](CallArrays& arrays) {
        arrays.head().t = t;
        put(arrays, F, 9 * n, "F");
        put(arrays, l, 9 * n, "l");
        put(arrays, cauchy, 9 * n, "cauchy");
        put(arrays, state, size, "state");
        stress = arrays.next<double>(9 * n, "the rate of stress");
        variables = arrays.next<double>(size, "the rate of state");
      },
      [&] {
        std::copy_n(stress, 9 * n, cauchy_rate);
        std::copy_n(variables, size, state_rate);
      });
}

std::int32_t wave_speed_remote(void* self, double density, std::size_t n, const double* F, const double* cauchy,
                               const double* state, double* speed) {
  double* found = nullptr;
  return of(self).status_of(
      Operation::wave_speed, n,
      [&](CallArrays& arrays) {
        arrays.head().density = density;
        put(arrays, F, 9 * n, "F");
        put(arrays, cauchy, 9 * n, "cauchy");
        put(arrays, state, of(self).table().state_size * n, "state");
        found = arrays.next<double>(n, "the speed");
      },
      [&] { std::copy_n(found, n, speed); });
}

std::int32_t closed_form_remote(void* self, std::int32_t baseline, std::size_t n, const double* eps, double* tau,
                                double* slope) {
  double *found = nullptr, *found_slope = nullptr;
  return of(self).status_of(
      Operation::closed_form, n,
      [&](CallArrays& arrays) {
        arrays.head().baseline = baseline;
        put(arrays, eps, n, "eps");
        found = arrays.next<double>(9 * n, "tau");
        found_slope = arrays.next<double>(9 * n, "the slope");
      },
      [&] {
        std::copy_n(found, 9 * n, tau);
        std::copy_n(found_slope, 9 * n, slope);
      });
}

}  // namespace

std::int32_t initial_state_remote(void* self, std::size_t n, const double* cauchy, double* state) {
  const std::size_t size = of(self).table().state_size * n;
  double* found = nullptr;
  return of(self).status_of(
      Operation::initial_state, n,
      [&](CallArrays& arrays) {
        put(arrays, cauchy, 9 * n, "cauchy");
        found = arrays.next<double>(size, "the initial state");
        std::copy_n(state, size, found);
      },
      [&] { std::copy_n(found, size, state); });
}

namespace {

/// Of a batch in which the worker died: the first point that ends a worker when it is alone. None: reason says so.
std::optional<std::size_t> point_that_ends(void* self, const assay_step& step, std::size_t n, const double* state0) {
  const std::size_t size = of(self).table().state_size;
  const std::string reason = of(self).reason;
  std::vector<double> alone(size), state1(size);
  double F0[9], F1[9], cauchy[9] = {}, dt_factor = 1;
  char message[ASSAY_MESSAGE_SIZE] = "";
  const assay_step one{step.t, step.dt, F0, F1};
  for (std::size_t p = 0; p < n; ++p) {
    for (std::size_t c = 0; c < 9; ++c) F0[c] = step.F0[c * n + p], F1[c] = step.F1[c * n + p];
    for (std::size_t c = 0; c < size; ++c) alone[c] = state0[c * n + p];
    std::int32_t status = ASSAY_GOOD;
    update_remote(self, &one, 1, alone.data(), state1.data(), cauchy, &status, &dt_factor, message);
    if (dt_factor == 0) return p;
  }
  of(self).reason = reason + " in a batch of " + std::to_string(n) + " points, by none of them alone";
  return std::nullopt;
}

}  // namespace

void update_remote(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                   double* cauchy, std::int32_t* status, double* dt_factor, char* message) {
  const std::size_t size = of(self).table().state_size * n;
  std::optional<UpdateArrays> a;
  std::size_t point = 0;
  const auto in = [&](CallArrays& arrays) {
    arrays.head().t = step->t;
    arrays.head().dt = step->dt;
    a.emplace(arrays, n, of(self).table().state_size);
    std::copy_n(step->F0, 9 * n, a->F0);
    std::copy_n(step->F1, 9 * n, a->F1);
    std::copy_n(state0, size, a->state0);
    std::copy_n(state1, size, a->state1);
    std::copy_n(cauchy, 9 * n, a->cauchy);
    std::copy_n(status, n, a->status);
  };
  const auto out = [&](CallHead& head) {
    std::copy_n(a->state1, size, state1);
    std::copy_n(a->cauchy, 9 * n, cauchy);
    std::copy_n(a->status, n, status);
    *dt_factor = head.dt_factor;
    std::memcpy(message, head.message, ASSAY_MESSAGE_SIZE);
  };
  const auto dead = [&](const WorkerProcess& worker) { point = worker.control().point.load(); };
  try {
    if (of(self).call(Operation::update, n, in, out, dead)) return;
  } catch (const std::exception& error) {
    of(self).reason = error.what();
  }
  if (point == no_point) point = n > 1 ? point_that_ends(self, *step, n, state0).value_or(0) : 0;
  std::fill_n(status, n, ASSAY_GOOD);
  status[std::min(point, n - 1)] = ASSAY_FAILED;
  *dt_factor = 0;
  say(message, of(self).reason);
}

const void* extension_remote(const assay_material* table, const char* id) {
  static const assay_rate rate{sizeof(assay_rate), rate_remote};
  static const assay_tangent tangent{sizeof(assay_tangent), tangent_remote};
  static const assay_energy energy{sizeof(assay_energy), energy_remote};
  static const assay_wave_speed wave_speed{sizeof(assay_wave_speed), wave_speed_remote};
  static const assay_closed_form closed_form{sizeof(assay_closed_form), closed_form_remote};
  static const assay_reason reason{sizeof(assay_reason), reason_remote};
  const auto& remote = static_cast<const RemoteTable&>(*table);
  const TableAbilities& a = remote.metadata.abilities;
  struct Offer {
    const char* id;
    bool there;
    const void* functions;
  };
  const Offer offers[] = {{ASSAY_EXTENSION_RATE, a.rate, &rate},
                          {ASSAY_EXTENSION_TANGENT, a.tangent, &tangent},
                          {ASSAY_EXTENSION_ENERGY, a.energy, &energy},
                          {ASSAY_EXTENSION_WAVE_SPEED, a.wave_speed, &wave_speed},
                          {ASSAY_EXTENSION_CLOSED_FORM, a.closed_form, &closed_form},
                          {ASSAY_EXTENSION_REASON, true, &reason},
                          {ASSAY_EXTENSION_EXAMPLE, !a.example.empty(), &remote.example},
                          {ASSAY_EXTENSION_SYMMETRY, a.material_class != 0, &remote.material_class},
                          {histories_elsewhere_id, true, &histories_remote}};
  for (const Offer& offer : offers) {
    if (std::strcmp(offer.id, id) == 0) return offer.there ? offer.functions : nullptr;
  }
  return nullptr;
}

}  // namespace assay::adapters
