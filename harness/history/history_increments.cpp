// SPDX-License-Identifier: BSD-3-Clause
// A history by `update` with error control: sub-steps, extrapolation, the length of the next step.
#include <algorithm>
#include <limits>

#include "harness/history/history_forms.hpp"
#include "harness/material/checked_update.hpp"

namespace assay {

namespace {

constexpr double first_share = 1.0 / 16;    ///< of a piece: the first step to try
constexpr double least_first_share = 1e-3;  ///< of a piece: what was short at the end of one need not be in the next
constexpr double shortest_share = 1e-13;    ///< of the end: a step that needs to be shorter has failed
/// The time of a change of regime is found to this share of the tolerance, and to no better than the second, of the
/// end.
constexpr double resolution_share = 0.01, best_resolution = 4e-15;
constexpr double shortest_lag = 1e-6;    ///< of a piece's part: increments this short are noise
constexpr double past_the_least = 10;    ///< an error this many times the least: the least has been found
constexpr double noisy_growth = 20;      ///< of a step that was taken although it is noisy: at least two shortenings
constexpr double lag_share = 1e-4;       ///< of a piece: an increment that tells whether a regime goes on
constexpr double growing_noise = 1e-6;   ///< relative: a rate taken over ever shorter steps
constexpr double largest_noise = 1e-10;  ///< relative: what may be a material's own rounding
/// Of a piece at whose end the path rests: a change of regime this near to it is none. Reloading meets the yield
/// surface there exactly, and rounding would decide.
constexpr double tie_share = 3e-6;
/// Of a piece at whose end a change of the sign of the power is none: the flow behind it is too slow to matter.
constexpr double slow_share = 1e-2;
constexpr double resting_share = 1e-4;  ///< of the rate of F in the middle of the piece
constexpr int most_jumps = 100;         ///< of a history: beyond, the material is no function of its arguments
constexpr double rounding_margin = 4;   ///< results carry the rounding of many operations

/// How much longer the next step may be when this many columns sufficed.
double growth(int columns) { return columns <= 3 ? 3 : columns == 4 ? 2 : columns == 5 ? 1.3 : 0.8; }

}  // namespace

History::Increments::Increments(History& history, const HistoryOptions& options) : h_(&history), options_(options) {
  scales_.assign(9, history.course_->scales.cauchy);
  scales_.insert(scales_.end(), history.course_->scales.state.begin(), history.course_->scales.state.end());
  options_.watch = options.watch && history.course_->tells();
  resolution_ = std::max(resolution_share * options.tolerance, best_resolution) * history.course_->end;
}

/// A material without state has no memory: the stress at `to` is found from increments that end there, as long as makes
/// the least error.
void History::Increments::evaluate(double to) {
  const Interval piece = h_->course_->piece_at(h_->t_);
  const double longest = to - piece.lower;
  double step = std::min(longest, first_share * piece.width());
  Attempt best;
  for (; step >= shortest_lag * longest; step *= 0.5) {
    h_->t_ = to - step;
    const Attempt made = attempt(step);
    const double error = made.error;
    if (error < best.error) best = made;
    if (made.outcome == Outcome::accepted || error > past_the_least * best.error) break;
  }
  if (best.y.empty()) {
    h_->t_ = to - step;
    best.y = substeps(step, 1).y;  // throws where it still fails
  }
  h_->y_ = best.y;
  h_->t_ = to;
  h_->error_ = std::max(h_->error_, best.error);
}

/// Within one piece of the path.
void History::Increments::advance(double to) {
  if (h_->course_->material->state_size() == 0) return evaluate(to);
  const Interval piece = h_->course_->piece_at(h_->t_);
  if (piece.lower != piece_.begin) begin_piece(piece);
  if (reach_near_time(to)) return;
  while (h_->t_ < to) {
    if (h_->t_ < over_) {
      step_over(std::min(over_, to));
      continue;
    }
    const double left = to - h_->t_;
    const double step = step_ >= 0.999 * left ? left : std::min(step_, 0.5 * left);
    const Attempt made = attempt(step);
    if (made.outcome == Outcome::accepted) {
      accept(step, made);
      if (h_->t_ >= to) h_->t_ = to;
    } else if (made.outcome == Outcome::inaccurate) {
      shorten(step, made);
    } else if (h_->t_ >= last_change()) {
      step_over(to);
    } else {
      bound_by(step);
    }
    if (bound_.t > h_->t_) approach_bound(to);
  }
}

void History::Increments::begin_piece(const Interval& piece) {
  const Course& course = *h_->course_;
  piece_ = {piece.lower, piece.upper};
  piece_.lag = course.tells_at_once() ? 0 : lag_share * piece.width();
  regime_.known = false;  // after a reversal any regime may begin
  regime_.is_new = true;
  bound_.t = over_ = 0;
  told_ = near_ = {};
  const auto speed = [&](double t) { return course.path->at(h_->xi_, t).F_rate.norm(); };
  const double before_end = piece.upper - tie_share * piece.width();
  const bool rests = speed(before_end) < resting_share * speed(0.5 * (piece.lower + piece.upper));
  piece_.tie_begin = rests ? before_end : piece.upper;
  if (course.telling == Telling::power) piece_.tie_begin = piece.upper - slow_share * piece.width();
  step_ = step_ == 0 ? first_share * piece.width() : std::max(step_, least_first_share * piece.width());
}

void History::Increments::accept(double step, const Attempt& made) {
  failed_errors_ = {};
  note_branch();
  if (h_->course_->shortest.norm > 0 && far(h_->t_, step)) told_ = {h_->t_, h_->y_, regime_.last_told}, near_ = {};
  h_->y_ = made.y;
  h_->t_ += step;
  h_->error_ += made.error;
  const double grown = made.noisy ? noisy_growth * step : growth(extrapolation_.columns()) * step;
  step_ = step < step_ ? std::max(step_, grown) : grown;  // a step cut short by `to` says little
}

/// After a step that was not exact enough.
void History::Increments::shorten(double step, const Attempt& made) {
  step_ = 0.4 * step;
  if (step < shortest_share * h_->course_->end) {
    if (++jumps_ > most_jumps) {
      throw MaterialFailure("its increments do not converge, " + farthest() + " least of all", h_->xi_, h_->t_);
    }
    h_->y_ = substeps(step, 1).y;  // a jump: nothing better can be done
    h_->t_ += step;
    step_ = first_share * (piece_.end - piece_.begin);
  }
  failed_errors_ = {failed_errors_[1], extrapolation_.columns() >= least_columns ? made.error : 0};
}

/// What has changed the most from one column of the last attempt to the next.
std::string History::Increments::farthest() const {
  if (extrapolation_.columns() < 2) return "the stress";
  std::size_t worst = 0;
  const auto change = [&](std::size_t k) { return extrapolation_.last_change(k) / scales_[k]; };
  for (std::size_t k = 1; k < scales_.size(); ++k) {
    if (change(k) > change(worst)) worst = k;
  }
  if (worst < 9) return "the stress";
  return "'" + variable_at(h_->course_->material->table(), worst - 9) + "' of the state";
}

History::Increments::Attempt History::Increments::attempt(double step) {
  extrapolation_.clear();
  Attempt made;
  if (regime_.is_new) regime_.known = false;  // nothing was accepted yet that could tell
  for (int count = 1; count <= Extrapolation::most_columns; ++count) {
    Steps end;
    try {
      if (count == 1 && options_.watch && h_->t_ == piece_.begin) begin_regime(step);
      end = substeps(step, count);
    } catch (const MaterialFailure& failure) {  // perhaps the step was too long for it
      if (failure.final || step < shortest_share * h_->course_->end) throw;
      h_->note_refusal(failure);
      return made;
    }
    if (!end.in_one_regime) {
      made.outcome = Outcome::regime_changes;
      return made;
    }
    extrapolation_.add(end.y, scales_);
    if (count == least_columns || (count > least_columns && extrapolation_.error() < made.error)) {
      made.error = extrapolation_.error();
      made.y = extrapolation_.best();
    }
    const double rounding = rounding_margin * extrapolation_.rounding();
    if (count >= least_columns && extrapolation_.error() <= options_.tolerance + rounding) {
      made.outcome = stays(made.y, h_->t_ + step) ? Outcome::accepted : Outcome::regime_changes;
      return made;
    }
  }
  const double no_better = made.error < largest_noise ? 0.5 : 1.0;
  const double failed = failed_errors_[0] > 0 ? std::max(failed_errors_[0], failed_errors_[1]) : 0;
  made.noisy = failed > 0 && made.error < growing_noise && made.error > no_better * failed;
  if (made.noisy) made.outcome = Outcome::accepted;  // shorter steps have not helped
  return !made.noisy && let_go_of_counters(step) ? attempt(step) : made;
}

/// State variables that nothing else depends on, as a counter of calls or a flag for a report, need not converge: of
/// those that have not, such are left out of the error.
bool History::Increments::let_go_of_counters(double step) {
  constexpr int most_searches = 8;  // of a history: what is mere rounding does not show at once
  if (searches_ == most_searches || extrapolation_.columns() < 2) return false;
  ++searches_;
  constexpr double moved = 0.37;  // of a component's scale
  bool any = false;
  try {
    const Variables expected = increment(h_->y_, h_->t_, step);
    for (std::size_t k = 9; k < scales_.size(); ++k) {
      if (extrapolation_.last_change(k) <= options_.tolerance * scales_[k]) continue;
      Variables begin = h_->y_;
      begin[k] += moved * scales_[k];
      Variables end = increment(begin, h_->t_, step);
      end[k] = expected[k];
      if (end != expected) continue;
      scales_[k] = std::numeric_limits<double>::infinity();
      any = true;
    }
  } catch (const MaterialFailure& failure) {
    if (failure.final) throw;
  }
  return any;
}

History::Increments::Steps History::Increments::substeps(double step, int count) {
  const Course& course = *h_->course_;
  Variables now = h_->y_, next(now.size());
  Tensor F0 = F(h_->t_);
  for (int j = 0; j < count; ++j) {
    const Tensor F1 = F(h_->t_ + step * (j + 1) / count);
    if (j > 0) now.swap(next);
    increment(now, next, h_->t_ + step * j / count, step / count, F0, F1);
    const bool asks = options_.watch || course.shortest.norm > 0;
    if (asks && (course.shortest.norm == 0 || tells(F1 - F0))) {
      regime_.last_told = regime_of_increment(now, next, F0, F1);
      if (options_.watch && !regime_.known) {
        regime_.known = true;
        regime_.value = regime_.last_told;
      } else if (options_.watch && regime_.last_told != regime_.value) {
        regime_.changed_to = regime_.last_told;
        return {std::move(next), false};
      }
    }
    F0 = F1;
  }
  return {std::move(next), true};
}

/// The end of one increment from y.
History::Increments::Variables History::Increments::increment(const Variables& y, double t, double dt) const {
  Variables end(y.size());
  increment(y, end, t, dt, F(t), F(t + dt));
  return end;
}

void History::Increments::increment(const Variables& y, Variables& end, double t, double dt, const Tensor& F0,
                                    const Tensor& F1) const {
  h_->count_call();
  checked_update(*h_->course_->material, h_->xi_, t, dt, 1, nine_of(F0).data(), nine_of(F1).data(), y.data() + 9,
                 end.data() + 9, end.data());
}

}  // namespace assay
