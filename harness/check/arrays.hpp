// SPDX-License-Identifier: BSD-3-Clause
// That a material keeps to its arrays.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "harness/check/battery.hpp"

namespace assay::check {

/// Stress and state of one point after each step of a loading.
using History = std::vector<std::vector<double>>;

/// Points of a batch that do not answer as they do alone.
struct BatchFinding {
  double worst = 0;              ///< difference of a stress, over the largest; of a state, over its own
  std::size_t n = 0, point = 0;  ///< the batch, and the first point that is wrong there, from 1
  std::size_t wrong = 0;         ///< how many of its points are
  std::size_t largest = 1;       ///< batch that was tried
  std::string refusal = {};      ///< why the batch is refused whose points alone are not; or empty
};

inline constexpr double same_in_batch = 1e-12;  ///< vectorised and scalar code may differ in the last digits

/// What the very first calls of a process give.
struct FirstCalls {
  std::vector<History> histories = {};  ///< of single points, for amplitudes_of_first
  BatchFinding batches = {};            ///< of points that are loaded alike
};

/// Along loadings, in batches of several sizes: nothing is written beyond the arrays, nor into what is given, and every
/// component of the results is written. To be taken first: other tests trust the arrays.
TestResult guarded_arrays(const Material& material, const Options& options, FirstCalls& first);

/// From small to large, none beyond the strain that was asked for.
std::array<double, 4> amplitudes_of_first(const Effort& effort);

/// One of these again.
History history(const Material& material, double amplitude);

/// Each parameter a little larger, where its bounds allow that.
std::map<std::string, double> other_parameters(const Material& material);

}  // namespace assay::check
