// SPDX-License-Identifier: BSD-3-Clause
// Stress and state at a time so near that increments to it are too short to tell their regime. A material whose yield
// test has a tolerance takes such increments for elastic ones while plastic flow goes on, and errs by that tolerance.
#include <algorithm>
#include <cmath>

#include "harness/history/history_forms.hpp"

namespace assay {

/// Into how many increments a step can be divided that are all long enough to tell, at most as many as an
/// extrapolation takes: where the path stops or starts, the last or the first is the shortest.
int History::Increments::telling_count(double t, double step) const {
  const Tensor begin = F(t), end = F(t + step);
  for (int count = Extrapolation::most_columns; count > 1; --count) {
    if (tells(F(t + step / count) - begin) && tells(end - F(t + step - step / count))) return count;
  }
  return 1;
}

bool History::Increments::far(double t, double step) const {
  return telling_count(t, step) == Extrapolation::most_columns;
}

/// Of a single increment, relative: of second order in its elastic stress over the scale.
double History::Increments::error_at_once(double t, double step) const {
  const ShortestTelling& shortest = h_->course_->shortest;
  const double change = (F(t + step) - F(t)).norm();
  return std::pow(change / shortest.norm * shortest.stress / scales_[0], 2);
}

/// Goes back to where the last long step began, from where the next ones are long; or, where a regime has just begun,
/// to there. What is near to that, too, a few increments reach, or one: at the edge of the tolerance, the first takes
/// the material over that edge. Whether it has reached `to`.
bool History::Increments::reach_near_time(double to) {
  if (h_->course_->shortest.norm == 0 || h_->t_ < over_ || far(h_->t_, to - h_->t_)) return false;
  if (near_.t < 0) near_ = {h_->t_, h_->y_};
  const Place& from = told_.regime != 0 ? told_ : near_;
  h_->t_ = from.t;
  h_->y_ = from.y;
  step_ = to - from.t;
  const int columns = telling_count(from.t, step_);
  if (columns == Extrapolation::most_columns) return false;
  extrapolation_.clear();
  double error = error_at_once(from.t, step_);
  Variables y;
  try {
    if (options_.watch && from.t == piece_.begin) begin_regime(step_);
    std::uint64_t told = 0;
    for (int count = 1; count <= columns; ++count) {
      const Steps end = substeps(step_, count);
      if (!end.in_one_regime) return false;
      if (count > 1 && regime_.last_told != told) break;  // `to` lies at the edge: a single increment is as good
      told = regime_.last_told;
      extrapolation_.add(end.y, scales_);
      y = extrapolation_.best();
      if (count > 1) error = extrapolation_.error();
    }
  } catch (const MaterialFailure& failure) {
    if (failure.final) throw;
    return false;
  }
  note_branch();
  h_->error_ = std::max(h_->error_, error);
  h_->y_ = y;
  h_->t_ = to;
  return true;
}

}  // namespace assay
