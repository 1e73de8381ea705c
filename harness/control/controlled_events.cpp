// SPDX-License-Identifier: BSD-3-Clause
// What is looked for on the way of a controlled history: rows that do not determine it, limit loads, other solutions,
// loss of ellipticity, and the stops of the control.
#include <algorithm>
#include <cmath>
#include <utility>

#include "harness/control/controlled_march.hpp"

namespace assay {

namespace {

constexpr double undetermined = 1e-9;  ///< of a matrix at rest: smallest over largest singular value
constexpr double singular = 1e-3;      ///< of a matrix, against that at rest
constexpr double sure = 1e-4;          ///< of the determinant at rest: one whose sign is no rounding
constexpr std::size_t most_branches = 20;
constexpr double rest_step = 1e-6;           ///< of the end [1]
constexpr double difference = 1e-8;          ///< of F
constexpr double of_least_difference = 100;  ///< of what the material answers: smaller ones are too rough
constexpr double along = 20;                 ///< in differences: a step along the path on which they all stay
constexpr double neutral = 1e-8;             ///< of the largest acoustic eigenvalue at rest: a fluid
constexpr double slowest = 1e-3;             ///< of the end: the longest time of such a step
constexpr int most_trials = 80;              ///< for a crossing
constexpr double resolution = 1e-12;         ///< of a piece, of a time that is looked for
constexpr double sure_fall = 1e-9;           ///< behind a peak, of the largest value
constexpr double golden = 0.381966011250105;

}  // namespace

/// The matrix at rest, and the stiffness.
void ControlledMarch::look_at_rest() {
  const bool by_increments = options_.increments > 0 && control_.begin() >= options_.increments_from;
  const double increment = (control_.knots[1] - control_.knots[0]) / std::max(1, options_.increments);
  const double dt = by_increments ? increment : rest_step * control_.length();
  const ControlMatrix matrix = steps_.matrix_at(now_, dt, steps_.held(now_, dt).value_or(now_));
  rest_condition_ = matrix.condition();
  rest_determinant_ = std::abs(matrix.determinant);
  if (!(rest_condition_ > undetermined)) {
    history_.outcome = ControlOutcome::undetermined;
    history_.reason = "the rows leave a deformation free at rest";
    history_.direction = matrix.direction;
    rest_condition_ = 1;
    ended_ = true;
    return;
  }
  for (const ControlStop& stop : control_.stops) {
    const double sign = stop.when == ControlStop::When::below ? -1 : 1;
    const bool of_bound = stop.when == ControlStop::When::above || stop.when == ControlStop::When::below;
    if (of_bound && sign * (value_of(stop.quantity, now_) - stop.bound) >= 0) return stop_at(now_, stop.name);
  }
  if (!options_.watch_ellipticity || material_.has(ASSAY_IN_PLANE)) return;
  try {
    const TangentModulus A =
        probe_tangent_modulus(material_, now_.t, rest_step * control_.length(), now_.F, now_.state);
    const double smallest = smallest_acoustic_eigenvalue(A).value;
    if (smallest > neutral * largest_acoustic_eigenvalue(A).value) acoustic_at_rest_ = smallest;
  } catch (const MaterialFailure&) {
    acoustic_at_rest_ = 0;  // it does not bear differences at rest: nobody watches
  }
}

/// By differences about a step taken in one, which stay on the branch that the step is on.
void ControlledMarch::look_at_matrix(const Piece& piece, const ControlledPoint& before, double step) {
  if (steps_.count() == 0) return;
  const ControlMatrix matrix = steps_.matrix_at(before, piece.width * step, first_);
  if (!(std::abs(matrix.determinant) > sure * rest_determinant_)) return;
  if (determinant_ * matrix.determinant < 0 && history_.branches.size() < most_branches) {
    const double sign = determinant_ > 0 ? 1 : -1, begin = determinant_;
    const auto about = [&](const ControlledPoint& point) {
      return steps_.matrix_at(before, std::max(point.t - before.t, std::numeric_limits<double>::min()), point);
    };
    // Close to the zero the matrix is singular and no step ends there: the time lies between those that are found.
    std::pair<double, double> last{before.t, begin}, next{now_.t, matrix.determinant};
    const auto past = [&](const ControlledPoint& point) {
      if (point.t <= before.t) return -sign * begin;
      const double found = about(point).determinant;
      if (sign * found > 0 && point.t > last.first) last = {point.t, found};
      if (sign * found <= 0 && point.t < next.first) next = {point.t, found};
      return -sign * found;
    };
    if (!piece.jump) at_crossing(piece, before, at_, step, past);
    const double share = last.second / (last.second - next.second);
    history_.branches.push_back({last.first + share * (next.first - last.first), matrix.direction});
  }
  determinant_ = matrix.determinant;
}

/// Of the instantaneous modulus along the way on which the point came: from steps along it of two lengths, to none.
AcousticExtreme ControlledMarch::acoustic_at(const ControlledPoint& before, const ControlledPoint& point) const {
  const Tensor way = point.F - before.F;
  const double length = way.norm(), time = point.t - before.t;
  if (!(length > 0)) return {acoustic_at_rest_ * acoustic_, history_.normal};
  const double size = std::max(difference, of_least_difference * steps_.least_difference());
  const auto behind = [&](double strain) {
    const double dt = std::min(slowest * control_.length(), time * strain / length);
    const Tensor F1 = point.F + strain / length * way;
    return smallest_acoustic_eigenvalue(
        probe_tangent_modulus(material_, point.t, std::max(dt, 1e-300), point.F, F1, point.state, size));
  };
  AcousticExtreme found = behind(along * size);
  found.value = 2 * found.value - behind(2 * along * size).value;
  return found;
}

void ControlledMarch::look_at_ellipticity(const Piece& piece, const ControlledPoint& before, double step) {
  if (acoustic_at_rest_ == 0) return;
  try {
    AcousticExtreme found = acoustic_at(before, now_);
    acoustic_ = found.value / acoustic_at_rest_;
    if (acoustic_ > 0 || history_.loses_ellipticity) return;
    ControlledPoint point = now_;
    if (!piece.jump) {
      point = at_crossing(piece, before, at_, step, [&](const ControlledPoint& at) {
        return at.t <= before.t ? -1.0 : -acoustic_at(before, at).value / acoustic_at_rest_;
      });
      found = acoustic_at(before, point);
    }
    const double reached = std::exchange(acoustic_, found.value / acoustic_at_rest_);
    history_.loses_ellipticity = point.t;
    history_.normal = found.normal;
    for (const ControlStop& stop : control_.stops) {
      if (stop.when == ControlStop::When::loss_of_ellipticity) return stop_at(std::move(point), stop.name);
    }
    acoustic_ = reached;
  } catch (const MaterialFailure&) {
    acoustic_ = std::numeric_limits<double>::quiet_NaN();  // its own steps go a little beyond the path
  }
}

void ControlledMarch::stop_at(ControlledPoint point, const std::string& why) {
  now_ = std::move(point);
  history_.outcome = ControlOutcome::stopped;
  history_.reason = why;
  write_row(now_);
  ended_ = true;
}

/// The point on a step at which `past` becomes positive: false position, each trial a step of its own from `from`.
ControlledPoint ControlledMarch::at_crossing(const Piece& piece, const ControlledPoint& from, double at, double step,
                                             const std::function<double(const ControlledPoint&)>& past) {
  double low = 0, high = step;
  ControlledPoint best = now_;
  double f_low = past(from), f_high = past(now_);
  int side = 0;
  for (int i = 0; i < most_trials && high - low > resolution && f_high != 0; ++i) {
    double middle = (f_low * high - f_high * low) / (f_low - f_high);
    if (!(middle > low && middle < high) || i > most_trials / 2) middle = 0.5 * (low + high);
    const Attempt made = attempt(piece, from, at, middle);
    if (made.end.state.size() != from.state.size() || made.outcome == Attempt::Outcome::failed) break;
    const double f = past(made.end);
    if (f >= 0) {
      high = middle, f_high = f, best = made.end;
      if (side == 1) f_low *= 0.5;  // Illinois
      side = 1;
    } else {
      low = middle, f_low = f;
      if (side == -1) f_high *= 0.5;
      side = -1;
    }
  }
  return best;
}

/// The point of a step with the highest value, if that is higher than the best so far: golden section.
void ControlledMarch::raise(const Piece& piece, const ControlledPoint& from, double at, double step,
                            const std::function<double(const ControlledPoint&)>& value, ControlledPoint& best) {
  double low = 0, high = step;
  for (int i = 0; i < most_trials && high - low > resolution; ++i) {
    const double a = low + golden * (high - low), b = high - golden * (high - low);
    const Attempt first = attempt(piece, from, at, a), second = attempt(piece, from, at, b);
    if (first.outcome == Attempt::Outcome::failed || second.outcome == Attempt::Outcome::failed) return;
    const bool left = value(first.end) >= value(second.end);
    (left ? high : low) = left ? b : a;
    const ControlledPoint& better = left ? first.end : second.end;
    if (value(better) > value(best)) best = better;
  }
}

/// Whether the step that was just accepted has reached one.
bool ControlledMarch::meets_stop(const Piece& piece, const ControlledPoint& before, double at, double step) {
  for (const ControlStop& stop : control_.stops) {
    const auto value = [&](const ControlledPoint& point) { return value_of(stop.quantity, point); };
    const double sign = stop.when == ControlStop::When::below ? -1 : 1;
    if (stop.when == ControlStop::When::loss_of_ellipticity) continue;
    if (stop.when == ControlStop::When::peak) {
      double& highest = peaks_[static_cast<std::size_t>(&stop - control_.stops.data())];
      const double reached = value(now_), scale = std::max(std::abs(highest), std::abs(reached));
      if (!(reached < highest - sure_fall * scale)) {
        highest = std::max(highest, reached);
        continue;
      }
      ControlledPoint best = before;
      if (earlier_.step > 0) raise(piece, earlier_.from, earlier_.at, earlier_.step, value, best);
      raise(piece, before, at, step, value, best);
      stop_at(best, stop.name);
      return true;
    }
    const auto past = [&](const ControlledPoint& point) { return sign * (value(point) - stop.bound); };
    if (past(now_) < 0) continue;
    stop_at(past(before) >= 0 ? now_ : at_crossing(piece, before, at, step, past), stop.name);
    return true;
  }
  return false;
}

/// Whether the matrix of the rows is nearly singular behind this step; then history_.direction is the free one.
bool ControlledMarch::at_limit(const Piece& piece, double step) {
  double least = rest_condition_;
  for (const ControlledPoint* point : {&tried_, &first_}) {
    if (point->state.size() != now_.state.size() || !point->F.allFinite() || !(point->F.determinant() > 0)) continue;
    const ControlMatrix matrix = steps_.matrix_at(now_, piece.width * step, *point);
    if (matrix.condition() >= least) continue;
    least = matrix.condition();
    history_.direction = matrix.direction;
  }
  return least < singular * rest_condition_;
}

/// No step is short enough: why.
void ControlledMarch::end_stuck(const Piece& piece, double step) {
  ended_ = true;
  if (coarse_) return;
  if (refused_) {
    history_.outcome = ControlOutcome::material_failed;
    history_.failure = refused_;
    history_.reason = refused_->what();
    return;
  }
  const bool folds = steps_.folds(), limit = at_limit(piece, step);
  history_.outcome = limit ? ControlOutcome::limit_load : ControlOutcome::no_solution;
  history_.reason = limit   ? "no deformation near by has the stress that is asked for"
                    : folds ? "no deformation with det F > 0 meets the rows"
                            : "Newton's method finds no deformation that has the stress that is asked for";
}

void ControlledMarch::write_row(const ControlledPoint& point) {
  ControlledRow row;
  static_cast<ControlledPoint&>(row) = point;
  row.residual = residual_;
  row.error = history_.error;
  row.acoustic = acoustic_at_rest_ > 0 ? acoustic_ : 1;
  history_.rows.push_back(std::move(row));
}

}  // namespace assay
