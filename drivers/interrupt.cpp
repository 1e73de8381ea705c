// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/interrupt.hpp"

#include <atomic>
#include <csignal>

#include "adapters/worker/worker_process.hpp"
#include "drivers/exit_guard.hpp"

namespace assay::drivers {

namespace {

std::atomic<int> first_signal{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may touch nothing else");

void on_signal(int signal) {
  int none = 0;
  if (!first_signal.compare_exchange_strong(none, signal)) leave_process(128 + signal);
}

}  // namespace

void watch_interrupts() {
  first_signal = 0;
  adapters::give_up_waiting = interrupted;  // for a worker that does not answer
  struct sigaction action = {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  // No SA_RESTART: a read that waits for ever (a pipe without a writer) must come back.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction old = {};
    sigaction(signal, nullptr, &old);
    if (old.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);  // nohup and shells ask for that
  }
}

bool interrupted() { return first_signal != 0; }

int interrupt_signal() { return first_signal; }

void stop_if_interrupted() {
  if (const int signal = first_signal) throw Interrupted{signal};
}

}  // namespace assay::drivers
