// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/interrupt.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>

namespace assay::drivers {

namespace {

std::atomic<int> first_signal{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may touch nothing else");

void on_signal(int signal) {
  int none = 0;
  if (!first_signal.compare_exchange_strong(none, signal)) _exit(128 + signal);
}

}  // namespace

void watch_interrupts() {
  first_signal = 0;
  struct sigaction action = {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;  // a write in progress must not fail with EINTR
  for (const int signal : {SIGINT, SIGTERM}) {
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
