// SPDX-License-Identifier: BSD-3-Clause
// What histories are made of, for archives of numbers (number_archive.hpp).
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "harness/history/history.hpp"
#include "harness/numeric/number_archive.hpp"

namespace assay {

enum class HistoryTaskKind { coarse, follow, gather, advance, disband };

/// A path without its functions.
struct PathFacts {
  std::vector<double> recipe = {};
  Interval parameter = {};
  std::array<double, 3> direction = {};
  std::array<double, 9> initial_cauchy = {};
};

/// An exception on its way: a MaterialFailure, or another.
struct FailureFacts {
  enum class Kind { none, material, other } kind = Kind::none;
  std::string what = {};
  FailurePlace place = {};
};

void fields(auto& archive, Interval& interval) { archive(interval.lower, interval.upper); }
void fields(auto& archive, PathFacts& facts) {
  archive(facts.recipe, facts.parameter, facts.direction[0], facts.direction[1], facts.direction[2]);
  for (double& component : facts.initial_cauchy) archive(component);
}
void fields(auto& archive, HistoryScales& scales) { archive(scales.cauchy, scales.state); }
void fields(auto& archive, ShortestTelling& shortest) { archive(shortest.norm, shortest.stress); }
void fields(auto& archive, CourseFacts& facts) {
  archive(facts.end, facts.by_rate, facts.telling, facts.regimes, facts.scales, facts.shortest);
}
void fields(auto& archive, HistoryOptions& options) { archive(options.tolerance, options.watch); }
void fields(auto& archive, StateSigns& signs) { archive(signs.changes, signs.always, signs.ever, signs.any_start); }
void fields(auto& archive, CoarseMarch& seen) { archive(seen.largest, seen.signs, seen.shortest); }
void fields(auto& archive, Branch& branch) { archive(branch.begin, branch.regime); }
void fields(auto& archive, HistoryTrail& trail) {
  archive(trail.width, trail.rows, trail.branches, trail.flickers, trail.error, trail.calls);
}
void fields(auto& archive, FailedStep& step) { archive(step.t, step.dt, step.F0, step.F1, step.state0, step.fields1); }
void fields(auto& archive, FailurePlace& place) {
  archive(place.xi, place.t, place.step, place.not_finite, place.final, place.too_accurate);
}
void fields(auto& archive, FailureFacts& facts) { archive(facts.kind, facts.what, facts.place); }

template <class... Parts>
std::vector<double> numbers_of(Parts... parts) {
  NumberWriter writer;
  writer(parts...);
  return std::move(writer.numbers);
}

}  // namespace assay
