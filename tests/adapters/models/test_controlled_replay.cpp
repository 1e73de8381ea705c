// SPDX-License-Identifier: BSD-3-Clause
// A path by strain, and again by the stress that it gave: for every built-in model.
#include <gtest/gtest.h>

#include <map>
#include <memory>

#include "adapters/builtin.hpp"
#include "harness/history/history.hpp"
#include "tests/harness/control/control_rows.hpp"

namespace assay::test_controlled_replay {
namespace {

constexpr double tolerance = 1e-8;  ///< of the strain that is found again, and of the largest stress

/// ln U along a path that is neither straight nor of one rate.
Tensor strain_at(double t) {
  Tensor e = Tensor::Zero();
  e(0, 0) = 0.03 * t;
  e(1, 1) = -0.012 * t * t;
  e(2, 2) = 0.004 * t;
  e(0, 1) = e(1, 0) = 0.02 * t * t;
  e(1, 2) = e(2, 1) = -0.006 * t;
  return e;
}

Path path_of_strain() {
  Path path;
  path.name = "table";
  path.parameter = {0, 1};
  path.curved = [](double xi, double t) {
    constexpr double h = 1e-6;
    const auto F = [&](double at) {
      return gradient_of(Deformation::logarithmic_strain, {}, {}, Tensor(xi * strain_at(at)));
    };
    return PathPoint{F(t), (F(t + h) - F(t - h)) / (2 * h)};
  };
  path.reversals = [](double) { return std::vector<double>(); };
  return path;
}

/// The Kirchhoff stress of the path by strain at any time, by the engine of histories. What was asked for is kept.
class StressAlong {
 public:
  StressAlong(const Material& material, const Path& path) : course_(material, path, 1, Form::increments) {
    kept_.emplace(0.0, std::make_unique<History>(course_, 1.0, HistoryOptions{.watch = true}));
  }
  Tensor at(double t) {
    const auto before = std::prev(kept_.upper_bound(t));
    if (before->first == t) return stress(*before->second, t);
    auto further = before->second->copy();
    further->advance(t);
    return stress(*kept_.emplace(t, std::move(further)).first->second, t);
  }

 private:
  static Tensor stress(const History& history, double t) { return std::exp(strain_at(t).trace()) * history.cauchy(); }
  Course course_;
  std::map<double, std::unique_ptr<History>> kept_;
};

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const assay_material* table : adapters::builtin_tables()) all.emplace_back(table->name);
  return all;
}

class Replay : public testing::TestWithParam<std::string> {};

/// Every component of the stress of a solid; of a fluid, whose shear stress depends on the rate alone, too.
TEST_P(Replay, FindsTheStrainAgain) {
  const assay_material* table = adapters::builtin_table(GetParam());
  const auto* example = static_cast<const assay_example*>(extension_of(table, ASSAY_EXTENSION_EXAMPLE));
  std::map<std::string, double> parameters;
  for (std::uint32_t k = 0; k < table->parameter_count; ++k)
    parameters[table->parameters[k].name] = example ? example->parameters[k] : table->parameters[k].default_value;
  const Material material(table, parameters);
  const Path path = path_of_strain();
  StressAlong stress(material, path);
  Control control = control_of(Deformation::logarithmic_strain, StressMeasure::kirchhoff, {});
  for (const char* ij : {"11", "22", "33", "12", "13", "23"}) {
    const int i = ij[0] - '1', j = ij[1] - '1';
    control.rows.push_back(stress_row(ij, [&stress, i, j](double t) { return t == 0 ? 0.0 : stress.at(t)(i, j); }));
  }
  const auto found = follow_control(material, control, even_times(1, 5));
  ASSERT_EQ(found.outcome, ControlOutcome::completed) << found.reason << " at " << found.rows.back().t;
  const double largest = found.rows.back().s.cwiseAbs().maxCoeff();
  for (const ControlledRow& row : found.rows) {
    EXPECT_LT((row.q - strain_at(row.t)).cwiseAbs().maxCoeff(), tolerance) << row.t;
    if (row.t == 0) continue;
    EXPECT_LT((row.s - stress.at(row.t)).cwiseAbs().maxCoeff(), tolerance * largest) << row.t;
  }
}

INSTANTIATE_TEST_SUITE_P(Controlled, Replay, testing::ValuesIn(names()), [](const auto& each) { return each.param; });

}  // namespace
}  // namespace assay::test_controlled_replay
