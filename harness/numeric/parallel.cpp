// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>
#include <vector>

namespace assay {

void for_each_index(int count, const Workers& workers, const std::function<void(int)>& body) {
  std::atomic<int> next{0}, failed_at{std::numeric_limits<int>::max()};
  std::mutex guard;
  std::exception_ptr failure;
  const auto work = [&](bool calling) {
    for (int i = next++; i < count && i < failed_at; i = next++) {  // smaller ones than the failed are still done
      try {
        if (calling && workers.poll) workers.poll();
        body(i);
      } catch (...) {
        const std::lock_guard lock(guard);
        if (i < failed_at) failed_at = i, failure = std::current_exception();
      }
    }
  };
  std::vector<std::thread> others;
  for (int k = 1; k < std::min(workers.threads, count); ++k) others.emplace_back(work, false);
  work(true);
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace assay
