// SPDX-License-Identifier: BSD-3-Clause
// Time and memory that this process has taken.
#include <sys/resource.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "drivers/simulation/simulate.hpp"

namespace assay::drivers {

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto of = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return of(usage.ru_utime) + of(usage.ru_stime);
}

std::int64_t peak_memory() {
  // A program that was started by exec() inherits the peak of getrusage() from the process that started it.
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    long long kibibytes = 0;
    if (std::sscanf(line.c_str(), "VmHWM: %lld kB", &kibibytes) == 1) return kibibytes * std::int64_t{1024};
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * std::int64_t{1024};
}

}  // namespace assay::drivers
