// SPDX-License-Identifier: BSD-3-Clause
// The files of a run, and the times of what they hold.
#pragma once

#include <map>
#include <regex>
#include <string>
#include <vector>

#include "drivers/judge/judge_map.hpp"

namespace assay::drivers {

struct RunFiles {
  std::vector<std::string> files;
  std::vector<std::string> left_out;  ///< names of other files in the folder
};

/// A file, or those of a folder in the order of their numbers: of names that differ in numbers alone the most. Where
/// the folder has a collection (.pvd), the collection. Throws InputError.
RunFiles files_of_run(const std::string& run);

/// The file of seeds that a map names, for this run: the one in the run's folder, else in the folder above, for grids
/// have seeds of their own; else the file as it is named. Empty where the map names none. Throws InputError.
std::string seeds_file_of(const std::string& run, const std::string& seeds);

/// cost.yaml in the folder of a run, or out.cost.yaml beside out.csv; empty where there is none.
std::string cost_file_of(const std::string& run);

/// The times of tables, as the map says or as they tell themselves.
class TimeOf {
 public:
  /// Throws InputError.
  explicit TimeOf(const JudgeTime& time);

  /// Rows of each time [unit of the code]. number: of the table in the run, from 0. Throws InputError.
  std::map<double, std::vector<std::size_t>> operator()(const ParticleTable& table, std::size_t number);
  const std::string& words() const { return words_; }
  /// Name of the column, if the times are one's.
  const std::string& column() const { return column_; }

 private:
  JudgeTime::From guessed(const ParticleTable& table);
  double one_time(JudgeTime::From from, const ParticleTable& table, std::size_t number);

  JudgeTime time_;
  std::regex pattern_;
  std::string column_ = time_.column, words_ = "times are a column's";
};

}  // namespace assay::drivers
