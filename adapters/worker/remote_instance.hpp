// SPDX-License-Identifier: BSD-3-Clause
// What the functions of a remote table work on: the table with its workers, and an instance of the host's.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstring>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "adapters/process/shortage.hpp"
#include "adapters/worker/operations.hpp"
#include "adapters/worker/remote_table.hpp"
#include "adapters/worker/table_pack.hpp"
#include "harness/history/history.hpp"
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

  void keep_marks_of(const WorkerProcess& worker);
  /// With the guard locked.
  void leave_workers_of_others();
  /// The slot of that number, started where there is none.
  std::shared_ptr<Slot> slot_number(std::size_t number);
};

/// A worker for one call.
class Lease {
 public:
  /// Any that is free, best one that has the instance.
  Lease(RemoteTable& table, std::uint64_t instance);
  /// That one, as soon as it is free.
  Lease(RemoteTable& table, std::shared_ptr<Slot> slot);
  ~Lease();
  Lease(const Lease&) = delete;
  Lease& operator=(const Lease&) = delete;
  Slot& slot() { return *slot_; }

 private:
  RemoteTable& table_;
  std::shared_ptr<Slot> slot_;
};

/// Whether `attempt(slot)` is done in a worker, best one that has the instance. Where it was killed, which a model does
/// to itself again and again, another worker is asked, once.
bool in_worker(RemoteTable& table, std::uint64_t instance, const auto& attempt) {
  for (const bool again : {false, true}) {
    Lease lease(table, instance);
    const bool done = attempt(lease.slot());
    if (!done && lease.slot().worker.killed()) continue;
    if (again) note_killed_worker();
    return done;
  }
  return false;
}

inline std::string text_of(const char* words, std::size_t size) { return {words, strnlen(words, size)}; }

/// One instance of the host's.
class Instance {
 public:
  Instance(RemoteTable& table, const double* parameters);

  RemoteTable& table() { return table_; }
  std::uint64_t id() const { return id_; }
  std::string reason;  ///< of the last call that failed

  /// Room for a call's arrays, filled by `in`; `out` reads the answer. False with a reason: the worker died, refused to
  /// make the instance, or wrote where it must not. `dead(worker)`: what its memory still tells, if it died.
  bool call(Operation operation, std::size_t n, const auto& in, const auto& out, const auto& dead) {
    return in_worker(table_, id_, [&](Slot& slot) { return call_in(slot, operation, n, in, out, dead); });
  }

  /// The same in a worker that is at hand, once.
  bool call_in(Slot& slot, Operation operation, std::size_t n, const auto& in, const auto& out, const auto& dead) {
    reason.clear();
    ++table_.hand_overs;
    if (!known_to(slot)) return false;
    CallArrays arrays(slot.worker.arrays(), slot.worker.arrays_size());
    arrays.head() = {.instance = id_, .n = n};
    in(arrays);
    arrays.raise_fences();
    if (!slot.worker.call(static_cast<std::uint32_t>(operation))) {
      reason = "the model " + slot.worker.how_it_ended();
      dead(slot.worker);
      return false;
    }
    reason = misdeed_of(slot.worker, arrays);
    if (!reason.empty()) return false;
    out(arrays.head());
    return true;
  }

  /// A function of the list: its status; nothing where no worker has answered. `dead` as above.
  template <class Function, class Dead, class... Arguments>
  std::optional<std::int32_t> ask(const Dead& dead, Arguments... arguments) {
    std::optional<std::int32_t> status;
    std::optional<CallPassage> passage;
    const std::size_t n = points_of(arguments...);
    const auto in = [&](CallArrays& arrays) {
      passage.emplace(arrays, operation_of<Function>, n, table_.state_size).put_all(arguments...);
    };
    const auto out = [&](const CallHead& head) {
      status = head.status;
      if (status == ASSAY_FAILED) reason = text_of(head.message, ASSAY_MESSAGE_SIZE);
      passage->bring_back();
    };
    call(operation_of<Function>, n, in, out, dead);
    return status;
  }

  /// The same. Throws ModelThrew, as the call would here, and where an extension's function ends the worker or writes
  /// where it must not: no model refuses anything so.
  template <class Function, class... Arguments>
  static std::int32_t forward(void* self, Arguments... arguments) {
    auto& instance = *static_cast<Instance*>(self);
    const auto status = instance.ask<Function>([](const WorkerProcess&) {}, arguments...);
    const bool of_extension = operation_of<Function> != Operation::initial_state;
    if ((!status && of_extension) || instance.reason.find(exception_words) != std::string::npos)
      throw ModelThrew(instance.reason);
    return status.value_or(ASSAY_FAILED);
  }

  /// Made in that worker, now or before.
  bool known_to(Slot& slot);

 private:
  /// What the model did in its last call that it must not; empty: nothing.
  static std::string misdeed_of(const WorkerProcess& worker, const CallArrays& arrays);

  RemoteTable& table_;
  std::vector<double> parameters_;
  std::uint64_t id_ = 0;
};

/// `update` of a remote table.
void update_remote(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                   double* cauchy, std::int32_t* status, double* dt_factor, char* message);

/// One step of one point; whether it can be taken again with a shorter one: false where the worker died of it.
bool ends_worker(Instance& instance, const FailedStep& step);

/// Extension of a remote table: its histories are taken in its workers, one hand-over each.
extern const HistoriesElsewhere histories_remote;

}  // namespace assay::adapters
