// SPDX-License-Identifier: BSD-3-Clause
// Steps of one point of a test double.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "adapters/foreign/foreign_table.hpp"
#include "harness/material/material.hpp"
#include "harness/numeric/tensor.hpp"
#include "tests/adapters/foreign/foreign_doubles.hpp"

namespace assay::adapters {

struct StepEnd {
  Tensor cauchy;
  std::vector<double> state;
  UpdateReport report;
};

class StepsOfOnePoint {
 public:
  explicit StepsOfOnePoint(const ForeignModel& model, const std::map<std::string, double>& properties = {})
      : material(foreign_table(model), properties), state(material.initial_state(1)) {}

  /// From the present state, which stays.
  StepEnd tried(double t, double dt, const Tensor& F0, const Tensor& F1) const {
    double begin[9], end[9], cauchy[9];
    for (int c = 0; c < 9; ++c) begin[c] = component(F0, c), end[c] = component(F1, c);
    StepEnd found{Tensor::Zero(), std::vector<double>(state.size()), {}};
    found.report = material.update(t, dt, 1, begin, end, state.data(), found.state.data(), cauchy);
    for (int c = 0; c < 9; ++c) component(found.cauchy, c) = cauchy[c];
    return found;
  }
  /// The same; its end is the next beginning.
  StepEnd taken(double t, double dt, const Tensor& F0, const Tensor& F1) {
    StepEnd found = tried(t, dt, F0, F1);
    EXPECT_EQ(found.report.worst, ASSAY_GOOD) << found.report.message;
    state = found.state;
    return found;
  }
  /// 9 x 9; row: component of the stress, column: of F1.
  std::vector<double> tangent(double t, double dt, const Tensor& F0, const Tensor& F1) const {
    double begin[9], end[9];
    for (int c = 0; c < 9; ++c) begin[c] = component(F0, c), end[c] = component(F1, c);
    const assay_step step{t, dt, begin, end};
    std::vector<double> found(81);
    const auto* offered = material.extension<assay_tangent>(ASSAY_EXTENSION_TANGENT);
    EXPECT_EQ(offered->tangent(material.self(), &step, 1, state.data(), found.data()), ASSAY_GOOD);
    return found;
  }

  Material material;
  std::vector<double> state;
};

}  // namespace assay::adapters
