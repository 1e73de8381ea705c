// SPDX-License-Identifier: BSD-3-Clause
// A history as a whole.
#pragma once

#include <cstdint>
#include <functional>
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

/// Extension of this program's own tables of such a material.
inline constexpr const char* histories_elsewhere_id = "assay.internal.histories_elsewhere";

/// Longer recipes of paths stay here.
inline constexpr std::size_t longest_recipe = std::size_t{1} << 21;

struct HistoriesElsewhere {
  std::uint32_t struct_size;
  /// As march_coarsely and follow_here of this process; what they throw.
  CoarseMarch (*coarse)(void* self, const Path& path, double end);
  HistoryTrail (*follow)(void* self, const Course& course, double xi, const HistoryOptions& options,
                         std::span<const double> times);
  /// Begins histories in the process of that number; what comes back takes all of them to a time, and has one row each.
  std::function<std::vector<HistoryTrail>(double to)> (*gather)(void* self, const Course& course,
                                                                std::span<const double> xi,
                                                                const HistoryOptions& options, int worker);
};

}  // namespace assay
