// SPDX-License-Identifier: BSD-3-Clause
// A program in a process of its own, within bounds of time and memory that the kernel enforces.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace assay::fuzz {

struct Bounds {
  double wall_s = 300;             ///< then it is killed, with all processes that it started: it waits for something
  double cpu_s = 20;               ///< RLIMIT_CPU
  std::int64_t address_bytes = 0;  ///< RLIMIT_AS; 0: none, as under sanitizers, which reserve terabytes
  std::int64_t file_bytes = std::int64_t{64} << 20;  ///< RLIMIT_FSIZE
};

struct Outcome {
  int status = -1;                  ///< exit status; 128 + signal where it died of one
  bool timed_out = false;           ///< killed at the bound of time
  std::string out, error;           ///< standard output and error, up to 1 MiB each
  double wall_s = 0, cpu_s = 0;     ///< of the process and those that it waited for
  std::int64_t resident_bytes = 0;  ///< peak
};

/// Runs `program words...` in `folder`, with standard output and error in files there while it runs.
Outcome run_bounded(const std::string& program, const std::vector<std::string>& words, const std::string& folder,
                    const Bounds& bounds);

}  // namespace assay::fuzz
