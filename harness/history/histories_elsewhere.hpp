// SPDX-License-Identifier: BSD-3-Clause
// Histories of a material whose model lives in another process, taken there: one hand-over a history, or a time
// of many, not one a step.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "harness/history/history_trail.hpp"

namespace assay {

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
