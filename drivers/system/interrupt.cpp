// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/interrupt.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <string>

#include "adapters/library.hpp"
#include "adapters/process/shortage.hpp"
#include "adapters/worker/worker_process.hpp"
#include "drivers/system/exit_guard.hpp"
#include "drivers/system/input_error.hpp"
#include "harness/material/own_process.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::drivers {

namespace {

std::atomic<int> first_signal{0};
std::atomic<std::int64_t> first_time{0};  ///< [ns] on the monotonic clock
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "a signal handler may touch nothing else");

/// One stop may arrive twice: timeout(1) signals its child and then the child's process group.
constexpr std::int64_t same_stop = 300'000'000;  // [ns]

/// A native model that does not come back polls no flag: a second SIGTERM comes from here where none of us has noticed
/// the first signal by then.
constexpr time_t grace = 8;  // [s]
timer_t grace_timer;
std::atomic<bool> has_timer{false}, is_noticed{false}, is_own{false}, keeps_what_there_is{false};

/// Async-signal-safe.
void set_grace(time_t seconds) {
  itimerspec when{};
  when.it_value.tv_sec = seconds;
  if (has_timer) timer_settime(grace_timer, 0, &when, nullptr);
}

void make_timer() {
  if (has_timer) return;
  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGTERM;
  has_timer = timer_create(CLOCK_MONOTONIC, &event, &grace_timer) == 0;
}

void on_signal(int signal, siginfo_t* why, void* /*context*/) {
  std::int64_t none = 0;
  const std::int64_t now = now_ns();
  if (first_time.compare_exchange_strong(none, now)) {
    first_signal = signal;
    is_own = why->si_code <= 0 && why->si_code != SI_TIMER && why->si_pid == ::getpid();
    set_grace(grace);
  } else if (now - none > same_stop && signal != SIGXCPU) {  // which comes again every second
    leave_process(128 + (why->si_code == SI_TIMER ? first_signal.load() : signal));
  }
}

/// The signal is noticed by what cleans up, or by a thread that only waits, while a native model takes long in another.
int noticed() {
  constexpr time_t to_clean_up = 30;  // [s]
  const int signal = first_signal;
  if (signal != 0 && !is_noticed.exchange(true)) set_grace(to_clean_up);
  return signal;
}

constexpr int stop_signals[] = {SIGINT, SIGTERM, SIGHUP, SIGXCPU};

bool is_ours(int signal) {
  struct sigaction present = {};
  return sigaction(signal, nullptr, &present) == 0 && present.sa_sigaction == on_signal;
}

/// Of all threads of the process [ns].
std::int64_t processor_ns() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

std::atomic<std::int64_t> deadline_ns{0};  ///< 0: none

}  // namespace

InterruptWatch::InterruptWatch()
    : mine_(adapters::own_library().empty() && std::ranges::none_of(stop_signals, is_ours)) {
  if (mine_) watch_interrupts();
}

InterruptWatch::~InterruptWatch() {
  if (!mine_) return;
  adapters::give_up_waiting = nullptr;
  for (const int signal : stop_signals) {
    if (is_ours(signal)) std::signal(signal, SIG_DFL);
  }
}

void watch_interrupts() {
  first_signal = 0;
  first_time = 0;
  is_noticed = false;
  make_timer();
  set_grace(0);
  adapters::give_up_waiting = interrupted;  // for a worker that does not answer
  struct sigaction action = {};
  action.sa_sigaction = on_signal;
  action.sa_flags = SA_SIGINFO;
  sigemptyset(&action.sa_mask);
  // No SA_RESTART: a read that waits for ever (a pipe without a writer) must come back.
  for (const int signal : stop_signals) {
    struct sigaction old = {};
    sigaction(signal, nullptr, &old);
    if (old.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);  // nohup and shells ask for that
  }
}

bool interrupted() { return noticed() != 0; }

int interrupt_signal() { return first_signal; }

bool interrupted_from_inside() { return is_own; }

KeptAfterInterrupt::KeptAfterInterrupt() { keeps_what_there_is = true; }

KeptAfterInterrupt::~KeptAfterInterrupt() { keeps_what_there_is = false; }

Deadline::Deadline(double seconds) { deadline_ns = processor_ns() + static_cast<std::int64_t>(1e9 * seconds); }

Deadline::~Deadline() { deadline_ns = 0; }

void stop_if_interrupted() {
  end_a_copy();
  if (const int signal = noticed(); signal != 0 && !keeps_what_there_is) throw Interrupted{signal};
  if (const std::string words = adapters::shortage(); !words.empty()) throw SystemError(words);
  if (const std::int64_t deadline = deadline_ns; deadline != 0 && processor_ns() > deadline) throw TimeIsUp{};
}

}  // namespace assay::drivers
