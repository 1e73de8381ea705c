// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
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

Tensor change_of_F(const std::array<double, 9>& F0, const std::array<double, 9>& F1) {
  Tensor change;
  for (int c = 0; c < 9; ++c) component(change, c) = F1[static_cast<std::size_t>(c)] - F0[static_cast<std::size_t>(c)];
  return change;
}

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
  double least = std::numeric_limits<double>::infinity(), step = std::min(longest, first_share * piece.width());
  std::vector<double> y;
  for (; step >= shortest_lag * longest; step *= 0.5) {
    h_->t_ = to - step;
    const Outcome outcome = attempt(step);
    if (best_error_ < least) {
      least = best_error_;
      y = best_;
    }
    if (outcome == Outcome::accepted || best_error_ > past_the_least * least) break;
  }
  if (y.empty()) {
    h_->t_ = to - step;
    substeps(step, 1);  // throws where it still fails
    y = next_;
  }
  h_->y_ = y;
  h_->t_ = to;
  h_->error_ = std::max(h_->error_, least);
}

/// Within one piece of the path.
void History::Increments::advance(double to) {
  if (h_->course_->material->state_size() == 0) return evaluate(to);
  const Interval piece = h_->course_->piece_at(h_->t_);
  if (piece.lower != piece_begin_) begin_piece(piece);
  if (reach_near_time(to)) return;
  while (h_->t_ < to) {
    if (h_->t_ < over_) {
      step_over(std::min(over_, to));
      continue;
    }
    const double left = to - h_->t_;
    const double step = step_ >= 0.999 * left ? left : std::min(step_, 0.5 * left);
    switch (attempt(step)) {
      case Outcome::accepted: {
        failed_errors_ = {};
        accept(step);
        const double grown = noisy_ ? noisy_growth * step : growth(extrapolation_.columns()) * step;
        step_ = step < step_ ? std::max(step_, grown) : grown;  // a step cut short by `to` says little
        if (h_->t_ >= to) h_->t_ = to;
        break;
      }
      case Outcome::inaccurate:
        shorten(step, piece);
        break;
      case Outcome::regime_changes:
        if (h_->t_ >= last_change()) {
          step_over(to);
        } else {
          bound_by(step);
        }
        break;
    }
    if (bound_ > h_->t_) approach_bound(to);
  }
}

void History::Increments::begin_piece(const Interval& piece) {
  piece_begin_ = piece.lower;
  piece_end_ = piece.upper;
  lag_ = h_->course_->tells_at_once() ? 0 : lag_share * piece.width();
  regime_known_ = false;  // after a reversal any regime may begin
  regime_new_ = true;
  bound_ = over_ = 0;
  told_ = near_ = {};
  const auto speed = [&](double t) { return h_->course_->path->at(h_->xi_, t).F_rate.norm(); };
  const double before_end = piece.upper - tie_share * piece.width();
  const bool rests = speed(before_end) < resting_share * speed(0.5 * (piece.lower + piece.upper));
  tie_begin_ = rests ? before_end : piece.upper;
  if (h_->course_->telling == Telling::power) tie_begin_ = piece.upper - slow_share * piece.width();
  step_ = step_ == 0 ? first_share * piece.width() : std::max(step_, least_first_share * piece.width());
}

/// After a step that was not exact enough.
void History::Increments::shorten(double step, const Interval& piece) {
  step_ = 0.4 * step;
  if (step < shortest_share * h_->course_->end) {
    if (++jumps_ > most_jumps) {
      throw MaterialFailure("its increments do not converge, " + farthest() + " least of all", h_->xi_, h_->t_);
    }
    substeps(step, 1);  // a jump: nothing better can be done
    h_->y_ = next_;
    h_->t_ += step;
    step_ = first_share * piece.width();
  }
  failed_errors_ = {failed_errors_[1], extrapolation_.columns() >= least_columns ? best_error_ : 0};
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

/// Leaves the end of the step in best_.
History::Increments::Outcome History::Increments::attempt(double step) {
  extrapolation_.clear();
  best_error_ = std::numeric_limits<double>::infinity();
  noisy_ = false;
  if (regime_new_) regime_known_ = false;  // nothing was accepted yet that could tell
  for (int count = 1; count <= Extrapolation::most_columns; ++count) {
    bool same_regime = false;
    try {
      if (count == 1 && options_.watch && h_->t_ == piece_begin_) begin_regime(step);
      same_regime = substeps(step, count);
    } catch (const MaterialFailure& failure) {  // perhaps the step was too long for it
      if (failure.final || step < shortest_share * h_->course_->end) throw;
      h_->note_refusal(failure);
      return Outcome::inaccurate;
    }
    if (!same_regime) return Outcome::regime_changes;
    extrapolation_.add(next_, scales_);
    if (count == least_columns || (count > least_columns && extrapolation_.error() < best_error_)) {
      best_error_ = extrapolation_.error();
      best_ = extrapolation_.best();
    }
    const double rounding = rounding_margin * extrapolation_.rounding();
    if (count >= least_columns && extrapolation_.error() <= options_.tolerance + rounding) {
      return stays(best_, h_->t_ + step) ? Outcome::accepted : Outcome::regime_changes;
    }
  }
  const double no_better = best_error_ < largest_noise ? 0.5 : 1.0;
  const double failed = failed_errors_[0] > 0 ? std::max(failed_errors_[0], failed_errors_[1]) : 0;
  noisy_ = failed > 0 && best_error_ < growing_noise && best_error_ > no_better * failed;
  if (noisy_) return Outcome::accepted;  // shorter steps have not helped
  return let_go_of_counters(step) ? attempt(step) : Outcome::inaccurate;
}

/// State variables that nothing else depends on, as a counter of calls or a flag for a report, need not converge: of
/// those that have not, such are left out of the error.
bool History::Increments::let_go_of_counters(double step) {
  constexpr int most_searches = 8;  // of a history: what is mere rounding does not show at once
  if (searches_ == most_searches || extrapolation_.columns() < 2) return false;
  ++searches_;
  constexpr double moved = 0.37;  // of a component's scale
  const auto end_of = [&](const std::vector<double>& begin) {
    now_ = begin;
    whole_step(step);
    return next_;
  };
  bool any = false;
  try {
    const std::vector<double> expected = end_of(h_->y_);
    for (std::size_t k = 9; k < scales_.size(); ++k) {
      if (extrapolation_.last_change(k) <= options_.tolerance * scales_[k]) continue;
      std::vector<double> begin = h_->y_;
      begin[k] += moved * scales_[k];
      std::vector<double> end = end_of(begin);
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

/// One increment over `step` from now_ to next_.
void History::Increments::whole_step(double step) {
  std::array<double, 9> F0, F1;
  const Tensor begin = h_->course_->path->deformation_gradient(h_->xi_, h_->t_),
               end = h_->course_->path->deformation_gradient(h_->xi_, h_->t_ + step);
  for (int c = 0; c < 9; ++c) {
    F0[static_cast<std::size_t>(c)] = component(begin, c);
    F1[static_cast<std::size_t>(c)] = component(end, c);
  }
  next_.resize(now_.size());
  increment(h_->t_, step, F0.data(), F1.data());
}

/// From the accepted point over `step` in `count` increments; the result in next_. False where the regime changes.
bool History::Increments::substeps(double step, int count) {
  const Course& course = *h_->course_;
  F_.resize(static_cast<std::size_t>(count) + 1);
  for (int j = 0; j <= count; ++j) {
    const Tensor F = course.path->deformation_gradient(h_->xi_, h_->t_ + step * j / count);
    for (int c = 0; c < 9; ++c) F_[static_cast<std::size_t>(j)][static_cast<std::size_t>(c)] = component(F, c);
  }
  now_ = h_->y_;
  next_.resize(now_.size());
  for (int j = 0; j < count; ++j) {
    if (j > 0) now_.swap(next_);
    const auto k = static_cast<std::size_t>(j);
    increment(h_->t_ + step * j / count, step / count, F_[k].data(), F_[k + 1].data());
    if (!options_.watch && course.shortest.norm == 0) continue;
    if (course.shortest.norm > 0 && !tells(change_of_F(F_[k], F_[k + 1]))) continue;
    const std::uint64_t regime = regime_of_increment(F_[k].data(), F_[k + 1].data());
    last_told_ = regime;
    if (!options_.watch) continue;
    if (!regime_known_) {
      regime_known_ = true;
      regime_ = regime;
    } else if (regime != regime_) {
      changed_to_ = regime;
      return false;
    }
  }
  return true;
}

void History::Increments::increment(double t, double dt, const double* F0, const double* F1) {
  h_->count_call();
  checked_update(*h_->course_->material, h_->xi_, t, dt, 1, F0, F1, now_.data() + 9, next_.data() + 9, next_.data());
}

void History::Increments::accept(double step) {
  note_branch();
  if (h_->course_->shortest.norm > 0 && far(h_->t_, step)) told_ = {h_->t_, h_->y_, last_told_}, near_ = {};
  h_->y_ = best_;
  h_->t_ += step;
  h_->error_ += best_error_;
}

}  // namespace assay
