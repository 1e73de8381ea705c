// SPDX-License-Identifier: BSD-3-Clause
// The single-point driver: takes a material through a family of baseline histories F(xi, t).
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "harness/material.hpp"
#include "harness/path.hpp"

namespace assay {

/// A material refused a step, or returned a non-finite stress.
class MaterialFailure : public std::runtime_error {
 public:
  MaterialFailure(const std::string& what, double at_xi, double at_t) : std::runtime_error(what), xi(at_xi), t(at_t) {}
  double xi, t;
};

/// Stress and state of n points: what Boost.Odeint carries along a history.
struct PointState {
  std::vector<double> cauchy;  ///< 9 * n, component-major [Pa]
  std::vector<double> state;   ///< state_size * n
};

struct DriverOptions {
  double tolerance = 1e-12;    ///< of tau, relative to its largest component over all histories
  int max_substeps = 1 << 10;  ///< between two output times; where they do not suffice, `error` says so
};

/// Histories of n values of xi at m times.
struct Histories {
  std::vector<double> xi, times;
  std::vector<PointState> points;        ///< one for each time
  std::vector<std::vector<double>> tau;  ///< first Piola-Kirchhoff stress, one for each time, 9 * n [Pa]
  double error = 0;                      ///< estimated, relative to the largest component of tau
  std::int64_t material_calls = 0;       ///< points updated
};

/// Every xi from rest at t = 0 through the ascending times >= 0. The material's increments are sub-stepped by
/// Boost.Odeint until the stress at all times has settled to the tolerance. At most ASSAY_BATCH_MAX values of xi.
/// Throws MaterialFailure.
Histories integrate_histories(const Material& material, const Path& path, std::span<const double> xi,
                              std::span<const double> times, const DriverOptions& options = {});

}  // namespace assay
