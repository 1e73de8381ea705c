// SPDX-License-Identifier: BSD-3-Clause
#include "harness/history/history_task.hpp"

#include <gtest/gtest.h>

#include "harness/motion/kinds/vortex.hpp"
#include "tests/harness/builtin_material.hpp"
#include "tests/harness/jaumann_material.hpp"

namespace assay::test_history_task {
namespace {

const Path cyclic = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.1, 1.0}}.baseline();
constexpr double end = 1.2, xi = -2.1;
const std::vector<double> times{0, 0.05, 0.3, 0.3, 0.71, end};
const HistoryOptions options{.tolerance = 1e-11, .watch = true};

const std::map<std::string, double> plastic{{"E", 1000}, {"nu", 0.3}, {"yield_stress", 5}, {"kinematic_modulus", 50}};

std::shared_ptr<const Material> j2() { return builtin_material(assay_builtin_j2_jaumann, plastic); }

std::size_t width() { return 9 + j2()->state_size(); }

/// As it comes back from a process of its own.
HistoryTrail taken_elsewhere(const Course& course) {
  HistoryTasks tasks(j2()->clone());
  return trail_in(tasks.answer(follow_task(course, xi, options, times)), times.size(), width());
}

TEST(HistoryTask, GivesTheBitsOfTheSameHistoryHere) {
  const auto material = j2();
  Path narrower = cyclic;  // than the motion makes it: a recipe says nothing of that
  narrower.parameter = {-2.5, 2.5};
  const Course course(*material, narrower, end);
  const HistoryTrail here = follow_here(course, xi, options, times), there = taken_elsewhere(course);
  EXPECT_EQ(there.rows, here.rows);
  EXPECT_EQ(there.calls, here.calls);
  EXPECT_EQ(there.error, here.error);
  ASSERT_EQ(there.branches.size(), here.branches.size());
  EXPECT_GE(here.branches.size(), 4u);
  for (std::size_t k = 0; k < here.branches.size(); ++k) {
    EXPECT_EQ(there.branches[k].begin, here.branches[k].begin);
    EXPECT_EQ(there.branches[k].regime, here.branches[k].regime);
  }
}

TEST(HistoryTask, GivesTheCoarseMarch) {
  const auto material = j2();
  HistoryTasks tasks(material->clone());
  const CoarseMarch here = march_coarsely(*material, cyclic, end),
                    there = coarse_march_in(tasks.answer(coarse_task(cyclic, end)), material->state_size(),
                                            material->table().state_count);
  EXPECT_EQ(there.largest, here.largest);
  EXPECT_EQ(there.signs.changes, here.signs.changes);
  EXPECT_EQ(there.signs.always, here.signs.always);
  EXPECT_GT(here.largest[1], 0);
}

/// It stands no shear beyond 0.1.
TEST(HistoryTask, CarriesAFailureWithItsStep) {
  const auto material = jaumann_material(0.1);
  const Course course(*material, cyclic, end);
  HistoryTasks tasks(material->clone());
  const auto failure_of = [](const auto& taken) -> std::optional<MaterialFailure> {
    try {
      taken();
    } catch (const MaterialFailure& failure) {
      return failure;
    }
    return std::nullopt;
  };
  const auto here = failure_of([&] { follow_here(course, xi, options, times); });
  const auto there = failure_of([&] {
    trail_in(tasks.answer(follow_task(course, xi, options, times)), times.size(), 9 + material->state_size());
  });
  ASSERT_TRUE(here && there);
  EXPECT_STREQ(there->what(), here->what());
  EXPECT_EQ(there->t, here->t);
  EXPECT_EQ(there->xi, here->xi);
  EXPECT_EQ(there->final, here->final);
  EXPECT_EQ(there->too_accurate, here->too_accurate);
  ASSERT_TRUE(here->step && there->step);
  EXPECT_EQ(there->step->F1, here->step->F1);
  EXPECT_EQ(there->step->state0, here->step->state0);
}

TEST(HistoryTask, TakesNoAnswerThatIsNone) {
  const auto material = j2();
  const Course course(*material, cyclic, end);
  HistoryTasks tasks(material->clone());
  const std::vector<double> answer = tasks.answer(follow_task(course, xi, options, times));
  for (std::size_t length = 0; length < answer.size(); length += 7) {
    EXPECT_THROW(trail_in(std::span<const double>(answer).first(length), times.size(), width()), std::runtime_error)
        << length;
  }
  EXPECT_THROW(trail_in(answer, times.size() + 1, width()), std::runtime_error);
  EXPECT_THROW(trail_in(answer, times.size(), width() + 1), std::runtime_error);
  EXPECT_THROW(trail_in(tasks.answer({}), times.size(), width()), std::runtime_error) << "a task that is none";
}

}  // namespace
}  // namespace assay::test_history_task
