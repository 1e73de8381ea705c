// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/remote_table.hpp"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <memory>
#include <mutex>
#include <set>

#include "adapters/worker/call_arrays.hpp"
#include "adapters/worker/table_pack.hpp"
#include "harness/material.hpp"

namespace assay::adapters {

namespace {

/// A worker and the instances that it holds.
struct Slot {
  explicit Slot(const WorkerStart& start) : worker(start) {}
  WorkerProcess worker;
  std::set<std::uint64_t> instances;
  bool busy = true;
};

struct RemoteTable : assay_material {
  UnpackedTable metadata;
  assay_example example{};
  WorkerStart start;
  std::size_t state_size = 0;
  std::mutex guard;
  std::vector<std::unique_ptr<Slot>> slots;
  std::string printed;  ///< by workers that have ended
};

/// A worker for one call.
class Lease {
 public:
  Lease(RemoteTable& table, std::uint64_t instance) : table_(table) {
    const std::lock_guard lock(table.guard);
    for (const auto& slot : table.slots) {
      if (slot->busy || (slot_ && slot->instances.count(instance) == 0)) continue;
      slot_ = slot.get();
    }
    if (!slot_) {
      table.slots.push_back(std::make_unique<Slot>(table.start));
      slot_ = table.slots.back().get();
    }
    slot_->busy = true;
  }
  ~Lease() {
    const std::lock_guard lock(table_.guard);
    slot_->busy = false;
    if (!slot_->worker.dead()) return;
    table_.printed += slot_->worker.output();
    std::erase_if(table_.slots, [this](const auto& slot) { return slot.get() == slot_; });
  }
  Lease(const Lease&) = delete;
  Lease& operator=(const Lease&) = delete;
  Slot& slot() { return *slot_; }

 private:
  RemoteTable& table_;
  Slot* slot_ = nullptr;
};

std::string text_of(const char* words, std::size_t size) { return {words, strnlen(words, size)}; }

/// One instance of the host's.
class Instance {
 public:
  Instance(RemoteTable& table, const double* parameters)
      : table_(table), parameters_(parameters, parameters + table.parameter_count) {
    static std::atomic<std::uint64_t> next{1};
    id_ = next++;
  }

  RemoteTable& table() { return table_; }
  std::string reason;  ///< of the last call that failed

  /// Room for a call's arrays, filled by `in`; `out` reads the answer. False with a reason: the worker died, refused to
  /// make the instance, or wrote where it must not. `point`: that was being worked on.
  template <class In, class Out>
  bool call(Operation operation, std::size_t n, const In& in, const Out& out, std::size_t* point = nullptr) {
    reason.clear();
    Lease lease(table_, id_);
    Slot& slot = lease.slot();
    if (!known_to(slot)) return false;
    CallArrays arrays(slot.worker.arrays(), slot.worker.arrays_size());
    arrays.head() = {.instance = id_,
                     .n = n,
                     .t = 0,
                     .dt = 0,
                     .density = 0,
                     .dt_factor = 1,
                     .baseline = 0,
                     .status = ASSAY_GOOD,
                     .message = {}};
    constexpr std::uint32_t spin_us = 30;
    slot.worker.control().spin_us.store(spin_us);
    in(arrays);
    arrays.raise_fences();
    if (!slot.worker.call(static_cast<std::uint32_t>(operation))) {
      if (point) *point = std::min(slot.worker.control().point.load(), n - 1);
      reason = "the model " + slot.worker.how_it_ended();
      return false;
    }
    if (const auto broken = arrays.broken_fence()) {
      reason = "overrun: the model " + *broken;
      return false;
    }
    if (const std::string words = arithmetic_words(slot.worker.control().arithmetic.load()); !words.empty()) {
      reason = "the model " + words;
      return false;
    }
    out(arrays.head());
    return true;
  }

  /// A call without arrays that come back beside those that `out` knows.
  template <class In, class Out>
  std::int32_t status_of(Operation operation, std::size_t n, const In& in, const Out& out) {
    std::int32_t status = ASSAY_FAILED;
    call(operation, n, in, [&](CallHead& head) {
      status = head.status;
      if (status == ASSAY_FAILED) reason = text_of(head.message, ASSAY_MESSAGE_SIZE);
      out();
    });
    return status;
  }

  /// Made in that worker, now or before.
  bool known_to(Slot& slot) {
    if (slot.instances.count(id_)) return true;
    CallArrays arrays(slot.worker.arrays(), slot.worker.arrays_size());
    arrays.head() = {};
    arrays.head().instance = id_;
    auto* parameters = arrays.next<double>(parameters_.size(), "the parameters");
    std::copy(parameters_.begin(), parameters_.end(), parameters);
    arrays.raise_fences();
    if (!slot.worker.call(static_cast<std::uint32_t>(Operation::create))) {
      reason = "the model " + slot.worker.how_it_ended() + " when it was created";
      return false;
    }
    if (arrays.head().status == ASSAY_FAILED) {
      reason = text_of(arrays.head().message, ASSAY_MESSAGE_SIZE);
      if (reason.empty()) reason = "the model could not be created";
      return false;
    }
    slot.instances.insert(id_);
    return true;
  }

 private:
  RemoteTable& table_;
  std::vector<double> parameters_;
  std::uint64_t id_ = 0;
};

/// Inputs and outputs of calls, copied in and out.
void put(CallArrays& arrays, const double* values, std::size_t n, const char* name) {
  std::copy_n(values, n, arrays.next<double>(n, name));
}

Instance& of(void* self) { return *static_cast<Instance*>(self); }

void say(char* message, const std::string& text) { message[text.copy(message, ASSAY_MESSAGE_SIZE - 1)] = '\0'; }

void* create_remote(const assay_material* table, const double* parameters, char* message) {
  try {
    auto& remote = *const_cast<RemoteTable*>(static_cast<const RemoteTable*>(table));
    auto made = std::make_unique<Instance>(remote, parameters);
    Lease lease(remote, 0);
    if (made->known_to(lease.slot())) return made.release();
    say(message, made->reason);
  } catch (const std::exception& error) {
    say(message, error.what());
  }
  return nullptr;
}

void destroy_remote(void* self) { delete static_cast<Instance*>(self); }

const char* reason_remote(void* self) { return of(self).reason.c_str(); }

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

void update_remote(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                   double* cauchy, std::int32_t* status, double* dt_factor, char* message) {
  const std::size_t size = of(self).table().state_size * n;
  double *new_state = nullptr, *stress = nullptr;
  std::int32_t* statuses = nullptr;
  std::size_t point = 0;
  const auto in = [&](CallArrays& arrays) {
    arrays.head().t = step->t;
    arrays.head().dt = step->dt;
    put(arrays, step->F0, 9 * n, "F0");
    put(arrays, step->F1, 9 * n, "F1");
    put(arrays, state0, size, "state0");
    new_state = arrays.next<double>(size, "state1");
    stress = arrays.next<double>(9 * n, "cauchy");
    statuses = arrays.next<std::int32_t>(n, "status");
    std::copy_n(state1, size, new_state);
    std::copy_n(cauchy, 9 * n, stress);
    std::copy_n(status, n, statuses);
  };
  const auto out = [&](CallHead& head) {
    std::copy_n(new_state, size, state1);
    std::copy_n(stress, 9 * n, cauchy);
    std::copy_n(statuses, n, status);
    *dt_factor = head.dt_factor;
    std::memcpy(message, head.message, ASSAY_MESSAGE_SIZE);
  };
  try {
    if (of(self).call(Operation::update, n, in, out, &point)) return;
  } catch (const std::exception& error) {
    of(self).reason = error.what();
  }
  std::fill_n(status, n, ASSAY_GOOD);
  status[point] = ASSAY_FAILED;
  *dt_factor = 0;
  say(message, of(self).reason);
}

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
                          {ASSAY_EXTENSION_EXAMPLE, !a.example.empty(), &remote.example}};
  for (const Offer& offer : offers) {
    if (std::strcmp(offer.id, id) == 0) return offer.there ? offer.functions : nullptr;
  }
  return nullptr;
}

/// All that were made; guarded.
struct AllTables {
  std::mutex guard;
  std::vector<std::unique_ptr<RemoteTable>> tables;
};

AllTables& all_tables() {
  static AllTables all;
  return all;
}

/// Metadata of the worker's table. Throws RemoteError.
void describe(RemoteTable& table) {
  Lease lease(table, 0);
  WorkerProcess& worker = lease.slot().worker;
  if (!worker.call(static_cast<std::uint32_t>(Operation::describe))) {
    throw RemoteError({"", worker.how_it_ended() + " when it was loaded", ""});
  }
  CallArrays arrays(worker.arrays(), worker.arrays_size());
  if (arrays.head().status == ASSAY_FAILED) {
    const char* words = arrays.next<char>(3 * words_size, "the reason");
    throw RemoteError({text_of(words, words_size), text_of(words + words_size, words_size),
                       text_of(words + 2 * words_size, words_size)});
  }
  const std::size_t size = arrays.head().n;
  unpack(std::string(arrays.next<char>(size, "the table"), size), table.metadata);
}

}  // namespace

const assay_material* remote_table(const WorkerStart& start) {
  auto table = std::make_unique<RemoteTable>();
  table->start = start;
  describe(*table);
  static_cast<assay_material&>(*table) = table->metadata.table;
  table->example = {sizeof(assay_example), table->metadata.abilities.example.data()};
  for (const assay_state_variable& v : table->metadata.state) {
    table->state_size += static_cast<std::size_t>(components_of_kind(v.kind));
  }
  table->create_of = create_remote;
  table->destroy = destroy_remote;
  table->initial_state = initial_state_remote;
  table->update = update_remote;
  table->extension_of = extension_remote;
  table->flags |= ASSAY_THREAD_SAFE;  // one worker a call
  const std::lock_guard lock(all_tables().guard);
  all_tables().tables.push_back(std::move(table));
  return all_tables().tables.back().get();
}

WorkerStart start_of(const assay_material* table) {
  const std::lock_guard lock(all_tables().guard);
  for (const auto& each : all_tables().tables) {
    if (each.get() == table) return each->start;
  }
  return {};
}

std::string output_of(const assay_material* table) {
  const std::lock_guard lock(all_tables().guard);
  for (const auto& each : all_tables().tables) {
    if (each.get() != table) continue;
    std::string text = each->printed;
    for (const auto& slot : each->slots) text += slot->worker.output();
    return text;
  }
  return {};
}

void end_workers() {
  const std::lock_guard lock(all_tables().guard);
  for (const auto& table : all_tables().tables) {
    for (const auto& slot : table->slots) table->printed += slot->worker.output();
    table->slots.clear();
  }
}

}  // namespace assay::adapters
