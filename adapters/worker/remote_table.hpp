// SPDX-License-Identifier: BSD-3-Clause
// A table of the ABI whose functions run in worker processes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "adapters/foreign/written_inputs.hpp"
#include "adapters/library.hpp"
#include "adapters/worker/worker.hpp"
#include "adapters/worker/worker_process.hpp"

namespace assay::adapters {

/// Starts a worker and asks it for its table; calls go to as many workers as there are at once. A call in which the
/// worker dies fails with words of how; the next one goes to a new worker. The table lives as long as the process, its
/// workers until it ends. Throws std::system_error, and ModelRefused: that of the worker, or how the worker came to its
/// end.
const assay_material* remote_table(const WorkerStart& start);

/// What a remote table's workers are started with; no task for any other table.
WorkerStart start_of(const assay_material* table);

/// As the model itself has them: a remote table serves several threads, whatever the model does.
std::uint32_t own_flags(const assay_material* table);

/// What the workers of a remote table have done so far; nothing of any other table.
struct WorkerMarks {
  std::string printed = {};
  Habits habits = 0;            ///< what the model has done to them, or-ed Habit
  bool ended = false;           ///< one has, in a call
  std::int64_t hand_overs = 0;  ///< what they were asked
  std::int64_t wake_ups = 0;    ///< how often the system had to wake one side for it
};
WorkerMarks marks_of(const assay_material* table);

/// Adds what a model has printed and done in a worker that its table knows nothing of, and that is about to end.
void keep_marks(const assay_material* table, const WorkerProcess& worker);

/// Ends the workers of all remote tables: to be called before the process ends.
void end_workers();

/// Ends a remote table with its workers; nothing happens to any other table. Nobody may use it any more.
void forget_remote_table(const assay_material* table);

/// The remote tables that a thread makes until all are told, or until this ends, which ends them. At most one a thread
/// at a time is being told.
class OwnRemoteTables {
 public:
  OwnRemoteTables();
  ~OwnRemoteTables();
  OwnRemoteTables(const OwnRemoteTables&) = delete;
  OwnRemoteTables& operator=(const OwnRemoteTables&) = delete;
  void all_are_told();

 private:
  friend const assay_material* remote_table(const WorkerStart& start);
  friend void forget_remote_table(const assay_material* table);
  std::vector<const assay_material*> tables_;
};

}  // namespace assay::adapters
