// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/data/crew.hpp"

#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <memory>
#include <new>
#include <system_error>
#include <thread>

namespace assay::mpm {

namespace {

/// Longer than most passes of a step leave between two loops, and a small part of what a scheduler gives a thread at
/// once: with another program on one of two cores, waits of milliseconds awake cost 40 times the run's own time.
constexpr std::chrono::microseconds awake_for{100};
constexpr int looks_a_time = 64;  ///< between two looks at the clock

void relax() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

thread_local int own_member = 0;
thread_local bool in_part = false;
thread_local bool shares_core = false;  ///< there are more threads than cores: whoever waits sleeps

/// ready(), looked at for a moment.
bool looked_for(const auto& ready) {
  if (shares_core) return ready();
  const auto end = std::chrono::steady_clock::now() + awake_for;
  do {
    for (int k = 0; k < looks_a_time; ++k) {
      if (ready()) return true;
      relax();
    }
  } while (std::chrono::steady_clock::now() < end);
  return ready();
}

/// The place of one helper. Jobs are numbered; numbers may wrap round.
struct alignas(64) Seat {
  std::atomic<std::uint32_t> taken{0};  ///< the last job that its helper, or the calling thread in its place, has taken
  std::atomic<std::uint32_t> done{0};   ///< the last that its helper has ended

  /// For one of them alone; not for a helper that comes when the job has ended.
  bool take(std::uint32_t job) {
    std::uint32_t before = taken.load();
    return static_cast<std::int32_t>(job - before) > 0 && taken.compare_exchange_strong(before, job);
  }
};

/// What helpers see; it stays where a process ends amid a job.
struct Work {
  std::atomic<std::uint32_t> job{0};
  std::atomic<bool> over{false}, shares_cores{false};
  const std::function<void(int)>* part = nullptr;  ///< of the job that a seat was taken for
  std::deque<Seat> seats;                          ///< which do not move
};

void help(const std::shared_ptr<Work>& work, Seat& seat, int member, std::uint32_t seen) {
  own_member = member;
  in_part = true;
  for (;;) {
    if (!looked_for([&] { return work->job.load(std::memory_order_acquire) != seen; })) work->job.wait(seen);
    if (work->over) return;
    seen = work->job.load(std::memory_order_acquire);
    shares_core = work->shares_cores;
    if (!seat.take(seen)) continue;
    (*work->part)(member);
    seat.done.store(seen, std::memory_order_release);
    seat.done.notify_one();
  }
}

/// Threads that cannot be joined; a search for leaks finds them here.
struct Left {
  std::vector<std::thread> threads;
  Left* next;
};
std::atomic<Left*> left{nullptr};

void leave(std::vector<std::thread> threads) {
  auto* const last = new (std::nothrow) Left{std::move(threads), left.load()};
  while (last && !left.compare_exchange_weak(last->next, last)) {
  }
}

/// Which copy of the process this is: a question that a loop can ask without a call of the system.
std::atomic<std::uint32_t> forks{0};
[[maybe_unused]] const int counts_forks = ::pthread_atfork(nullptr, nullptr, [] { ++forks; });

/// The helpers of one thread.
class Crew {
 public:
  Crew() = default;
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  ~Crew() {
    if (in_part || process_ != ::getpid()) {  // which no way of making a process passes by
      leave(std::move(helpers_));
      return;
    }
    work_->over = true;
    ++work_->job;
    work_->job.notify_all();
    for (std::thread& helper : helpers_) helper.join();
  }

  /// A process that was forked has none of the threads.
  bool is_of_this_process() const { return forks_ == forks.load(std::memory_order_relaxed); }

  void run(int threads, const std::function<void(int)>& part) {
    static const unsigned cores = std::thread::hardware_concurrency();
    shares_core = static_cast<unsigned>(threads) > cores;
    work_->shares_cores = shares_core;
    const std::size_t helpers = enlist(static_cast<std::size_t>(threads - 1));
    const std::uint32_t job = work_->job.load() + 1;
    for (std::size_t k = helpers; k < work_->seats.size(); ++k) work_->seats[k].take(job);  // not theirs
    work_->part = &part;
    work_->job.store(job, std::memory_order_release);
    work_->job.notify_all();
    in_part = true;
    part(0);
    in_part = false;
    for (std::size_t k = 0; k < helpers; ++k) {
      Seat& seat = work_->seats[k];
      if (!seat.take(job)) await(seat.done, job);
    }
  }

 private:
  /// So many, or as many as the system gives.
  std::size_t enlist(std::size_t wanted) {
    while (helpers_.size() < wanted) {
      const std::uint32_t job = work_->job.load();
      Seat& seat = work_->seats.emplace_back();
      seat.taken = seat.done = job;
      const int member = static_cast<int>(work_->seats.size());
      try {
        helpers_.emplace_back([work = work_, &seat, member, job] { help(work, seat, member, job); });
      } catch (const std::system_error&) {
        work_->seats.pop_back();
        break;
      }
    }
    return std::min(wanted, helpers_.size());
  }

  std::shared_ptr<Work> work_ = std::make_shared<Work>();
  std::vector<std::thread> helpers_;
  pid_t process_ = ::getpid();
  std::uint32_t forks_ = forks.load();
};

}  // namespace

int crew_member() { return own_member; }

void await(const std::atomic<std::uint32_t>& value, std::uint32_t wanted) {
  if (looked_for([&] { return value.load(std::memory_order_acquire) == wanted; })) return;
  for (std::uint32_t now = value.load(); now != wanted; now = value.load()) value.wait(now);
}

void with_crew(int threads, const std::function<void(int)>& part) {
  if (threads <= 1 || in_part) return part(own_member);
  thread_local std::unique_ptr<Crew> crew;
  if (!crew || !crew->is_of_this_process()) crew = std::make_unique<Crew>();
  crew->run(threads, part);
}

}  // namespace assay::mpm
