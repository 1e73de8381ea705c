// SPDX-License-Identifier: BSD-3-Clause
// Foreign code in a worker, as its host sees it: when it is busy, at which point it is, what it does to the process.
#pragma once

#include <cstdint>

#include "adapters/worker/control.hpp"

namespace assay::adapters {

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
