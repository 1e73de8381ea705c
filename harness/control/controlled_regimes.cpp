// SPDX-License-Identifier: BSD-3-Clause
// Changes of a material's regime on the way of a controlled history: yield, unloading, damage.
#include <algorithm>
#include <cmath>

#include "harness/control/controlled_march.hpp"
#include "harness/material/state_variable.hpp"

namespace assay {

namespace {

constexpr double telling_share = 1e-6;   ///< of a piece: a short step
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
  regime_.value = regime_between(now_, *end).value_or(telling_ == Tells::work ? 1 - before.value : before.value);
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
