// SPDX-License-Identifier: BSD-3-Clause
// One attempt at a step of a controlled history: sub-steps, extrapolation, and what errors are measured against.
#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/control/controlled_march.hpp"
#include "harness/material/state_variable.hpp"

namespace assay {

namespace {

constexpr double longest_change = 0.1;     ///< of a component of q over a step
constexpr int least_columns = 3;           ///< two may agree by chance
constexpr double slow_convergence = 0.3;   ///< of the error by one more column: a kink
constexpr double lucky = 100;              ///< of what is allowed: an error with one column less that would be chance
constexpr double growing_noise = 1e-6;     ///< relative
constexpr double no_better = 0.5;          ///< of the error of a step forty times as long
constexpr double rounding_of_results = 4;  ///< results carry the rounding of many operations
constexpr double most_noise = 1e12;        ///< in roundings
constexpr int most_wishes = 60;            ///< of a material for a shorter step, one after the other

}  // namespace

std::vector<double> ControlledMarch::packed(const ControlledPoint& point) const {
  std::vector<double> y;
  for (const Tensor* A : {&point.q, &point.s}) {
    for (int c = 0; c < 9; ++c) y.push_back(component(*A, c));
  }
  y.push_back(point.work);
  if (control_.deformation == Deformation::velocity_gradient) {
    for (int c = 0; c < 9; ++c) y.push_back(component(point.F, c));
  }
  y.insert(y.end(), point.state.begin(), point.state.end());
  return y;
}

ControlledPoint ControlledMarch::unpacked(const std::vector<double>& y, double t,
                                          const ControlledPoint& pattern) const {
  ControlledPoint point = pattern;
  point.t = t;
  point.q = tensor_of(y.data());
  point.s = tensor_of(y.data() + 9);
  point.work = y[18];
  std::size_t next = 19;
  if (control_.deformation == Deformation::velocity_gradient) {
    point.F = tensor_of(y.data() + next);
    next += 9;
  } else {
    point.F = gradient_of(control_.deformation, point.F, point.q, point.q);
  }
  point.state.assign(y.begin() + static_cast<std::ptrdiff_t>(next), y.end());
  return point;
}

/// All components of one tensor or variable share their scale. Rounding of what is zero is no error.
void ControlledMarch::widen_scales(const ControlledPoint& point) {
  const std::vector<double> y = packed(point);
  std::size_t begin = 0;
  const auto share = [&](std::size_t size, double least, const std::vector<double>& values) {
    double largest = least;
    for (std::size_t k = begin; k < begin + size; ++k) largest = std::max({largest, scales_[k], std::abs(values[k])});
    std::fill_n(scales_.begin() + static_cast<std::ptrdiff_t>(begin), size, largest);
    begin += size;
  };
  std::vector<double> moved = y;
  const Tensor rest = deformation_at_rest(control_.deformation);
  for (int c = 0; c < 9; ++c) moved[static_cast<std::size_t>(c)] -= component(rest, c);
  constexpr double least_strain = 1e-9, least_stress = 1e-6;  // the latter of the modulus and the strain
  constexpr double rounding_of_F = 1e-15;
  share(9, least_strain, moved);
  const double strain = scales_[0];
  // Below these strains a stress, and what the state has of it, is what F rounds to: no tolerance can be met there.
  const double least = std::max(least_stress * strain, rounding_of_F / options_.tolerance);
  share(9, least * steps_.modulus(), y);
  share(1, least * steps_.modulus() * strain, y);
  if (control_.deformation == Deformation::velocity_gradient) share(9, 1, y);
  auto modulus = steps_.state_moduli().begin();
  for (const StatePlace& place : state_of(material_.table())) {
    const double largest = *std::max_element(modulus, modulus + static_cast<std::ptrdiff_t>(place.size));
    modulus += static_cast<std::ptrdiff_t>(place.size);
    share(place.size, std::max(least * largest, least_strain * strain), y);
  }
  const double stress = steps_.modulus() / scales_[9];
  noise_ = std::min(most_noise, std::max({1.0, 1 / strain, stress}) / rest_condition_);
}

std::vector<double> ControlledMarch::values(const Piece& piece, double share) const {
  std::vector<double> all;
  for (std::size_t k = 0; k < control_.rows.size(); ++k) {
    if (piece.jump) {
      all.push_back(share >= 1 ? piece.behind[k] : (1 - share) * piece.before[k] + share * piece.behind[k]);
    } else {
      all.push_back(control_.rows[k].value(share >= 1 ? piece.begin + piece.width : piece.begin + share * piece.width,
                                           share <= 0));
    }
  }
  return all;
}

std::optional<ControlledPoint> ControlledMarch::substeps(const Piece& piece, const ControlledPoint& from, double at,
                                                         double step, int count, Attempt& made) {
  ControlledPoint point = from;
  Tensor rate = rate_;
  made.residual = 0;
  for (int j = 0; j < count; ++j) {
    const double share = j + 1 == count ? at + step : at + step * (j + 1) / count;
    const double dt = piece.width * step / count;
    const Tensor before = point.q;
    SolvedStep solved = steps_.solve(point, dt, values(piece, share), point.q + rate * (step / count));
    if (solved.outcome == SolvedStep::Outcome::shorter && wishes_ < most_wishes) {
      ++wishes_;
      made.shorter = std::clamp(solved.shorter, 0.1, 0.9);
      return std::nullopt;
    }
    const bool solves = solved.outcome == SolvedStep::Outcome::solved || solved.outcome == SolvedStep::Outcome::shorter;
    if (!solves || (!by_increments(piece) && (solved.end.q - before).cwiseAbs().maxCoeff() > longest_change)) {
      refused_ = solved.outcome == SolvedStep::Outcome::material_failed ? steps_.failure() : std::nullopt;
      if (!refused_) tried_ = solved.end;
      return std::nullopt;
    }
    if (!coarse_ && !keeps_regime(point, solved.end)) {
      made.outcome = Attempt::Outcome::regime_changes;
      first_ = std::move(solved.end);
      return std::nullopt;
    }
    made.residual = std::max(made.residual, solved.residual);
    point = std::move(solved.end);
    rate = (point.q - before) / (step / count);
  }
  return point;
}

ControlledMarch::Attempt ControlledMarch::attempt(const Piece& piece, const ControlledPoint& from, double at,
                                                  double step) {
  Attempt made;
  extrapolation_.clear();
  const bool single = coarse_ || by_increments(piece);
  const int most = single ? 1 : Extrapolation::most_columns;
  double last_error = std::numeric_limits<double>::infinity();
  for (int count = 1; count <= most; ++count) {
    auto end = substeps(piece, from, at, step, count, made);
    if (!end) {
      if (made.outcome != Attempt::Outcome::regime_changes) made.outcome = Attempt::Outcome::failed;
      return made;
    }
    if (count == 1) first_ = *end;
    if (single) {
      made.end = std::move(*end), made.error = 0, made.outcome = Attempt::Outcome::accepted;
      return made;
    }
    extrapolation_.add(packed(*end), scales_);
    const double error = extrapolation_.error();
    if (count < least_columns) {
      last_error = error;
      continue;
    }
    if (count == least_columns || error < made.error) {
      made.error = error;
      made.end = unpacked(extrapolation_.best(), end->t, *end);
    }
    const double allowed = options_.tolerance + rounding_of_results * noise_ * extrapolation_.rounding();
    if (error <= allowed && last_error <= lucky * allowed) {
      made.outcome =
          turns_within(piece, made.end, at + step) ? Attempt::Outcome::regime_changes : Attempt::Outcome::accepted;
      return made;
    }
    if (count > least_columns && error > slow_convergence * last_error) break;
    last_error = error;
  }
  const double worst = *std::max_element(failed_errors_.begin(), failed_errors_.end());
  made.noisy = failed_errors_.back() > 0 && made.error < growing_noise && made.error > no_better * worst;
  if (made.noisy && turns_within(piece, made.end, at + step)) {
    made.outcome = Attempt::Outcome::regime_changes;
  } else if (made.noisy) {
    made.outcome = Attempt::Outcome::accepted;  // shorter steps have not helped
  }
  return made;
}

}  // namespace assay
