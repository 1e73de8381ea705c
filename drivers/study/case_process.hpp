// SPDX-License-Identifier: BSD-3-Clause
// One run of a case, in a process of its own: `assay run` as a user would call it.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "adapters/process/kept_process.hpp"

namespace assay::drivers {

/// How a run ended.
struct ProcessEnd {
  int status = 0;         ///< exit status; 128 + signal where it died of one
  bool stopped = false;   ///< it took longer than its limit
  std::string last_line;  ///< the last that it printed on standard error
  double wall_s = 0;      ///< of the process [s]
  double cpu_s = 0;       ///< of it and of those that it waited for [s]
  double others = 0;      ///< cores that other programs kept busy meanwhile
};

class CaseProcess {
 public:
  /// Starts the program with these arguments; it dies with this process. limit_s: 0 is none. Throws SystemError.
  CaseProcess(const std::string& program, const std::vector<std::string>& arguments, double limit_s);
  CaseProcess(CaseProcess&& other) = default;
  CaseProcess& operator=(CaseProcess&&) = delete;
  /// Ends it where it still runs: it removes what is not complete.
  ~CaseProcess();

  /// Whether it has ended; kills it where it took too long.
  bool is_over();
  const ProcessEnd& end() const { return end_; }

 private:
  using Clock = std::chrono::steady_clock;

  std::unique_ptr<adapters::PrintedFile> errors_;
  std::unique_ptr<adapters::KeptProcess> process_;  ///< none: it has ended
  double limit_s_;
  Clock::time_point start_;
  double busy_at_start_;
  ProcessEnd end_;
};

/// Processor time of all programs of this machine since it was started [s]; 0 where that is not told.
double machine_busy_s();

/// "AMD EPYC, 2 cores".
std::string machine_name();

}  // namespace assay::drivers
