// SPDX-License-Identifier: BSD-3-Clause
// The folder of a case: what a finished one holds, and whether it can be trusted. The list of cases with that.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "drivers/study/plan/study.hpp"
#include "drivers/study/run/study_case.hpp"

namespace assay::drivers {

/// What case.json says beside the hashes of the other files and its own.
struct CaseRecord {
  std::string crashed;   ///< how the process ended, where it left no result
  bool stopped = false;  ///< it took longer than the study allows
  ClockReadings clock;
  double limit_s = 0;  ///< of the study, where it was stopped [s]
};

enum class CaseState {
  finished,
  missing,  ///< never finished
  torn,     ///< a file is not what it was, or cannot be read
  crashed,  ///< finished without a result: worth another attempt
  stopped,  ///< took longer than the study's limit: another study may have another
};

/// Who runs a case: two studies, or two shards that were given the same part, must not do it at once. Held until it
/// goes, or the process that holds it.
class CaseLock {
 public:
  /// None where another holds it, or a run still writes into the folder. Makes the folder. Throws SystemError.
  static std::optional<CaseLock> tried(const std::filesystem::path& folder);

  CaseLock(CaseLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  CaseLock& operator=(CaseLock&&) = delete;
  ~CaseLock();

 private:
  explicit CaseLock(int file) : file_(file) {}
  int file_;
};

class CaseStore {
 public:
  /// folder: of the study's results.
  explicit CaseStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path folder_of(const std::string& key) const { return folder_ / "cases" / key; }

  /// The file that says how a case has ended.
  std::filesystem::path record_of(const std::string& key) const;

  CaseState state_of(const std::string& key) const;

  /// Whether a case that is not torn was timed alone.
  bool is_timed(const std::string& key) const;

  /// After which a case was stopped [s]; 0 of another.
  double limit_of(const std::string& key) const;

  /// The right to run the case; none where another study does. Throws SystemError.
  std::optional<CaseLock> lock(const PlannedCase& one) const { return CaseLock::tried(folder_of(one.key)); }

  /// Makes the folder with case.yaml and takes all that an earlier run has left away. Returns the scene's file. Throws
  /// SystemError.
  std::filesystem::path begin(const PlannedCase& one) const;

  /// The mark of a finished case, with the hashes of its files. Throws SystemError.
  void finish(const PlannedCase& one, const CaseRecord& record) const;

  /// What a finished case has found; the outcome is `missing` of any other.
  StudyCase read(const PlannedCase& one) const;

  /// How many finished cases there are whose keys are none of these.
  std::size_t finished_besides(const std::set<std::string>& keys) const;

  /// Copies a case that is finished, or has crashed, in another study's folder; false where it is not so there, or the
  /// case is being run here. Throws SystemError.
  bool take(const PlannedCase& one, const CaseStore& from, CaseState state = CaseState::finished) const;

 private:
  std::filesystem::path folder_;
};

/// A time of result.json; none where it is not there or torn.
Figure figure_of(const std::filesystem::path& result_json, const std::string& key);

/// One line a case, fields divided by tabulators: number, key, state (finished, missing, torn, crashed, stopped, n/a),
/// particle-steps expected, label.
std::string list_text(const Plan& plan, const CaseStore& store);

/// The same as JSON, with the values on the axes.
std::string list_json(const Plan& plan, const CaseStore& store);

}  // namespace assay::drivers
