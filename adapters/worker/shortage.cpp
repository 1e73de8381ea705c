// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/shortage.hpp"

#include <sys/resource.h>

#include <mutex>

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

void note_shortage(const std::string& words) {
  const std::lock_guard lock(guard);
  if (noted.empty()) noted = words;
}

std::string shortage() {
  const std::lock_guard lock(guard);
  return noted;
}

}  // namespace assay::adapters
