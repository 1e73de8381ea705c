// SPDX-License-Identifier: BSD-3-Clause
#include "harness/control/increment_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "harness/numeric/norms.hpp"
#include "harness/numeric/stopwatch.hpp"

namespace assay {

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// e11 and e22 to where the increment begins at t = 1, and on by (a, b) until t = 2; face 3 is free.
Control increment_of_strain(const IsoErrorChoice& choice, double a, double b) {
  Control control{Deformation::logarithmic_strain, StressMeasure::kirchhoff, {}, {0, 1, 2}};
  const auto add = [&](int i, int j, bool stress, double first, double more) {
    ControlRow row;
    (stress ? row.stress : row.deformation)(i, j) = 1;
    row.value = [=](double t, bool) { return t < 1 ? first * t : first + more * (t - 1); };
    control.rows.push_back(std::move(row));
  };
  add(0, 0, false, choice.e11, a * choice.unit);
  add(1, 1, false, choice.e22, b * choice.unit);
  add(2, 2, true, 0, 0);
  for (const auto& [i, j] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) add(i, j, false, 0, 0);
  return control;
}

double relative_difference(const ControlledHistory& one, const ControlledHistory& other) {
  const bool both = one.outcome == ControlOutcome::completed && other.outcome == ControlOutcome::completed;
  if (!both) return no_number;
  const double size = other.rows.back().s.norm();
  return size > 0 ? (one.rows.back().s - other.rows.back().s).norm() / size : no_number;
}

}  // namespace

std::vector<IncrementError> increment_errors(const Material& material, const Control& control,
                                             std::span<const int> increments,
                                             const std::function<void(double share)>& progress) {
  ControlOptions options;
  options.watch_ellipticity = false;
  const auto histories = static_cast<double>(increments.size() + 1);
  double done = 0;
  if (progress) options.progress = [&](double share) { progress((done + share) / histories); };
  const ControlledHistory solution = follow_control(material, control, control.knots, options);
  if (solution.outcome != ControlOutcome::completed) throw std::runtime_error(solution.reason);
  double stress = 0, change = 0;
  for (const ControlledRow& row : solution.rows) {
    stress = std::max(stress, largest_of(row.s));
    change = std::max(change, largest_of(row.q - solution.rows[0].q));
  }
  std::vector<IncrementError> all;
  for (const int count : increments) {
    options.increments = count;
    ++done;
    const Stopwatch watch;
    const ControlledHistory found = follow_control(material, control, control.knots, options);
    IncrementError error{count, 0, 0, found.calls, watch.seconds() / static_cast<double>(found.calls), found.outcome};
    for (std::size_t k = 0; k < std::min(found.rows.size(), solution.rows.size()); ++k) {
      error.stress = std::max(error.stress, largest_of(found.rows[k].s - solution.rows[k].s) / stress);
      error.deformation = std::max(error.deformation, largest_of(found.rows[k].q - solution.rows[k].q) / change);
    }
    all.push_back(error);
  }
  return all;
}

IsoErrorMap iso_errors(const Material& material, const IsoErrorChoice& choice,
                       const std::function<void(double share)>& progress) {
  IsoErrorMap map;
  const auto points = static_cast<std::size_t>(choice.points);
  for (std::size_t k = 0; k < points; ++k)
    map.units.push_back(choice.reach * static_cast<double>(k) / static_cast<double>(points - 1));
  const std::vector<double> times{0, 1, 2};
  std::array<double, 3> sums{};  // with one, two and four increments
  std::size_t counted = 0;
  for (std::size_t i = 0; i < points; ++i) {
    for (std::size_t j = 0; j < points; ++j) {
      const Control control = increment_of_strain(choice, map.units[i], map.units[j]);
      ControlOptions options{.tolerance = 1e-9, .watch_ellipticity = false};
      const ControlledHistory solution = follow_control(material, control, times, options);
      options.increments_from = 1;
      std::array<double, 3> errors{};
      for (std::size_t k = 0; k < 3; ++k) {
        options.increments = 1 << k;
        errors[k] = relative_difference(follow_control(material, control, times, options), solution);
      }
      map.errors.push_back(i + j == 0 ? 0 : errors[0]);
      if (i + j == 0 || !std::isfinite(errors[0] + errors[1] + errors[2])) continue;
      for (std::size_t k = 0; k < 3; ++k) sums[k] += errors[k];
      map.largest = std::max(map.largest, errors[0]);
      ++counted;
    }
    if (progress) progress(static_cast<double>(i + 1) / static_cast<double>(points));
  }
  if (counted > 0) map.mean = sums[0] / static_cast<double>(counted);
  map.order = sums[2] > 0 ? std::log2(sums[1] / sums[2]) : no_number;
  return map;
}

}  // namespace assay
