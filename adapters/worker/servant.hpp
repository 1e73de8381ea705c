// SPDX-License-Identifier: BSD-3-Clause
// The worker's side of a model: it answers calls with a table of its own process.
#pragma once

#include <functional>
#include <string>

#include "adapters/worker/warden.hpp"

namespace assay::adapters {

/// What a worker that cannot find its model says of that: the parts of an error at a key of the description.
struct ModelRefused {
  std::string key, what, known;
};

/// Finds the table with `find`, which may throw ModelRefused or std::exception, and answers until the process ends.
void serve_model(WorkerFloor& floor, const std::function<const assay_material*()>& find);

/// Made before any foreign code. While it lives, points of batches are marked for the host, and what calls do to the
/// process is looked at. One at a time.
class WatchedProcess {
 public:
  explicit WatchedProcess(Control& control);
  ~WatchedProcess();
  WatchedProcess(const WatchedProcess&) = delete;
  WatchedProcess& operator=(const WatchedProcess&) = delete;
};

/// Waits for the next request; the operation.
std::uint32_t next_request(Control& control);
void answer(Control& control);

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
