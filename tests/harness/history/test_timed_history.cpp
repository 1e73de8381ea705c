// SPDX-License-Identifier: BSD-3-Clause
// A history that is a function of time alone.
#include "harness/history/timed_history.hpp"

#include <gtest/gtest.h>

#include "harness/motion/kinds/vortex.hpp"
#include "harness/motion/motion.hpp"
#include "tests/harness/builtin_material.hpp"

namespace assay::test_timed_history {
namespace {

constexpr double end = 2, xi = 0.8, panel = 1.0 / 16;
constexpr double of_history = 1e-9;  ///< relative: what two ways of stepping differ by

struct Model {
  const char* name;
  std::shared_ptr<const Material> material;
};

/// By a rate, by increments, with kinks.
std::vector<Model> models() {
  return {
      {"zener", builtin_material(assay_builtin_zener, {{"E", 1e4}, {"nu", 0.3}, {"relaxation_time", 0.1}})},
      {"hypoelastic", builtin_material(assay_builtin_hypoelastic_green_naghdi, {{"E", 1e4}, {"nu", 0.3}})},
      {"j2", builtin_material(assay_builtin_j2_jaumann,
                              {{"E", 1e6}, {"nu", 0.3}, {"yield_stress", 1.5e4}, {"hardening_modulus", 1e5}})},
  };
}

TEST(TimedHistory, DoesNotDependOnTheTimesThatWereAskedBefore) {
  for (const Model& model : models()) {
    const Path path = Motion(Vortex{.amplitude = {Amplitude::Type::sine, 0.2, 1}})->baseline();
    const Course course(*model.material, path, end);
    const HistoryOptions options{.watch = model.material->has(ASSAY_NON_SMOOTH)};
    for (const bool keeps_all : {true, false}) {
      TimedHistory asked(course, xi, options, panel, keeps_all);
      for (const double t : {1.3, 0.1, 0.101, 2.0, 0.0, 1.3, 0.5, 1.999}) {
        TimedHistory fresh(course, xi, options, panel, !keeps_all);
        EXPECT_EQ(nine_of(asked.tau(t)), nine_of(fresh.tau(t))) << model.name << " at " << t;
      }
    }
  }
}

TEST(TimedHistory, IsTheHistory) {
  for (const Model& model : models()) {
    const Path path = Motion(Vortex{.amplitude = {Amplitude::Type::sine, 0.2, 1}})->baseline();
    const Course course(*model.material, path, end);
    const HistoryOptions options{.watch = model.material->has(ASSAY_NON_SMOOTH)};
    TimedHistory asked(course, xi, options, panel, true);
    History whole(course, xi, options);
    for (const double t : {0.03, 0.25, 0.9, 1.77, 2.0}) {
      whole.advance(t);
      const Tensor expected = whole.tau();
      EXPECT_LT((asked.tau(t) - expected).norm(), of_history * course.scales.cauchy) << model.name << " at " << t;
    }
    EXPECT_GT(asked.calls(), 0);
  }
}

/// A copy goes on as what it was made from would have, to the last bit.
TEST(History, ACopyGoesOnByItself) {
  for (const Model& model : models()) {
    const Path path = Motion(Vortex{.amplitude = {Amplitude::Type::sine, 0.2, 1}})->baseline();
    const Course course(*model.material, path, end);
    History one(course, xi, {.watch = model.material->has(ASSAY_NON_SMOOTH)});
    one.advance(0.3);
    const auto other = one.copy();
    one.advance(1.1);
    EXPECT_EQ(other->t(), 0.3) << model.name;
    other->advance(1.1);
    EXPECT_EQ(nine_of(one.tau()), nine_of(other->tau())) << model.name;
  }
}

}  // namespace
}  // namespace assay::test_timed_history
