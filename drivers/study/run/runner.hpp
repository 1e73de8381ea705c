// SPDX-License-Identifier: BSD-3-Clause
// Runs the cases of a study, each in a process of its own as a user would call it: those that are not timed side by
// side, then the timed ones alone. Studies that run in one folder at the same time share its cases, and none runs again
// what another has just finished.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "adapters/process/kept_process.hpp"
#include "drivers/study/plan/study.hpp"
#include "drivers/study/run/case_store.hpp"

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

/// A session begins with a study that is alone in its folder, and ends with the last that has joined it meanwhile.
class StudySession {
 public:
  /// Makes the folder. `resumes`: this study keeps what it finds finished; `is_shard`: it is a part, which no other
  /// part has a case of; `study`: what tells it from others, without blanks. Throws SystemError where the folder cannot
  /// be written to, FolderBusy where another study runs in it, Interrupted.
  StudySession(const std::filesystem::path& folder, const std::string& study, bool resumes, bool is_shard);
  StudySession(const StudySession&) = delete;
  StudySession& operator=(const StudySession&) = delete;
  ~StudySession();

  /// Who began it, "process 12 on host", where that is not this study; empty otherwise.
  const std::string& begun_by() const { return begun_by_; }

  /// Whether finished cases stay: as whoever began it wants it, since nobody may take a case away that another counts.
  bool resumes() const { return resumes_; }

  /// Whether a file was written since the session began.
  bool has_seen(const std::filesystem::path& file) const;

 private:
  void enter(const std::filesystem::path& file, const std::string& study, bool is_shard);

  int file_ = -1;  ///< locked, shared
  bool resumes_;
  std::filesystem::file_time_type begin_;
  std::string begun_by_;
};

/// Cases are dealt out in turn, so that the expensive resolutions are shared.
struct Shard {
  std::size_t index = 1, count = 1;  ///< this one, from 1, of so many
  bool holds(std::size_t case_number) const { return (case_number - 1) % count == index - 1; }
};

struct RunnerOptions {
  std::string program = "/proc/self/exe";  ///< that runs a case
  int jobs = 1;                            ///< threads of cases that run side by side
  bool resume = false;                     ///< finished cases stay as they are
  const StudySession* session = nullptr;   ///< cases that were finished in it stay, too; null: none
  Shard shard = {};
};

/// What a runner tells on the way.
struct RunnerReport {
  std::size_t done = 0, total = 0;        ///< cases of this call, with those that were kept
  double fraction = 0;                    ///< of the expected work
  const PlannedCase* finished = nullptr;  ///< the case that has just ended
  const PlannedCase* running = nullptr;   ///< a case that runs
  bool waits = false;                     ///< another study runs that case
};

struct RunnerSummary {
  std::size_t run = 0, kept = 0, torn = 0;
};

/// Throws SystemError where results cannot be written: what is finished stays; Interrupted when a signal came.
RunnerSummary run_cases(const Plan& plan, const CaseStore& store, const RunnerOptions& options,
                        const std::function<void(const RunnerReport&)>& tell);

}  // namespace assay::drivers
