// SPDX-License-Identifier: BSD-3-Clause
// The single-point driver: takes a material through a family of baseline histories F(xi, t).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "harness/history/history.hpp"
#include "harness/numeric/parallel.hpp"

namespace assay {

/// Stress and state of n points at one time.
struct PointState {
  std::vector<double> cauchy;  ///< 9 * n, component-major [Pa]
  std::vector<double> state;   ///< state_size * n
};

struct DriverOptions {
  double tolerance = 1e-12;  ///< error of a step relative to the largest stress over all histories
  Form form = Form::automatic;
  Workers workers = {};
};

/// Histories of n values of xi at m times.
struct Histories {
  std::vector<double> xi, times;
  std::vector<PointState> points;        ///< one for each time
  std::vector<std::vector<double>> tau;  ///< first Piola-Kirchhoff stress, one for each time, 9 * n [Pa]
  double error = 0;                      ///< estimated, relative to the largest Cauchy stress
  std::int64_t material_calls = 0;       ///< points updated, or rates taken
};

/// Every xi from rest at t = 0 through the ascending times >= 0, with error control. Throws MaterialFailure.
Histories integrate_histories(const Material& material, const Path& path, std::span<const double> xi,
                              std::span<const double> times, const DriverOptions& options = {});

}  // namespace assay
