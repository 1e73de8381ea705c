// SPDX-License-Identifier: BSD-3-Clause
// Where the regime of a history in increments changes.
#include <algorithm>
#include <cmath>
#include <utility>

#include "harness/history/history_forms.hpp"

namespace assay {

namespace {

constexpr double begin_share = 1e-2;  ///< of a step: an increment that tells the regime at its beginning
/// Increments this short, times the cube root of the resolution, both shares of the end, err by less than that.
constexpr double single_share = 0.1;
constexpr double telling = 100;            ///< an increment of F this many times the tolerance tells a regime
constexpr double telling_margin = 4;       ///< states differ in the shortest increment that tells
constexpr std::size_t most_branches = 24;  ///< a piece, on average: beyond, the regime flickers

}  // namespace

/// Whether an increment with this change of F is long enough to tell the regime. At rest any is.
bool History::Increments::tells(const Tensor& change) const {
  const double norm = h_->course_->shortest.norm;
  return norm == 0 || (regime_.known && regime_.value == 0) || change.norm() >= telling_margin * norm;
}

/// A step from t, no shorter than `step`, that is long enough to tell; `step` where the piece ends before.
double History::Increments::telling_step(double t, double step) const {
  const Tensor begin = F(t);
  for (double longer = step; t + longer <= piece_.end; longer *= 2) {
    if (tells(F(t + longer) - begin)) return longer;
  }
  return step;
}

/// Of the increment from y to `end`.
std::uint64_t History::Increments::regime_of_increment(const Variables& y, const Variables& end, const Tensor& F0,
                                                       const Tensor& F1) const {
  const Course& course = *h_->course_;
  if (course.telling == Telling::state) return course.regimes.of(y.data() + 9, end.data() + 9);
  Tensor s = tensor_of(end.data());
  s.diagonal().array() -= s.trace() / 3;
  const Tensor step = (F1 - F0) * F1.inverse();
  return s.cwiseProduct(step + step.transpose()).sum() > 0 ? 1 : 0;
}

/// Of one increment from y.
std::uint64_t History::Increments::regime_between(const Variables& y, double t, double dt) const {
  return regime_of_increment(y, increment(y, t, dt), F(t), F(t + dt));
}

/// The regime at the beginning of a piece. An increment that takes in a change says the same as one that was in the
/// second regime from its beginning, and may be as exact: a regime other than rest is asked for twice. Only then, for
/// at a reversal the rates vanish, and rounding would decide on the shorter one.
void History::Increments::begin_regime(double step) {
  const auto regime_within = [&](double dt) { return regime_between(h_->y_, h_->t_, telling_step(h_->t_, dt)); };
  regime_.value = regime_within(begin_share * step);
  if (regime_.value != 0 && regime_within(begin_share * begin_share * step) == 0) regime_.value = 0;
  regime_.known = true;
}

/// The time in this piece beyond which a change of regime is none.
double History::Increments::last_change() const {
  return regime_.value == 0 ? piece_.tie_begin : std::min(piece_.tie_begin, piece_.end - piece_.lag);
}

/// Whether what begins at y and t is in the same regime. A step over the end of plastic loading is plastic as a whole:
/// only a short increment behind it tells. A short increment of a state that is known to a tolerance tells nothing.
bool History::Increments::stays(const Variables& y, double t) {
  const double lag = piece_.lag;
  if (!options_.watch || lag == 0 || regime_.value == 0 || t + lag > piece_.end) return true;
  const Tensor change = F(t + lag) - F(t);
  if (change.norm() < telling * options_.tolerance || !tells(change)) return true;
  try {
    regime_.changed_to = regime_between(y, t, lag);
    return regime_.changed_to == regime_.value;
  } catch (const MaterialFailure& failure) {  // the next step will find it
    if (failure.final) throw;
    return true;
  }
}

/// A change of regime lies within `step` of the accepted point.
void History::Increments::bound_by(double step) {
  if (bound_.t <= h_->t_) bound_ = {0, step, false};
  bound_.t = h_->t_ + step;
  step_ = 0.5 * step;
}

/// Chooses the next step before a change of regime, or steps over it.
void History::Increments::approach_bound(double to) {
  const double width = bound_.t - h_->t_, end = h_->course_->end;
  if (width <= resolution_) return cross(to);
  const bool single = width <= single_share * std::cbrt(resolution_ / end) * end;
  if (!single || bound_.located || regime_.is_new) {
    step_ = std::min(step_, 0.5 * width);
    return;
  }
  bound_.located = true;
  step_ = longest_within(width);
  if (step_ == 0) cross(to);
}

/// The longest single increment that stays in the regime, by bisection; the bound moves next to it.
double History::Increments::longest_within(double width) {
  double low = 0, high = width;
  while (high - low > resolution_) {
    const double middle = 0.5 * (low + high);
    bool within = false;
    try {
      const Steps end = substeps(middle, 1);
      within = end.in_one_regime && stays(end.y, h_->t_ + middle);
    } catch (const MaterialFailure& failure) {  // as good as another regime
      if (failure.final) throw;
    }
    (within ? low : high) = middle;
  }
  bound_.t = h_->t_ + high;
  return low;
}

void History::Increments::note_branch() {
  if (!regime_.is_new || !options_.watch) return;
  if (!regime_.known)
    regime_.value = regime_.changed_to, regime_.known = true;  // nothing since was long enough to tell
  h_->branches_.push_back({h_->t_, regime_.value});
  regime_.is_new = false;
  if (h_->branches_.size() > most_branches * h_->course_->pieces.size()) {
    h_->flickers_ = true;
    options_.watch = false;
  }
}

/// Whatever the regime does: in one increment, or extrapolated where that is longer than the resolution.
void History::Increments::step_over(double to) {
  const double step = to - h_->t_;
  const bool watch = std::exchange(options_.watch, false);
  extrapolation_.clear();
  const int columns = step > resolution_ ? least_columns : 1;
  for (int count = 1; count <= columns; ++count) extrapolation_.add(substeps(step, count).y, scales_);
  options_.watch = watch;
  h_->y_ = extrapolation_.best();
  if (columns > 1) h_->error_ += extrapolation_.error();
  h_->t_ = to;
  bound_.t = 0;
}

/// Over the change of regime, which lies within the resolution before the bound.
void History::Increments::cross(double to) {
  step_ = bound_.step;
  if (bound_.t > last_change()) return step_over(to);
  note_branch();
  over_ = std::min(bound_.t + (regime_.value == 0 ? 0 : piece_.lag), piece_.end);
  step_over(std::min(over_, to));
  regime_.known = false;
  regime_.is_new = true;
  told_ = near_ = {};
}

}  // namespace assay
