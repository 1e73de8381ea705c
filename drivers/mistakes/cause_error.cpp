// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/mistakes/cause_error.hpp"

#include <algorithm>
#include <cmath>

namespace assay::drivers {

namespace {

constexpr double beyond_grid = 4;   ///< times the error of the grid: less is the method's own
constexpr double steady = 1.25;     ///< errors of two grids whose cause is one
constexpr double of_meshes = 2e-3;  ///< of the motion: what the meshes of the perturbed problem may be off

/// Errors at the times of another run, linear in between.
std::vector<std::vector<Vector3>> at_times(const BinnedErrors& errors, const std::vector<double>& t) {
  std::vector<std::vector<Vector3>> all;
  for (const double time : t) {
    const auto next = std::ranges::lower_bound(errors.t, time);
    const std::size_t k = static_cast<std::size_t>(next - errors.t.begin());
    if (k == errors.t.size()) return all;
    if (errors.t[k] == time || k == 0) {
      all.push_back(errors.e[k]);
      continue;
    }
    const double q = (time - errors.t[k - 1]) / (errors.t[k] - errors.t[k - 1]);
    auto& mean = all.emplace_back();
    for (std::size_t b = 0; b < errors.X.size(); ++b) mean.push_back((1 - q) * errors.e[k - 1][b] + q * errors.e[k][b]);
  }
  return all;
}

double root_mean(const std::vector<std::vector<Vector3>>& e, const std::vector<double>& weight) {
  double sum = 0;
  for (const auto& frame : e) {
    for (std::size_t b = 0; b < weight.size(); ++b) sum += weight[b] * dot_in_plane(frame[b], frame[b]);
  }
  return e.empty() ? 0 : std::sqrt(sum / static_cast<double>(e.size()));
}

/// The last frame that is not after a time.
std::size_t frame_before(const BinnedErrors& errors, double t) {
  const auto next = std::ranges::upper_bound(errors.t, t * (1 + 1e-9));
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(next - errors.t.begin() - 1, 0));
}

/// Root of the mean square of what is not a bin's mean, in a frame [m].
double scatter(const BinnedErrors& errors, std::size_t k) {
  double in_bins = 0;
  for (std::size_t b = 0; b < errors.X.size(); ++b)
    in_bins += errors.weight[b] * dot_in_plane(errors.e[k][b], errors.e[k][b]);
  return std::sqrt(std::max(0.0, errors.square[k] - in_bins));
}

}  // namespace

CauseError cause_error_of(const std::vector<MeasuredErrors>& runs) {
  const MeasuredErrors& finest = runs.back();
  CauseError found;
  found.t = finest.errors.t, found.e = finest.errors.e, found.X = finest.errors.X, found.weight = finest.errors.weight;
  found.square = finest.errors.square;
  double mean_square = 0, in_bins = 0, of_motion = 0;
  for (const double square : finest.errors.motion) of_motion += square / static_cast<double>(found.t.size());
  found.motion = std::sqrt(of_motion);
  for (const double square : found.square) mean_square += square / static_cast<double>(found.t.size());
  const double of_bins = root_mean(found.e, found.weight);
  in_bins = of_bins * of_bins;
  found.error = std::sqrt(mean_square);
  found.discretisation = std::sqrt(std::max(0.0, mean_square - in_bins));
  if (runs.size() < 2) return found;
  const MeasuredErrors& coarse = runs[runs.size() - 2];
  auto before = at_times(coarse.errors, found.t);
  if (before.size() < least_frames || !(coarse.h > finest.h)) return found;
  found.from_ladder = true;
  found.coarser = before, found.refined = coarse.h / finest.h;
  found.t.resize(before.size()), found.e.resize(before.size()), found.square.resize(before.size());
  for (std::size_t b = 0; b < found.weight.size(); ++b) {
    if (coarse.errors.weight[b] == 0) found.weight[b] = 0;
  }
  found.falls = root_mean(before, found.weight) / root_mean(found.e, found.weight);
  double of_fine = 0, of_coarse = 0;
  for (std::size_t k = 0; k < found.e.size(); ++k) {
    of_fine += finest.errors.square[k];
    of_coarse += coarse.errors.square[frame_before(coarse.errors, found.t[k])];
  }
  found.all_falls = std::sqrt(of_coarse / of_fine);
  constexpr double order = 2;  // of codes without a mistake
  const double share = 1 / (std::pow(coarse.h / finest.h, order) - 1);
  std::vector<std::vector<Vector3>> change(found.e);
  double scattered = 0;
  for (std::size_t k = 0; k < found.e.size(); ++k) {
    double square = 0;
    for (std::size_t b = 0; b < found.weight.size(); ++b) {
      change[k][b] = share * (before[k][b] - found.e[k][b]);
      found.e[k][b] -= change[k][b];
      square += found.weight[b] * dot_in_plane(found.e[k][b], found.e[k][b]);
    }
    // What is not a bin's mean falls with the grid, too; where it does not, it is part of the error.
    const double scatter_here = scatter(finest.errors, k),
                 before_here = scatter(coarse.errors, frame_before(coarse.errors, found.t[k]));
    const double left = std::max(0.0, scatter_here - share * (before_here - scatter_here));
    found.square[k] = square + left * left;
    scattered += left * left;
  }
  const double of_means = root_mean(found.e, found.weight);
  found.error = std::sqrt(of_means * of_means + scattered / static_cast<double>(found.e.size()));
  found.discretisation = root_mean(change, found.weight);
  return found;
}

bool is_steady(const CauseError& error) { return error.from_ladder && error.falls < steady; }

bool is_beyond_the_grid(const CauseError& error) {
  const bool settled = !error.from_ladder || is_steady(error);
  return settled && error.error > std::max(beyond_grid * error.discretisation, of_meshes * error.motion);
}

bool stays(const CauseError& error) {
  return error.from_ladder && error.all_falls < steady && error.all_falls * steady > 1 &&
         error.error > of_meshes * error.motion;
}

}  // namespace assay::drivers
