// SPDX-License-Identifier: BSD-3-Clause
// Sampled steps of a material, and the measure of differences, for `properties.hpp`.
#pragma once

#include <algorithm>

#include "tests/adapters/models/histories.hpp"

namespace assay::model_tests {

/// A step in the middle of a history.
struct Sample {
  double t, dt;
  Tensor F0, F1, F_rate;
  std::vector<double> state0;
  Point end;
};

/// Deformed, rotated, yielding, unloading and reloading states.
inline std::vector<Sample> samples_of(const Material& material) {
  std::vector<Sample> samples;
  for (const History& history : {cyclic_shear(0.45), stretch_and_rotation(0.12), stretch_and_rotation(-0.1)}) {
    constexpr int steps = 60;
    Point now{Tensor::Zero(), material.initial_state(1)};
    for (int i = 0; i < steps; ++i) {
      const double t0 = history.end * i / steps, t1 = history.end * (i + 1) / steps;
      Sample sample{t0, t1 - t0, history.F(t0), history.F(t1), history.F_rate(t1), now.state, {}};
      now = sample.end = point_after(material, t0, t1 - t0, sample.F0, sample.F1, now.state);
      if (i % 7 == 3) samples.push_back(sample);
    }
  }
  return samples;
}

/// Stress [Pa] below which a difference is measured against this: a thousandth of the axial stiffness at rest.
inline double stress_floor(const Material& material) {
  Tensor F = Tensor::Identity();
  F(0, 0) = 1.01;
  const Point end = point_after(material, 0, 1, Tensor::Identity(), F, material.initial_state(1));
  return 0.1 * end.cauchy.cwiseAbs().maxCoeff();
}

inline double relative(const Tensor& found, const Tensor& expected, double floor) {
  return difference(found, expected) / std::max(floor, expected.cwiseAbs().maxCoeff());
}

inline Tensor piola(const Tensor& sigma, const Tensor& F) { return F.determinant() * sigma * F.inverse().transpose(); }

}  // namespace assay::model_tests
