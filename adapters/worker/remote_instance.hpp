// SPDX-License-Identifier: BSD-3-Clause
// What the functions of a remote table work on: the table with its workers, and an instance of the host's.
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstring>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "adapters/worker/call_arrays.hpp"
#include "adapters/worker/remote_table.hpp"
#include "adapters/worker/servant.hpp"
#include "adapters/worker/shortage.hpp"
#include "adapters/worker/table_pack.hpp"
#include "harness/material/material.hpp"
#include "harness/material/material_failure.hpp"
#include "harness/material/thrown.hpp"
#include "harness/numeric/arithmetic.hpp"

namespace assay::adapters {

/// A worker and the instances that it holds.
struct Slot {
  explicit Slot(const WorkerStart& start) : worker(start) {}
  WorkerProcess worker;
  std::set<std::uint64_t> instances;
  bool busy = false;
};

struct RemoteTable : assay_material {
  UnpackedTable metadata;
  assay_example example{};
  assay_symmetry material_class{};
  WorkerStart start;
  std::size_t state_size = 0;
  std::mutex guard;
  std::condition_variable freed;  ///< a slot is no longer busy
  std::vector<std::shared_ptr<Slot>> slots;
  std::string printed;                      ///< by workers that have ended
  Habits habits = 0;                        ///< of such
  std::atomic<bool> ended{false};           ///< there were such
  std::uint64_t wake_ups = 0;               ///< of such
  std::atomic<std::int64_t> hand_overs{0};  ///< to any worker

  void keep_marks_of(const WorkerProcess& worker) {
    printed += worker.output();
    habits |= worker.control().habits.load();
    wake_ups += worker.control().wake_ups.load();
  }

  /// The slot of that number, started where there is none.
  std::shared_ptr<Slot> slot_number(std::size_t number) {
    const std::lock_guard lock(guard);
    while (slots.size() <= number) slots.push_back(std::make_shared<Slot>(start));
    return slots[number];
  }
};

/// A worker for one call.
class Lease {
 public:
  /// Any that is free, best one that has the instance.
  Lease(RemoteTable& table, std::uint64_t instance) : table_(table) {
    const std::lock_guard lock(table.guard);
    for (const auto& slot : table.slots) {
      if (slot->busy || (slot_ && slot->instances.count(instance) == 0)) continue;
      slot_ = slot;
    }
    if (!slot_) {
      table.slots.push_back(std::make_shared<Slot>(table.start));
      slot_ = table.slots.back();
    }
    slot_->busy = true;
  }
  /// That one, as soon as it is free.
  Lease(RemoteTable& table, std::shared_ptr<Slot> slot) : table_(table), slot_(std::move(slot)) {
    std::unique_lock lock(table.guard);
    table.freed.wait(lock, [this] { return !slot_->busy; });
    slot_->busy = true;
  }
  ~Lease() {
    const std::lock_guard lock(table_.guard);
    slot_->busy = false;
    table_.freed.notify_all();
    if (!slot_->worker.dead()) return;
    table_.ended = true;
    const auto gone = std::find(table_.slots.begin(), table_.slots.end(), slot_);
    if (gone == table_.slots.end()) return;
    table_.keep_marks_of(slot_->worker);
    table_.slots.erase(gone);
  }
  Lease(const Lease&) = delete;
  Lease& operator=(const Lease&) = delete;
  Slot& slot() { return *slot_; }

 private:
  RemoteTable& table_;
  std::shared_ptr<Slot> slot_;
};

inline std::string text_of(const char* words, std::size_t size) { return {words, strnlen(words, size)}; }

/// One instance of the host's.
class Instance {
 public:
  Instance(RemoteTable& table, const double* parameters)
      : table_(table), parameters_(parameters, parameters + table.parameter_count) {
    static std::atomic<std::uint64_t> next{1};
    id_ = next++;
  }

  RemoteTable& table() { return table_; }
  std::uint64_t id() const { return id_; }
  std::string reason;  ///< of the last call that failed

  /// Room for a call's arrays, filled by `in`; `out` reads the answer. False with a reason: the worker died, refused to
  /// make the instance, or wrote where it must not. `dead(worker)`: what its memory still tells, if it died.
  template <class In, class Out, class Dead>
  bool call(Operation operation, std::size_t n, const In& in, const Out& out, const Dead& dead) {
    if (std::optional<bool> done = try_call(operation, n, in, out, dead)) return *done;
    const std::optional<bool> again = try_call(operation, n, in, out, dead);
    if (again) note_killed_worker();
    return again.value_or(false);
  }

  /// The same; nothing: the worker was killed, which a model does to itself again and again.
  template <class In, class Out, class Dead>
  std::optional<bool> try_call(Operation operation, std::size_t n, const In& in, const Out& out, const Dead& dead) {
    Lease lease(table_, id_);
    if (call_in(lease.slot(), operation, n, in, out, dead)) return true;
    if (lease.slot().worker.killed()) return std::nullopt;
    return false;
  }

  /// The same in a worker that is at hand.
  template <class In, class Out, class Dead>
  bool call_in(Slot& slot, Operation operation, std::size_t n, const In& in, const Out& out, const Dead& dead) {
    reason.clear();
    ++table_.hand_overs;
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
    in(arrays);
    arrays.raise_fences();
    if (!slot.worker.call(static_cast<std::uint32_t>(operation))) {
      reason = "the model " + slot.worker.how_it_ended();
      dead(slot.worker);
      return false;
    }
    if (const auto broken = arrays.broken_fence()) {
      reason = overrun_words + ("the model " + *broken);
      return false;
    }
    if (const std::string words = arithmetic_words(slot.worker.control().arithmetic.load()); !words.empty()) {
      reason = arithmetic_prefix + ("the model " + words);
      return false;
    }
    out(arrays.head());
    return true;
  }

  /// A call without arrays that come back beside those that `out` knows. Throws ModelThrew, as the call would here, and
  /// where an extension's function ends the worker or writes where it must not: no model refuses anything so.
  template <class In, class Out>
  std::int32_t status_of(Operation operation, std::size_t n, const In& in, const Out& out) {
    std::int32_t status = ASSAY_FAILED;
    const auto take = [&](CallHead& head) {
      status = head.status;
      if (status == ASSAY_FAILED) reason = text_of(head.message, ASSAY_MESSAGE_SIZE);
      out();
    };
    const bool answered = call(operation, n, in, take, [](const WorkerProcess&) {});
    const bool of_extension = operation != Operation::initial_state;
    if ((!answered && of_extension) || reason.find(exception_words) != std::string::npos) throw ModelThrew(reason);
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
      reason = "the model " + slot.worker.how_it_ended();
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

/// The functions of the table: create_of, destroy, initial_state, update, extension_of.
void* create_remote(const assay_material* table, const double* parameters, char* message);
void destroy_remote(void* self);
std::int32_t initial_state_remote(void* self, std::size_t n, const double* cauchy, double* state);
void update_remote(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                   double* cauchy, std::int32_t* status, double* dt_factor, char* message);
const void* extension_remote(const assay_material* table, const char* id);

}  // namespace assay::adapters
