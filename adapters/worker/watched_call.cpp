// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/watched_call.hpp"

#include <unistd.h>

#include <memory>

#include "adapters/foreign/host_values.hpp"
#include "adapters/worker/futex.hpp"
#include "adapters/worker/process_watch.hpp"
#include "harness/material/own_process.hpp"
#include "harness/material/progress_mark.hpp"
#include "harness/numeric/arithmetic.hpp"

namespace assay::adapters {

namespace {

/// Looks at what the model has done to its process: after each of the first calls, then at most once a millisecond.
class Lookout {
 public:
  explicit Lookout(const Control& control) : memory_limit_(control.memory_limit) {}

  void look(Control& control, std::int64_t now) {
    constexpr int first_calls = 16;
    constexpr std::int64_t pause_ns = 1000000;
    if (++calls_ > first_calls && now - last_ns_ < pause_ns) return;
    last_ns_ = now;
    control.habits.fetch_or(process_.habits_so_far());
    if (data_bytes(::getpid()) <= begin_bytes_ + memory_limit_) return;
    control.claim.store(static_cast<std::uint32_t>(Death::memory));
    ::_exit(1);
  }

 private:
  ProcessWatch process_;
  std::uint64_t begin_bytes_ = data_bytes(::getpid()), memory_limit_;
  std::int64_t last_ns_ = 0;
  int calls_ = 0;
};

std::unique_ptr<Lookout> lookout;

}  // namespace

ForeignCall::ForeignCall(Control& control) : control_(control) {
  control_.point.store(no_point);
  reset_arithmetic();
  control_.busy_since.store(now_ns());
}

ForeignCall::~ForeignCall() {
  end_a_copy();
  const std::int64_t now = now_ns();
  control_.busy_ns.store(now - control_.busy_since.load());
  control_.busy_since.store(0);
  control_.arithmetic.store(put_arithmetic_right());
  lookout->look(control_, now);
}

ModelCall::ModelCall(Control& control) : control_(control), begin_(now_ns()) {
  control_.point.store(no_point, std::memory_order_relaxed);
  control_.busy_since.store(begin_, std::memory_order_release);
}

ModelCall::~ModelCall() {
  end_a_copy();
  control_.busy_since.store(0, std::memory_order_release);
  lookout->look(control_, begin_);  // the clock is not read again
}

WatchedProcess::WatchedProcess(Control& control) {
  probes_beyond = true;
  point_mark = &control.point;
  phase_mark = &control.phase;
  lookout = std::make_unique<Lookout>(control);
}

WatchedProcess::~WatchedProcess() {
  lookout.reset();
  probes_beyond = false;
  phase_mark = nullptr;
  point_mark = nullptr;
}

}  // namespace assay::adapters
