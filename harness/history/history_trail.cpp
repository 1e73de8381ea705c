// SPDX-License-Identifier: BSD-3-Clause
#include "harness/history/history_trail.hpp"

namespace assay {

Tensor HistoryTrail::cauchy(std::size_t k) const { return tensor_of(&rows[k * width]); }

HistoryTrail follow_here(const Course& course, double xi, const HistoryOptions& options,
                         std::span<const double> times) {
  History history(course, xi, options);
  HistoryTrail trail;
  trail.width = history.variables().size();
  trail.rows.reserve(times.size() * trail.width);
  for (const double t : times) {
    history.advance(t);
    trail.rows.insert(trail.rows.end(), history.variables().begin(), history.variables().end());
  }
  trail.branches = history.branches();
  trail.flickers = history.flickers();
  trail.error = history.error();
  trail.calls = history.calls();
  return trail;
}

HistoryTrail follow(const Course& course, double xi, const HistoryOptions& options, std::span<const double> times) {
  if (!course.elsewhere) return follow_here(course, xi, options, times);
  return course.elsewhere->follow(course.material->self(), course, xi, options, times);
}

}  // namespace assay
