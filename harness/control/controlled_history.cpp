// SPDX-License-Identifier: BSD-3-Clause
// The march: pieces between knots, and the length of steps.
#include "harness/control/controlled_history.hpp"

#include <algorithm>
#include <cmath>

#include "harness/control/controlled_march.hpp"

namespace assay {

namespace {

constexpr double first_share = 1.0 / 16;    ///< of a piece: the first step to try
constexpr double least_first_share = 1e-3;  ///< of a piece
constexpr double limit_share = 1e-9;        ///< of a piece: a step this short beside a singular matrix is the last
constexpr double jump_share = 1e-12;        ///< of the end: how long a jump takes
constexpr std::size_t most_coarse_steps = 20'000;  ///< over all pieces
constexpr int coarse_steps = 64;                   ///< of a piece, by which the scales are found
constexpr double coarse_shortest = 1e-4;           ///< of a piece
constexpr double noisy_growth = 20;                ///< of a step that was taken although it is noisy
constexpr int most_jumps = 100;                    ///< beyond, the material is no function of its arguments

double growth(int columns) { return columns <= 3 ? 3 : columns == 4 ? 2 : columns == 5 ? 1.3 : 0.8; }

}  // namespace

ControlledMarch::ControlledMarch(const Material& material, const Control& control, const ControlOptions& options)
    : material_(material),
      control_(control),
      options_(options),
      steps_(material, control),
      regimes_(material.table()),
      signs_(material.table().state_count) {
  now_ = before_ = steps_.at_rest();
  scales_.assign(packed(now_).size(), 0.0);
  peaks_.assign(control.stops.size(), -std::numeric_limits<double>::infinity());
}

void ControlledMarch::accept(const Piece& piece, double step, Attempt made) {
  failed_errors_ = {};
  wishes_ = 0;
  before_ = std::exchange(now_, std::move(made.end));
  rate_ = (now_.q - before_.q) / step;
  history_.error += coarse_ ? 0 : made.error;
  residual_ = made.residual;
  ++history_.steps;
  const double grown = made.noisy ? noisy_growth * step : growth(extrapolation_.columns()) * step;
  step_ = step < step_ ? std::max(step_, grown) : grown;
  if (by_increments(piece)) step_ = 1.0 / options_.increments;
  widen_scales(now_);
  if (!coarse_) {
    look_at_matrix(piece, before_, step);
    if (!ended_ && meets_stop(piece, before_, at_, step)) return;
    if (!ended_) look_at_ellipticity(piece, before_, step);
  }
  earlier_ = {before_, at_, step};
  at_ += step;
  if (coarse_) note_signs(piece);
  if (options_.progress && !coarse_) options_.progress((now_.t - control_.begin()) / control_.length());
}

/// After a step that was not exact enough, or not solved.
void ControlledMarch::shorten(const Piece& piece, double step, const Attempt& made) {
  step_ = made.shorter * step;
  if (refused_ && refused_->final) return end_stuck(piece, step);  // its process has ended: no shorter step would do
  const double shortest = coarse_ ? coarse_shortest : shortest_share;
  if (!coarse_ && !refused_ && step < limit_share && steps_.count() > 0 && at_limit(piece, step))
    return end_stuck(piece, step);
  if (step >= shortest) {
    std::shift_right(failed_errors_.begin(), failed_errors_.end(), 1);
    failed_errors_[0] = made.outcome == Attempt::Outcome::failed ? 0 : made.error;
    return;
  }
  if (made.outcome == Attempt::Outcome::failed) return end_stuck(piece, step);
  if (++jumps_ > most_jumps) {
    history_.outcome = ControlOutcome::material_failed;
    history_.reason = "its increments do not converge with shorter steps";
    ended_ = true;
    return;
  }
  Attempt jump = made;  // a jump of the material's own: nothing better can be done
  jump.end = first_;
  jump.error = 0;
  accept(piece, step, jump);
  step_ = first_share;
}

void ControlledMarch::advance(const Piece& piece, double to) {
  while (at_ < to && !ended_) {
    if (options_.ends && options_.ends()) {
      history_.outcome = ControlOutcome::interrupted;
      history_.reason = "interrupted";
      ended_ = true;
      return;
    }
    if (steps_.calls() - calls_before_ > options_.most_calls && !coarse_) {
      history_.outcome = ControlOutcome::out_of_calls;
      history_.reason = "it takes more than " + std::to_string(options_.most_calls) + " calls of the model";
      ended_ = true;
      return;
    }
    const double left = to - at_;
    double step = step_ >= 0.999 * left ? left : std::min(step_, 0.5 * left);
    // Behind the end of a piece nothing tells of it: the last step is too short for a change to matter.
    if (to == 1 && step == left && regime_.known && telling_ == Tells::state && left > 4 * telling_share)
      step = left - 2 * telling_share;
    if (by_increments(piece)) step = left / std::max(1.0, std::ceil(left / step_ - 1e-6));
    if (regime_.bound > at_) {
      const double room = regime_.bound - at_;
      if (room <= crossing_share) {
        cross(piece, std::min(room, left));
        continue;
      }
      step = std::min(step, 0.5 * room);
    }
    Attempt made = attempt(piece, now_, at_, step);
    if (made.outcome == Attempt::Outcome::accepted) {
      accept(piece, step, std::move(made));
      if (step == left && !ended_) at_ = to;
    } else if (made.outcome == Attempt::Outcome::regime_changes) {
      regime_.bound = at_ + step;
      if (step <= crossing_share) cross(piece, step);
    } else {
      shorten(piece, step, made);
    }
  }
}

/// Where rows jump at t: their values there and behind. At rest they begin as they are.
bool ControlledMarch::jumps_at(double t, std::vector<double>& before, std::vector<double>& behind) const {
  if (options_.increments > 0 && t >= options_.increments_from) return false;  // a part of the first increment
  constexpr double same = 1e-14;
  bool any = false;
  for (const ControlRow& row : control_.rows) {
    before.push_back(t == control_.begin() ? value_of(row, now_) : row.value(t, false));
    behind.push_back(row.value(t, true));
    const double scale = std::max({1.0, std::abs(before.back()), row.stress.cwiseAbs().maxCoeff() * steps_.modulus()});
    any = any || std::abs(behind.back() - before.back()) > same * scale;
  }
  return any;
}

void ControlledMarch::take_piece(const Piece& piece, std::span<const double> times) {
  at_ = 0;
  failed_errors_ = {};
  determinant_ = 0;
  rate_.setZero();
  earlier_ = {};
  begin_regime(piece);
  if (coarse_) note_signs(piece);
  step_ = coarse_ ? 1.0 / coarse_steps_ : step_ == 0 ? first_share : std::max(step_, least_first_share);
  if (by_increments(piece)) step_ = 1.0 / options_.increments;
  for (const double t : times) {
    advance(piece, (t - piece.begin) / piece.width);
    if (ended_) return;
    now_.t = t;
    write_row(now_);
  }
  advance(piece, 1);
  if (!ended_) now_.t = piece.jump ? piece.begin : piece.begin + piece.width;
}

/// By single sub-steps, as far as they go.
void ControlledMarch::find_scales() {
  coarse_ = true;
  const std::size_t knots = control_.knots.size();
  coarse_steps_ = std::clamp(static_cast<int>(most_coarse_steps / knots), 1, coarse_steps);
  widen_scales(now_);
  for (std::size_t k = 0; k < knots && !ended_; ++k) {
    Piece jump{control_.knots[k], jump_share * control_.length(), true};
    if (jumps_at(jump.begin, jump.before, jump.behind)) take_piece(jump, {});
    if (k + 1 < knots && !ended_) take_piece({control_.knots[k], control_.knots[k + 1] - control_.knots[k]}, {});
  }
  coarse_ = ended_ = false;
  regimes_.settle(material_.table(), signs_);
  const bool kinks = material_.has(ASSAY_NON_SMOOTH) || regimes_.named() || any_scalar_tells(material_.table(), signs_);
  telling_ = regimes_.tells() && kinks              ? Tells::state
             : !kinks && material_.state_size() > 0 ? Tells::work
                                                    : Tells::nothing;
  now_ = before_ = steps_.at_rest();
  history_ = {};
  step_ = 0, jumps_ = 0;
  rate_.setZero();
}

ControlledHistory ControlledMarch::run(std::span<const double> times) {
  look_at_rest();
  if (!ended_) find_scales();
  calls_before_ = steps_.calls();
  if (!times.empty() && times[0] == control_.begin() && history_.rows.empty()) write_row(now_);
  std::size_t next = !times.empty() && times[0] == control_.begin() ? 1 : 0;
  const std::size_t knots = control_.knots.size();
  for (std::size_t k = 0; k < knots && !ended_; ++k) {
    Piece jump{control_.knots[k], jump_share * control_.length(), true};
    if (jumps_at(jump.begin, jump.before, jump.behind)) {
      const double kept = step_;
      step_ = 0;
      take_piece(jump, {});
      step_ = kept;
      if (ended_) break;
      write_row(now_);
    }
    if (k + 1 == knots) break;
    const Piece piece{control_.knots[k], control_.knots[k + 1] - control_.knots[k]};
    const auto first = next;
    while (next < times.size() && times[next] <= control_.knots[k + 1]) ++next;
    take_piece(piece, times.subspan(first, next - first));
  }
  if (history_.outcome != ControlOutcome::completed && history_.outcome != ControlOutcome::stopped &&
      history_.outcome != ControlOutcome::undetermined) {
    write_row(now_);
  }
  history_.calls = steps_.calls();
  return std::move(history_);
}

ControlledHistory follow_control(const Material& material, const Control& control, std::span<const double> times,
                                 const ControlOptions& options) {
  return ControlledMarch(material, control, options).run(times);
}

}  // namespace assay
