// SPDX-License-Identifier: BSD-3-Clause
// How the output of another code is read: which of its names is which quantity, in which units, and at which time.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "drivers/format/particle_tables.hpp"

namespace assay::drivers {

/// What is read of a particle. Vectors have 2 or 3 components, F 4 or 9, row-major; of sigma 3 are 11, 22, 12, 4 are
/// 11, 22, 33, 12, 6 are 11, 22, 33, 12, 13, 23, 9 are row-major.
enum class Judged { id, X, x, u, v, F, J, sigma, volume };
inline constexpr std::size_t judged_quantities = 9;
const std::vector<std::string>& names_of(Judged);

struct JudgeTime {
  enum class From { guess, header, column, name, step, list };
  From from = From::guess;
  std::string column;          ///< of each particle
  std::string pattern;         ///< regular expression; its group is the number in the file's name
  double step = 0, start = 0;  ///< what one number is worth, and the time of number 0 [unit of time]
  std::vector<double> values;  ///< of the tables, in their order [unit of time]
  double velocity = 0;         ///< time of the velocities after that of the positions [unit of time]
};

/// What the runs took.
struct JudgeCost {
  std::vector<double> seconds;  ///< of each run, or of all alike; empty: unknown
  double cores = 1;
  std::string machine;
};

struct JudgeMap {
  std::string code;                                            ///< its name
  std::array<std::vector<std::string>, judged_quantities> of;  ///< an array, or a column for each component
  std::vector<int> sigma_components;                           ///< 11, 22, ... of a list of another order
  std::vector<std::string> columns;                            ///< of a text without a header
  double length = 1, time_unit = 1, stress = 1;                ///< SI units in one of the code's
  std::optional<double> velocity;                              ///< likewise; absent: length over time
  JudgeTime time;
  std::string seeds;         ///< file with id and X of each particle, and perhaps its volume; relative to the run
  std::string scene_sha256;  ///< of the scene that the run is of; empty: unknown
  JudgeCost cost;

  const std::vector<std::string>& names(Judged quantity) const { return of[static_cast<std::size_t>(quantity)]; }
  std::vector<std::string>& names(Judged quantity) { return of[static_cast<std::size_t>(quantity)]; }
};

/// A file, or one of `judge_presets()`. Throws InputError.
JudgeMap read_judge_map(const std::string& file_or_preset);

/// `seconds, cores, machine` of a file. Throws InputError.
JudgeCost read_judge_cost(const std::string& file);

/// "lammps", "karamelo", ...
std::vector<std::string> judge_presets();

/// Fills what the map leaves open with names that the table has and that codes use for that. Throws InputError where
/// neither x nor u is found.
void complete_map(JudgeMap& map, const ParticleTable& table);

/// One line: "x is Points, v is velocity, ...".
std::string map_words(const JudgeMap& map);

}  // namespace assay::drivers
