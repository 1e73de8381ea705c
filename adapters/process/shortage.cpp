// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/process/shortage.hpp"

#include <pthread.h>
#include <sys/resource.h>

#include <algorithm>
#include <mutex>
#include <utility>

namespace assay::adapters {

namespace {

struct Need {
  __rlimit_resource_t resource;
  rlim_t least;
  const char* what;
  const char* option;
};

constexpr rlim_t mebibyte = rlim_t{1} << 20;
constexpr Need needs[] = {{RLIMIT_AS, 1024 * mebibyte, "memory is", "-v"},
                          {RLIMIT_DATA, 256 * mebibyte, "memory is", "-d"},
                          {RLIMIT_STACK, mebibyte, "the stack is", "-s"}};

std::string size_words(rlim_t bytes) {
  return bytes < mebibyte ? std::to_string(bytes / 1024) + " KiB" : std::to_string(bytes / mebibyte) + " MiB";
}

std::mutex guard;
std::string noted;

}  // namespace

void enlarge_stack(std::size_t bytes) {
  rlimit stack{};
  ::getrlimit(RLIMIT_STACK, &stack);
  if (stack.rlim_cur == RLIM_INFINITY || stack.rlim_cur < bytes) {
    stack.rlim_cur = std::min<rlim_t>(bytes, stack.rlim_max);
    ::setrlimit(RLIMIT_STACK, &stack);
  }
#ifdef __GLIBC__
  pthread_attr_t threads;
  std::size_t size = 0;
  if (::pthread_getattr_default_np(&threads) != 0) return;
  if (::pthread_attr_getstacksize(&threads, &size) == 0 && size < bytes &&
      ::pthread_attr_setstacksize(&threads, bytes) == 0) {
    ::pthread_setattr_default_np(&threads);
  }
  ::pthread_attr_destroy(&threads);
#endif
}

std::string tight_limits() {
  std::string words;
  for (const Need& need : needs) {
    rlimit found{};
    if (::getrlimit(need.resource, &found) != 0 || found.rlim_cur == RLIM_INFINITY || found.rlim_cur >= need.least)
      continue;
    words += (words.empty() ? "" : ", ") + std::string(need.what) + " limited to " + size_words(found.rlim_cur) +
             " (ulimit " + need.option + ")";
  }
  return words;
}

std::string processor_limit() {
  static const rlim_t at_first = [] {  // with each SIGXCPU the system lets a second more go by
    rlimit found{};
    return ::getrlimit(RLIMIT_CPU, &found) == 0 ? found.rlim_cur : RLIM_INFINITY;
  }();
  return at_first == RLIM_INFINITY ? std::string()
                                   : "processor time is limited to " + std::to_string(at_first) + " s (ulimit -t)";
}

void leave_time_for_words() {
  rlimit found{};
  if (processor_limit().empty() || ::getrlimit(RLIMIT_CPU, &found) != 0) return;
  if (found.rlim_cur < found.rlim_max || found.rlim_max < 2) return;
  found.rlim_cur = found.rlim_max - 1;
  ::setrlimit(RLIMIT_CPU, &found);
}

void note_shortage(const std::string& words) {
  const std::lock_guard lock(guard);
  if (noted.empty()) noted = words;
}

void note_killed_worker() {
  const std::string limit = processor_limit();
  note_shortage(limit.empty() ? "a worker was killed (signal 9) from outside, as the system does if memory is short"
                              : "a worker was killed (signal 9), and " + limit + ": that may be why");
}

std::string shortage() {
  const std::lock_guard lock(guard);
  return noted;
}

std::string take_shortage() {
  const std::lock_guard lock(guard);
  return std::exchange(noted, {});
}

}  // namespace assay::adapters
