// SPDX-License-Identifier: BSD-3-Clause
// The process between a host and its worker: it runs no foreign code, so that whatever the worker does to itself, its
// end is told, what it has started ends with it, and its files go.
#pragma once

#include <functional>

#include "adapters/worker/control.hpp"

namespace assay::adapters {

/// What the worker is given.
struct WorkerFloor {
  Control& control;
  const char* task;  ///< text
  char* arrays;      ///< of calls
  std::size_t arrays_size;
};

/// The whole life of `assay worker`: takes the files that the host has left open, starts the worker, which runs `work`
/// in a folder and a process group of its own, and watches it to its end or that of the host. Returns the exit status.
int run_warden(const std::function<void(WorkerFloor&)>& work);

}  // namespace assay::adapters
