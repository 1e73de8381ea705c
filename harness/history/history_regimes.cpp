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
  return norm == 0 || (regime_known_ && regime_ == 0) || change.norm() >= telling_margin * norm;
}

/// A step from t, no shorter than `step`, that is long enough to tell; `step` where the piece ends before.
double History::Increments::telling_step(double t, double step) const {
  const Path& path = *h_->course_->path;
  const Tensor begin = path.deformation_gradient(h_->xi_, t);
  for (double longer = step; t + longer <= piece_end_; longer *= 2) {
    if (tells(path.deformation_gradient(h_->xi_, t + longer) - begin)) return longer;
  }
  return step;
}

/// Of the increment from now_ to next_.
std::uint64_t History::Increments::regime_of_increment(const double* before, const double* after) const {
  const Course& course = *h_->course_;
  if (course.telling == Telling::state) return course.regimes.of(now_.data() + 9, next_.data() + 9);
  Tensor F0, F1, s;
  for (int c = 0; c < 9; ++c) {
    component(F0, c) = before[c];
    component(F1, c) = after[c];
    component(s, c) = next_[static_cast<std::size_t>(c)];
  }
  s.diagonal().array() -= s.trace() / 3;
  const Tensor step = (F1 - F0) * F1.inverse();
  return s.cwiseProduct(step + step.transpose()).sum() > 0 ? 1 : 0;
}

/// Of one increment from y.
std::uint64_t History::Increments::regime_between(const std::vector<double>& y, double t, double dt) {
  const Tensor F0 = h_->course_->path->deformation_gradient(h_->xi_, t);
  const Tensor F1 = h_->course_->path->deformation_gradient(h_->xi_, t + dt);
  double before[9], after[9];
  for (int c = 0; c < 9; ++c) before[c] = component(F0, c), after[c] = component(F1, c);
  now_ = y;
  next_.resize(now_.size());
  increment(t, dt, before, after);
  return regime_of_increment(before, after);
}

/// The regime at the beginning of a piece. An increment that takes in a change says the same as one that was in the
/// second regime from its beginning, and may be as exact: a regime other than rest is asked for twice. Only then, for
/// at a reversal the rates vanish, and rounding would decide on the shorter one.
void History::Increments::begin_regime(double step) {
  const auto regime_within = [&](double dt) { return regime_between(h_->y_, h_->t_, telling_step(h_->t_, dt)); };
  regime_ = regime_within(begin_share * step);
  if (regime_ != 0 && regime_within(begin_share * begin_share * step) == 0) regime_ = 0;
  regime_known_ = true;
}

/// The time in this piece beyond which a change of regime is none.
double History::Increments::last_change() const {
  return regime_ == 0 ? tie_begin_ : std::min(tie_begin_, piece_end_ - lag_);
}

/// Whether what begins at y and t is in the same regime. A step over the end of plastic loading is plastic as a whole:
/// only a short increment behind it tells. A short increment of a state that is known to a tolerance tells nothing.
bool History::Increments::stays(const std::vector<double>& y, double t) {
  if (!options_.watch || lag_ == 0 || regime_ == 0 || t + lag_ > piece_end_) return true;
  const Path& path = *h_->course_->path;
  const Tensor change = path.deformation_gradient(h_->xi_, t + lag_) - path.deformation_gradient(h_->xi_, t);
  if (change.norm() < telling * options_.tolerance || !tells(change)) return true;
  try {
    changed_to_ = regime_between(y, t, lag_);
    return changed_to_ == regime_;
  } catch (const MaterialFailure& failure) {  // the next step will find it
    if (failure.final) throw;
    return true;
  }
}

/// A change of regime lies within `step` of the accepted point.
void History::Increments::bound_by(double step) {
  if (bound_ <= h_->t_) {
    before_bound_ = step;
    located_ = false;
  }
  bound_ = h_->t_ + step;
  step_ = 0.5 * step;
}

/// Chooses the next step before a change of regime, or steps over it.
void History::Increments::approach_bound(double to) {
  const double width = bound_ - h_->t_, end = h_->course_->end;
  if (width <= resolution_) return cross(to);
  const bool single = width <= single_share * std::cbrt(resolution_ / end) * end;
  if (!single || located_ || regime_new_) {
    step_ = std::min(step_, 0.5 * width);
    return;
  }
  located_ = true;
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
      within = substeps(middle, 1) && stays(next_, h_->t_ + middle);
    } catch (const MaterialFailure& failure) {  // as good as another regime
      if (failure.final) throw;
    }
    (within ? low : high) = middle;
  }
  bound_ = h_->t_ + high;
  return low;
}

void History::Increments::note_branch() {
  if (!regime_new_ || !options_.watch) return;
  if (!regime_known_) regime_ = changed_to_, regime_known_ = true;  // nothing since was long enough to tell
  h_->branches_.push_back({h_->t_, regime_});
  regime_new_ = false;
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
  for (int count = 1; count <= columns; ++count) {
    substeps(step, count);
    extrapolation_.add(next_, scales_);
  }
  options_.watch = watch;
  h_->y_ = columns > 1 ? extrapolation_.best() : next_;
  if (columns > 1) h_->error_ += extrapolation_.error();
  h_->t_ = to;
  bound_ = 0;
}

/// Over the change of regime, which lies within the resolution before the bound.
void History::Increments::cross(double to) {
  step_ = before_bound_;
  if (bound_ > last_change()) return step_over(to);
  note_branch();
  over_ = std::min(bound_ + (regime_ == 0 ? 0 : lag_), piece_end_);
  step_over(std::min(over_, to));
  regime_known_ = false;
  regime_new_ = true;
  told_ = near_ = {};
}

}  // namespace assay
