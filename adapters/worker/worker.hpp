// SPDX-License-Identifier: BSD-3-Clause
// The worker's side: `assay worker`, the process that answers the calls of a host with a model of its own, and what it
// lets the host see of foreign code: when it is busy, at which point it is, what it does to the process.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "adapters/worker/hand_over.hpp"
#include "harness/assay_material.h"

namespace assay::adapters {

/// What the worker is given.
struct WorkerFloor {
  Control& control;
  const char* task;  ///< text
  char* arrays;      ///< of calls
  std::size_t arrays_size;
};

/// The whole life of `assay worker`: takes the files that the host has left open and is the keeper of the worker
/// proper, which runs `work`. Returns the exit status. own: the build of this program; host: that of a host, empty if
/// it has told none. Where they differ, the host is told.
int run_worker(const std::function<void(WorkerFloor&)>& work, const std::string& own = {},
               const std::string& host = {});

/// By the worker: waits for the next call; its operation. Tells that it is answered.
std::uint32_t next_request(Control& control);
void answer(Control& control);

/// Finds the table with `find`, which may throw ModelRefused or std::exception, and answers until the process ends.
void serve_model(WorkerFloor& floor, const std::function<const assay_material*()>& find);

/// A worker's model as the histories that are taken in the worker call it: it answers tasks of
/// harness/history/history_task.hpp. The arrays of each of its calls lie between fences in the memory that is shared,
/// where the host finds them if the worker dies of it.
using FencedModel = std::function<std::vector<double>(std::span<const double> task)>;

/// Of an instance of the table; both outlive it.
FencedModel fenced_model(const assay_material& table, void* self, std::span<const double> parameters,
                         const WorkerFloor& floor);

/// Made before any foreign code. While it lives, points of batches are marked for the host, and what calls do to the
/// process is looked at. One at a time.
class WatchedProcess {
 public:
  explicit WatchedProcess(Control& control);
  ~WatchedProcess();
  WatchedProcess(const WatchedProcess&) = delete;
  WatchedProcess& operator=(const WatchedProcess&) = delete;
};

/// Marks the beginning and the end of foreign code, and what it did to the arithmetic, which is put right.
class ForeignCall {
 public:
  explicit ForeignCall(Control& control);
  ~ForeignCall();
  ForeignCall(const ForeignCall&) = delete;
  ForeignCall& operator=(const ForeignCall&) = delete;

 private:
  Control& control_;
};

/// One of many calls of a model within a request: it alone counts for the limit of time.
class ModelCall {
 public:
  explicit ModelCall(Control& control);
  ~ModelCall();
  ModelCall(const ModelCall&) = delete;
  ModelCall& operator=(const ModelCall&) = delete;

 private:
  Control& control_;
  std::int64_t begin_;
};

}  // namespace assay::adapters
