// SPDX-License-Identifier: BSD-3-Clause
// Changes of a material's regime on the way of a controlled history: yield, unloading, damage.
#include <algorithm>
#include <cmath>

#include "harness/control/controlled_march.hpp"
#include "harness/material/state_variable.hpp"

namespace assay {

namespace {

constexpr double after_crossing = 1e-3;  ///< of a piece: the step to try behind one
constexpr double no_work = 1e-6;         ///< of stress and strain: work whose sign says nothing
constexpr int most_crossings = 200;      ///< in a piece: beyond, the regime is not asked

}  // namespace

/// In a step from rest or from a knot that is short: any regime may begin there.
void ControlledMarch::begin_regime(const Piece& piece) {
  regime_ = {};
  if (coarse_ || piece.jump || by_increments(piece) || telling_ == Tells::nothing) return;
  const SolvedStep probe = steps_.solve(now_, piece.width * telling_share, values(piece, telling_share), now_.q);
  if (probe.outcome != SolvedStep::Outcome::solved) return;
  const auto value = regime_between(now_, probe.end);
  regime_.known = value.has_value();
  regime_.value = value.value_or(0);
}

/// Of an increment: by the state; of a model that flows as a power of the stress by the sign of the work, for where the
/// stress passes zero the flow is nearly not smooth. Nothing where the work is rounding.
std::optional<std::uint64_t> ControlledMarch::regime_between(const ControlledPoint& before,
                                                             const ControlledPoint& end) const {
  if (telling_ == Tells::state) return regimes_.of(before.state.data(), end.state.data());
  const double work = end.work - before.work;
  const double size = (before.s.norm() + end.s.norm()) * (end.F - before.F).norm();
  if (!(std::abs(work) > no_work * size)) return std::nullopt;
  return work > 0 ? 1 : 0;
}

bool ControlledMarch::keeps_regime(const ControlledPoint& before, const ControlledPoint& end) {
  if (!regime_.known) return true;
  return regime_between(before, end).value_or(regime_.value) == regime_.value;
}

/// The regime of a step behind that point, over so short a share of the piece. Nothing where the piece ends before. A
/// step before it takes up what the state of the point errs by, which would look like loading.
std::optional<std::uint64_t> ControlledMarch::regime_ahead(const Piece& piece, const ControlledPoint& from, double at,
                                                           double share) {
  if (!(at + 2 * share <= 1)) return std::nullopt;
  const auto next = [&](const ControlledPoint& point, int count) -> std::optional<ControlledPoint> {
    SolvedStep probe =
        steps_.solve(point, piece.width * share, values(piece, at + count * share), point.q + share * rate_);
    const bool solved = probe.outcome == SolvedStep::Outcome::solved || probe.outcome == SolvedStep::Outcome::shorter;
    return solved ? std::optional(std::move(probe.end)) : std::nullopt;
  };
  const auto first = next(from, 1), second = first ? next(*first, 2) : std::nullopt;
  return second ? regime_between(*first, *second) : std::nullopt;
}

/// Whether the regime has changed before the end of a step in which each sub-step shows the same one: the last of them
/// may begin with a yielding that ends within it, and however many they are, they all err by the same. What lies behind
/// the end tells.
bool ControlledMarch::turns_within(const Piece& piece, const ControlledPoint& end, double at) {
  if (!regime_.known || telling_ != Tells::state) return false;
  for (const double share : {crossing_share, telling_share}) {
    const auto ahead = regime_ahead(piece, end, at, share);
    if (!ahead || *ahead == regime_.value) return false;
  }
  return true;
}

/// Over a change of regime, by one sub-step: the error is of second order in a step that is this short.
void ControlledMarch::cross(const Piece& piece, double step) {
  Attempt made;
  const Regime before = regime_;
  regime_.known = false;
  auto end = substeps(piece, now_, at_, step, 1, made);
  regime_.known = before.known;
  if (!end) {
    made.outcome = Attempt::Outcome::failed;
    return step < shortest_share ? end_stuck(piece, step) : shorten(piece, step, made);
  }
  std::optional<std::uint64_t> value;
  if (telling_ == Tells::state) value = regime_ahead(piece, *end, at_ + step, telling_share);
  if (!value) value = regime_between(now_, *end);
  regime_.value = value.value_or(telling_ == Tells::work ? 1 - before.value : before.value);
  regime_.bound = 0;
  if (++regime_.crossings > most_crossings) regime_.known = false;
  first_ = *end;
  made.end = std::move(*end), made.error = 0;
  accept(piece, step, std::move(made));
  step_ = after_crossing;
  if (options_.rows_at_kinks && telling_ == Tells::state && !ended_) write_row(now_);
}

/// What tells the regime: what changes in some step, and not in every short one from a knot.
void ControlledMarch::note_signs(const Piece& piece) {
  if (piece.jump) return;  // too fast for what flows to show
  const auto note = [&](const ControlledPoint& from, const ControlledPoint& to, bool start) {
    std::size_t v = 0;
    for (const StatePlace& place : state_of(material_.table())) {
      const bool here = variable_changes(place.kind, &from.state[place.first], &to.state[place.first]);
      if (here) signs_.changes[v] = 1;
      if (start && here) signs_.ever[v] = 1;
      if (start && !here) signs_.always[v] = 0;
      ++v;
    }
  };
  if (at_ == 0) {
    const SolvedStep probe = steps_.solve(now_, piece.width * telling_share, values(piece, telling_share), now_.q);
    if (probe.outcome != SolvedStep::Outcome::solved) return;
    note(now_, probe.end, true);
    signs_.any_start = true;
  } else {
    note(before_, now_, false);
  }
}

}  // namespace assay
