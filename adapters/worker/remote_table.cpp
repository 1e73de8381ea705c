// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/remote_table.hpp"

#include <algorithm>
#include <memory>
#include <ranges>
#include <utility>

#include "adapters/worker/remote_instance.hpp"
#include "harness/material/material_failure.hpp"
#include "harness/material/state_variable.hpp"

namespace assay::adapters {

void RemoteTable::keep_marks_of(const WorkerProcess& worker) {
  printed += worker.output();
  habits |= worker.control().habits.load();
  wake_ups += worker.control().wake_ups.load();
}

/// The workers of a process that has forked this one stay its own.
void RemoteTable::leave_workers_of_others() {
  std::erase_if(slots, [](const auto& slot) { return !slot->worker.is_ours(); });
}

std::shared_ptr<Slot> RemoteTable::slot_number(std::size_t number) {
  const std::lock_guard lock(guard);
  leave_workers_of_others();
  while (slots.size() <= number) slots.push_back(std::make_shared<Slot>(start));
  return slots[number];
}

Lease::Lease(RemoteTable& table, std::uint64_t instance) : table_(table) {
  const std::lock_guard lock(table.guard);
  table.leave_workers_of_others();
  for (const auto& slot : table.slots) {
    if (slot->busy || (slot_ && slot->instances.count(instance) == 0)) continue;
    slot_ = slot;
  }
  if (!slot_) slot_ = table.slots.emplace_back(std::make_shared<Slot>(table.start));
  slot_->busy = true;
}

Lease::Lease(RemoteTable& table, std::shared_ptr<Slot> slot) : table_(table), slot_(std::move(slot)) {
  std::unique_lock lock(table.guard);
  table.freed.wait(lock, [this] { return !slot_->busy; });
  slot_->busy = true;
}

Lease::~Lease() {
  const std::lock_guard lock(table_.guard);
  slot_->busy = false;
  table_.freed.notify_all();
  if (!slot_->worker.dead()) return;
  table_.ended = true;
  if (std::erase(table_.slots, slot_) > 0) table_.keep_marks_of(slot_->worker);
}

Instance::Instance(RemoteTable& table, const double* parameters)
    : table_(table), parameters_(parameters, parameters + table.parameter_count) {
  static std::atomic<std::uint64_t> next{1};
  id_ = next++;
}

bool Instance::known_to(Slot& slot) {
  if (slot.instances.count(id_)) return true;
  CallArrays arrays(slot.worker.arrays(), slot.worker.arrays_size());
  arrays.head() = {};
  arrays.head().instance = id_;
  std::ranges::copy(parameters_, arrays.next<double>(parameters_.size(), "the parameters"));
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

std::string Instance::misdeed_of(const WorkerProcess& worker, const CallArrays& arrays) {
  if (const auto broken = arrays.broken_fence()) return overrun_words + ("the model " + *broken);
  const std::string words = arithmetic_words(worker.control().arithmetic.load());
  return words.empty() ? words : arithmetic_prefix + ("the model " + words);
}

namespace {

Instance& of(void* self) { return *static_cast<Instance*>(self); }

void* create_remote(const assay_material* table, const double* parameters, char* message) {
  try {
    auto& remote = *const_cast<RemoteTable*>(static_cast<const RemoteTable*>(table));
    auto made = std::make_unique<Instance>(remote, parameters);
    if (in_worker(remote, 0, [&](Slot& slot) { return made->known_to(slot); })) return made.release();
    write_message(message, made->reason);
  } catch (const std::exception& error) {
    write_message(message, error.what());
  }
  return nullptr;
}

/// Of a batch in which the worker died: the first point that ends a worker when it is alone. None: reason says so.
std::size_t point_that_ends(Instance& instance, const assay_step& step, std::size_t n, const double* state0,
                            const double* state1) {
  const std::string reason = instance.reason;
  for (std::size_t p = 0; p < n; ++p) {
    FailedStep alone = failed_step(step.t, step.dt, n, p, step.F0, step.F1, state0, instance.table().state_size);
    for (const std::size_t c : fields_of(instance.table())) alone.fields1.push_back(state1[c * n + p]);
    if (ends_worker(instance, alone)) return p;
  }
  instance.reason = reason + " in a batch of " + std::to_string(n) + " points, by none of them alone";
  return 0;
}

const char* reason_remote(void* self) { return of(self).reason.c_str(); }

const void* extension_remote(const assay_material* table, const char* id) {
  static const assay_reason reason{sizeof(assay_reason), reason_remote};
  const auto& remote = static_cast<const RemoteTable&>(*table);
  const std::pair<const char*, const void*> values[] = {
      {ASSAY_EXTENSION_REASON, &reason},
      {ASSAY_EXTENSION_EXAMPLE, remote.metadata.example.empty() ? nullptr : &remote.example},
      {ASSAY_EXTENSION_SYMMETRY, remote.metadata.material_class == 0 ? nullptr : &remote.material_class},
      {histories_elsewhere_id, &histories_remote}};
  for (const auto& [name, found] : values) {
    if (std::strcmp(name, id) == 0) return found;
  }
  const auto is_offered = [&](std::uint32_t place) { return (remote.metadata.offered >> place & 1u) != 0; };
  return forwarded_of<Instance>(id, is_offered, StatusExtensions{});
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

thread_local OwnRemoteTables* owner_of_tables = nullptr;

/// What `ask` says of a remote table, while no other is made or ends; `otherwise` of any other table.
template <class Value, class Ask>
Value of_remote(const assay_material* table, const Value& otherwise, const Ask& ask) {
  const std::lock_guard lock(all_tables().guard);
  for (const auto& each : all_tables().tables) {
    if (each.get() == table) return ask(*each);
  }
  return otherwise;
}

/// Metadata of the worker's table. Throws ModelRefused.
void describe(RemoteTable& table) {
  std::optional<ModelRefused> refused;
  in_worker(table, 0, [&](Slot& slot) {
    WorkerProcess& worker = slot.worker;
    const bool answered = worker.call(static_cast<std::uint32_t>(Operation::describe));
    CallArrays arrays(worker.arrays(), worker.arrays_size());
    const auto text = [&](std::size_t size) { return arrays.next<char>(size, "the answer"); };
    const auto part = [&] { return text_of(text(ASSAY_MESSAGE_SIZE), ASSAY_MESSAGE_SIZE); };
    if (!answered) {
      refused.emplace("", worker.how_it_ended());
    } else if (arrays.head().status == ASSAY_FAILED) {
      const std::string key = part(), what = part();
      refused.emplace(key, what, part());
    } else {
      refused.reset();
      unpack({text(arrays.head().n), arrays.head().n}, table.metadata);
    }
    return answered;
  });
  if (refused) throw *refused;
}

}  // namespace

void update_remote(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                   double* cauchy, std::int32_t* status, double* dt_factor, char* message) {
  Instance& instance = of(self);
  std::size_t point = 0;
  const auto dead = [&](const WorkerProcess& worker) { point = worker.control().point.load(); };
  try {
    CallHead head;
    if (instance.ask<Update>(dead, step, n, state0, state1, cauchy, status, &head)) {
      *dt_factor = head.dt_factor;
      std::memcpy(message, head.message, ASSAY_MESSAGE_SIZE);
      return;
    }
  } catch (const std::exception& error) {
    instance.reason = error.what();
  }
  if (point == no_point) point = n > 1 ? point_that_ends(instance, *step, n, state0, state1) : 0;
  std::fill_n(status, n, ASSAY_GOOD);
  status[std::min(point, n - 1)] = ASSAY_FAILED;
  *dt_factor = 0;
  write_message(message, instance.reason);
}

bool ends_worker(Instance& instance, const FailedStep& step) {
  double F0[9], F1[9], cauchy[9] = {}, dt_factor = 1;
  for (int c = 0; c < 9; ++c) F0[c] = component(step.F0, c), F1[c] = component(step.F1, c);
  std::vector<double> state1 = step.state0;
  const std::vector<std::size_t> fields = fields_of(instance.table());
  for (std::size_t k = 0; k < step.fields1.size(); ++k) state1[fields[k]] = step.fields1[k];
  const assay_step one{step.t, step.dt, F0, F1};
  std::int32_t status = ASSAY_GOOD;
  char message[ASSAY_MESSAGE_SIZE] = "";
  update_remote(&instance, &one, 1, step.state0.data(), state1.data(), cauchy, &status, &dt_factor, message);
  return dt_factor == 0;
}

const assay_material* remote_table(const WorkerStart& start) {
  auto table = std::make_unique<RemoteTable>();
  table->start = start;
  describe(*table);
  static_cast<assay_material&>(*table) = table->metadata.table;
  table->example = {sizeof(assay_example), table->metadata.example.data()};
  table->material_class = {sizeof(assay_symmetry), table->metadata.material_class};
  table->state_size = state_size_of(*table);
  table->create_of = create_remote;
  table->destroy = [](void* self) { delete static_cast<Instance*>(self); };
  table->initial_state = &Forwarded<Instance, InitialState>::call;
  table->update = update_remote;
  table->extension_of = extension_remote;
  table->flags |= ASSAY_THREAD_SAFE;  // one worker a call
  const std::lock_guard lock(all_tables().guard);
  if (owner_of_tables) owner_of_tables->tables_.push_back(table.get());
  return all_tables().tables.emplace_back(std::move(table)).get();
}

WorkerStart start_of(const assay_material* table) {
  return of_remote(table, WorkerStart(), [](const RemoteTable& t) { return t.start; });
}

std::uint32_t own_flags(const assay_material* table) {
  return of_remote(table, table->flags, [](const RemoteTable& t) { return t.metadata.table.flags; });
}

WorkerMarks marks_of(const assay_material* table) {
  return of_remote(table, WorkerMarks(), [](const RemoteTable& t) {
    WorkerMarks marks{t.printed, t.habits, t.ended, t.hand_overs, static_cast<std::int64_t>(t.wake_ups)};
    for (const auto& slot : t.slots) {
      marks.printed += slot->worker.output();
      marks.habits |= slot->worker.control().habits;
      marks.wake_ups += static_cast<std::int64_t>(slot->worker.control().wake_ups);
    }
    return marks;
  });
}

void keep_marks(const assay_material* table, const WorkerProcess& worker) {
  of_remote(table, 0, [&](RemoteTable& t) {
    t.keep_marks_of(worker);
    t.hand_overs += worker.control().request.load();
    return 0;
  });
}

void end_workers() {
  const std::lock_guard lock(all_tables().guard);
  for (const auto& table : all_tables().tables) {
    for (const auto& slot : table->slots) table->keep_marks_of(slot->worker);
    table->slots.clear();
  }
}

OwnRemoteTables::OwnRemoteTables() { owner_of_tables = this; }

OwnRemoteTables::~OwnRemoteTables() {
  all_are_told();
  for (const assay_material* table : tables_) forget_remote_table(table);
}

void OwnRemoteTables::all_are_told() {
  if (owner_of_tables == this) owner_of_tables = nullptr;
}

void forget_remote_table(const assay_material* table) {
  if (owner_of_tables) std::erase(owner_of_tables->tables_, table);
  std::unique_ptr<RemoteTable> ended;  // its workers end when no other table has to wait for them
  const std::lock_guard lock(all_tables().guard);
  auto& all = all_tables().tables;
  const auto found = std::ranges::find_if(all, [&](const auto& each) { return each.get() == table; });
  if (found == all.end()) return;
  ended = std::move(*found);
  all.erase(found);
}

}  // namespace assay::adapters
