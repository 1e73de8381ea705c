// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/worker.hpp"

#include <unistd.h>

#include <cstdio>
#include <exception>
#include <memory>

#include "adapters/foreign/host_values.hpp"
#include "adapters/process/kept_process.hpp"
#include "adapters/process/process_watch.hpp"
#include "adapters/process/shortage.hpp"
#include "adapters/worker/worker_process.hpp"
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

int run_worker(const std::function<void(WorkerFloor&)>& work) {
  const SharedMemory memory = SharedMemory::of_file(memory_file);
  auto* base = static_cast<char*>(memory.data());
  WorkerFloor floor{*static_cast<Control*>(memory.data()), base + task_offset, base + arrays_offset,
                    memory.size() - arrays_offset};
  enlarge_stack(std::size_t{1} << 26);
  const auto worker = [&](Fate& fate) {
    int status = 0;
    mark_crashes(fate);
    own_this_process();
    try {
      work(floor);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
      status = 1;
    }
    std::fflush(nullptr);
    leave_now(status);
  };
  return keep({.work = worker}, floor.control, lifeline_file);
}

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
