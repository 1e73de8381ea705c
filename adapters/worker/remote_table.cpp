// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/remote_table.hpp"

#include <algorithm>

#include "adapters/worker/remote_instance.hpp"
#include "harness/material/material.hpp"

namespace assay::adapters {

namespace {

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
void describe(RemoteTable& table, bool again = false) {
  Lease lease(table, 0);
  WorkerProcess& worker = lease.slot().worker;
  if (!worker.call(static_cast<std::uint32_t>(Operation::describe))) {
    if (worker.killed() && !again) return describe(table, true);
    throw RemoteError({"", worker.how_it_ended(), ""});
  }
  if (again) note_killed_worker();
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
  table->material_class = {sizeof(assay_symmetry), table->metadata.abilities.material_class};
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

std::uint32_t own_flags(const assay_material* table) {
  const std::lock_guard lock(all_tables().guard);
  for (const auto& each : all_tables().tables) {
    if (each.get() == table) return each->metadata.table.flags;
  }
  return table->flags;
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

Habits habits_of(const assay_material* table) {
  const std::lock_guard lock(all_tables().guard);
  for (const auto& each : all_tables().tables) {
    if (each.get() != table) continue;
    Habits habits = each->habits;
    for (const auto& slot : each->slots) habits |= slot->worker.control().habits.load();
    return habits;
  }
  return 0;
}

bool has_ended(const assay_material* table) {
  const std::lock_guard lock(all_tables().guard);
  return std::any_of(all_tables().tables.begin(), all_tables().tables.end(),
                     [table](const auto& each) { return each.get() == table && each->ended; });
}

HandOvers hand_overs_of(const assay_material* table) {
  const std::lock_guard lock(all_tables().guard);
  for (const auto& each : all_tables().tables) {
    if (each.get() != table) continue;
    std::uint64_t wake_ups = each->wake_ups;
    for (const auto& slot : each->slots) wake_ups += slot->worker.control().wake_ups.load();
    return {each->hand_overs.load(), static_cast<std::int64_t>(wake_ups)};
  }
  return {};
}

void keep_marks(const assay_material* table, const WorkerProcess& worker) {
  const std::lock_guard lock(all_tables().guard);
  for (const auto& each : all_tables().tables) {
    if (each.get() != table) continue;
    each->keep_marks_of(worker);
    each->hand_overs += worker.control().request.load();
  }
}

void end_workers() {
  const std::lock_guard lock(all_tables().guard);
  for (const auto& table : all_tables().tables) {
    for (const auto& slot : table->slots) table->keep_marks_of(slot->worker);
    table->slots.clear();
  }
}

}  // namespace assay::adapters
