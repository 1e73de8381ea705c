// SPDX-License-Identifier: BSD-3-Clause
// Histories of deformation for the tests of models, and a model's increments along them.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "adapters/builtin.hpp"
#include "harness/material/material.hpp"

namespace assay::model_tests {

/// F(t) and its rate, from F = I at t = 0.
struct History {
  std::function<Tensor(double)> F, F_rate;
  double end;
  std::vector<double> turns = {};                        ///< times before `end` at which the path turns back
  Eigen::Vector3d direction = Eigen::Vector3d(1, 0, 0);  ///< of a material that has one
};

inline Tensor cross_matrix(const Eigen::Vector3d& a) {
  Tensor K;
  K << 0, -a(2), a(1), a(2), 0, -a(0), -a(1), a(0), 0;
  return K;
}

/// Rotation by `angle` about the axis (1, 2, 3).
inline Tensor turn(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
}

/// gamma = peak sin(2 pi t), F21 = gamma: loading, unloading, reversal.
inline History cyclic_shear(double peak, double end = 0.9) {
  const double w = 2 * std::numbers::pi;
  return {[=](double t) {
            Tensor F = Tensor::Identity();
            F(1, 0) = peak * std::sin(w * t);
            return F;
          },
          [=](double t) {
            Tensor rate = Tensor::Zero();
            rate(1, 0) = peak * w * std::cos(w * t);
            return rate;
          },
          end};
}

/// F = Q(t) U(t): rotation about (1, 2, 3) by 1.3 sin 2t, and stretches of the given size along turning axes.
inline History stretch_and_rotation(double size, double end = 1.1) {
  Tensor A, B;
  A << 1, 0.4, -0.3, 0.4, -0.5, 0.2, -0.3, 0.2, 0.3;
  B << -0.2, 0.5, 0.1, 0.5, 0.6, -0.4, 0.1, -0.4, -0.3;
  const Tensor K = cross_matrix(Eigen::Vector3d(1, 2, 3).normalized());
  const auto U = [=](double t) { return Tensor(Tensor::Identity() + size * (std::sin(3 * t) * A + t * t * B)); };
  const auto U_rate = [=](double t) { return Tensor(size * (3 * std::cos(3 * t) * A + 2 * t * B)); };
  const auto Q = [](double t) { return turn(1.3 * std::sin(2 * t)); };
  return {[=](double t) { return Tensor(Q(t) * U(t)); },
          [=](double t) { return Tensor(2.6 * std::cos(2 * t) * K * Q(t) * U(t) + Q(t) * U_rate(t)); }, end};
}

/// The same history seen from a frame that turns by `angle(t)` about (1, 2, 3).
inline std::function<Tensor(double)> seen_turning(const History& history, const std::function<double(double)>& angle) {
  return [=](double t) { return Tensor(turn(angle(t)) * history.F(t)); };
}

using Parameters = std::map<std::string, double>;

inline Material material_of(const std::string& name, const Parameters& parameters) {
  return Material(adapters::builtin_table(name), parameters);
}

struct Point {
  Tensor cauchy = Tensor::Zero();
  std::vector<double> state;
};

inline void nine(const Tensor& A, double* out) {
  for (int c = 0; c < 9; ++c) out[c] = A(c / 3, c % 3);
}

inline Tensor tensor_of(const double* nine_components) {
  Tensor A;
  for (int c = 0; c < 9; ++c) A(c / 3, c % 3) = nine_components[c];
  return A;
}

/// One step of one point. Throws std::runtime_error where the material fails.
inline Point point_after(const Material& material, double t, double dt, const Tensor& F0, const Tensor& F1,
                         const std::vector<double>& state0) {
  double f0[9], f1[9], sigma[9];
  nine(F0, f0), nine(F1, f1);
  Point end{Tensor::Zero(), std::vector<double>(state0.size())};
  const UpdateReport report = material.update(t, dt, 1, f0, f1, state0.data(), end.state.data(), sigma);
  if (report.worst == ASSAY_FAILED) throw std::runtime_error(report.message);
  end.cauchy = tensor_of(sigma);
  return end;
}

/// N equal steps from rest.
inline Point marched(const Material& material, const std::function<Tensor(double)>& F, double end, int steps) {
  Point now{Tensor::Zero(), material.initial_state(1)};
  for (int i = 0; i < steps; ++i) {
    const double t0 = end * i / steps, t1 = end * (i + 1) / steps;
    now = point_after(material, t0, t1 - t0, F(t0), F(t1), now.state);
  }
  return now;
}

inline double difference(const Tensor& A, const Tensor& B) { return (A - B).cwiseAbs().maxCoeff(); }

/// Largest error at the end relative to the largest component, after N, 2N, 4N, ... steps.
inline std::vector<double> errors_under_refinement(const Material& material, const History& history,
                                                   const Tensor& exact, int steps, int levels) {
  std::vector<double> errors;
  for (int k = 0; k < levels; ++k, steps *= 2) {
    const Tensor found = marched(material, history.F, history.end, steps).cauchy;
    errors.push_back(difference(found, exact) / exact.cwiseAbs().maxCoeff());
  }
  return errors;
}

/// Mean slope of log2(error) over the levels.
inline double order_of(const std::vector<double>& errors) {
  return std::log2(errors.front() / errors.back()) / static_cast<double>(errors.size() - 1);
}

}  // namespace assay::model_tests
