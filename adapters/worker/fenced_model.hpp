// SPDX-License-Identifier: BSD-3-Clause
// A worker's model as the histories that are taken in the worker call it: the arrays of each call lie between fences in
// the memory that is shared, where the host finds them if the worker dies of it.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "adapters/worker/worker.hpp"

namespace assay {
class HistoryTasks;
}

namespace assay::adapters {

class FencedModel {
 public:
  /// An instance of the table; both outlive this.
  FencedModel(const assay_material& table, void* self, std::span<const double> parameters, const WorkerFloor& floor);
  ~FencedModel();
  FencedModel(const FencedModel&) = delete;
  FencedModel& operator=(const FencedModel&) = delete;

  /// Of a task of harness/history/history_task.hpp.
  std::vector<double> answer(std::span<const double> task);

 private:
  struct Table;
  std::unique_ptr<Table> table_;
  std::unique_ptr<HistoryTasks> tasks_;
};

}  // namespace assay::adapters
