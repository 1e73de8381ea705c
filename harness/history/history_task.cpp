// SPDX-License-Identifier: BSD-3-Clause
// The side that asks.
#include "harness/history/history_task.hpp"

#include <stdexcept>

#include "harness/history/history_fields.hpp"

namespace assay {

namespace {

using Kind = HistoryTaskKind;

PathFacts facts_of_path(const Path& path) {
  return {path.recipe, path.parameter, path.material_direction, nine_of(path.initial_cauchy)};
}

CourseFacts facts_of_course(const Course& course) { return course; }

/// What comes after the word of how it went.
NumberReader read_answer(std::span<const double> answer) {
  NumberReader reader(answer);
  FailureFacts facts;
  reader(facts);
  if (facts.kind == FailureFacts::Kind::none) return reader;
  if (facts.kind != FailureFacts::Kind::material) throw std::runtime_error(facts.what);
  throw MaterialFailure(facts.what, facts.place);
}

void require(bool holds) {
  if (!holds) throw std::runtime_error("no answer about a history");
}

}  // namespace

std::vector<double> coarse_task(const Path& path, double end) {
  return numbers_of(Kind::coarse, facts_of_path(path), end);
}

std::vector<double> follow_task(const Course& course, double xi, const HistoryOptions& options,
                                std::span<const double> times) {
  return numbers_of(Kind::follow, facts_of_path(*course.path), facts_of_course(course), options, xi,
                    std::vector<double>(times.begin(), times.end()));
}

std::vector<double> gather_task(std::uint64_t troop, const Course& course, std::span<const double> xi,
                                const HistoryOptions& options) {
  return numbers_of(Kind::gather, facts_of_path(*course.path), facts_of_course(course), options, troop,
                    std::vector<double>(xi.begin(), xi.end()));
}

std::vector<double> advance_task(std::uint64_t troop, double to) { return numbers_of(Kind::advance, troop, to); }

std::vector<double> disband_task(std::uint64_t troop) { return numbers_of(Kind::disband, troop); }

CoarseMarch coarse_march_in(std::span<const double> answer, std::size_t state_size, std::size_t variables) {
  CoarseMarch seen;
  read_answer(answer)(seen);
  require(seen.largest.size() == 9 + state_size && seen.signs.changes.size() == variables &&
          seen.signs.always.size() == variables);
  return seen;
}

HistoryTrail trail_in(std::span<const double> answer, std::size_t rows, std::size_t width) {
  HistoryTrail trail;
  read_answer(answer)(trail);
  require(trail.width == width && trail.rows.size() == rows * width);
  return trail;
}

void nothing_in(std::span<const double> answer) { read_answer(answer); }

std::vector<HistoryTrail> trails_in(std::span<const double> answer, std::size_t histories, std::size_t width) {
  std::vector<HistoryTrail> trails;
  read_answer(answer)(trails);
  require(trails.size() == histories);
  for (const HistoryTrail& trail : trails) require(trail.width == width && trail.rows.size() == width);
  return trails;
}

}  // namespace assay
