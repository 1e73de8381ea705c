// SPDX-License-Identifier: BSD-3-Clause
// A history as a whole.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "harness/history/history.hpp"

namespace assay {

/// What a history was at given times.
struct HistoryTrail {
  std::size_t width = 9;          ///< of a row: 9 components of the Cauchy stress, then the state
  std::vector<double> rows = {};  ///< one for each time
  std::vector<Branch> branches = {};
  bool flickers = false;
  double error = 0;
  std::int64_t calls = 0;

  std::span<const double> row(std::size_t k) const { return std::span(rows).subspan(k * width, width); }
  Tensor cauchy(std::size_t k) const;  ///< [Pa]
};

/// From rest to the last of the ascending times; where the model lives. Throws MaterialFailure.
HistoryTrail follow(const Course& course, double xi, const HistoryOptions& options, std::span<const double> times);

/// The same in this process.
HistoryTrail follow_here(const Course& course, double xi, const HistoryOptions& options, std::span<const double> times);

}  // namespace assay
