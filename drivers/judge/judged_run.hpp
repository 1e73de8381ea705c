// SPDX-License-Identifier: BSD-3-Clause
// The output of one run of another code, in SI units and over time.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "drivers/judge/judge_map.hpp"
#include "drivers/judge/shared_column.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay::drivers {

inline constexpr double not_written = std::numeric_limits<double>::quiet_NaN();

/// Particles at one time. What the code does not write is empty. What is no number is NaN.
struct JudgedFrame {
  std::string name;                 ///< file and frame, for messages
  double t = 0;                     ///< of the positions [s]
  double t_velocity = 0;            ///< [s]
  SharedColumn<double> id, volume;  ///< volume: [m^3]
  SharedColumn<Vector3> X;          ///< [m]
  std::vector<Vector3> x, v;        ///< [m], [m/s]; 0 in directions that are not written
  std::vector<Tensor> F, sigma;     ///< [1], [Pa]; NaN in components that are not written
  std::vector<double> J;            ///< [1]
  std::size_t size() const { return x.size(); }
};

struct JudgedRun {
  std::string name;                        ///< as the user gives it
  JudgeMap map;                            ///< completed
  std::vector<JudgedFrame> frames;         ///< ascending in time
  std::string time_words;                  ///< where the times come from
  std::vector<std::string> left_out = {};  ///< other files in the folder
  double rounding = 0;                     ///< of positions, by the digits that are written [m]
  std::vector<std::string> unread = {};    ///< columns and arrays that no quantity is read from
};

/// A file, or a folder with one file a time; where that has a collection (.pvd), the files that it names. Throws
/// InputError. dimension: of the scene; vectors have as many components, or three.
JudgedRun read_judged_run(const std::string& run, const JudgeMap& map, int dimension = 2);

/// id and X of the particles, and their volumes where they are there, from a file as the map names them.
JudgedFrame read_seeds(const std::string& file, const JudgeMap& map);

}  // namespace assay::drivers
