// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_foreign.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "harness/check/battery.hpp"
#include "tests/harness/check/model_table.hpp"
#include "tests/support/built.hpp"
#include "tests/support/wait.hpp"

namespace assay::drivers::test_check_elsewhere {
namespace {

enum Habit : int { none, keeps_the_first, crashes_first, never_comes_back, digit_of_the_process };

const ::pid_t tester = ::getpid();
bool called = false;
double kept = 0;

/// A spring whose stiffness may be that of the first stretch that it sees.
struct Spring {
  static constexpr std::size_t state_size = 0;
  int habit;
  explicit Spring(const double* p) : habit(static_cast<int>(p[0])) {}

  std::optional<Tensor> take(const check_tests::PointStep& step, const double*, double*) const {
    const bool first = !std::exchange(called, true);
    const double J = step.F1.determinant();
    if (!(J > 0)) return std::nullopt;
    if (first) kept = J;
    if (first && habit == crashes_first) ::kill(::getpid(), SIGKILL);
    while (habit == never_comes_back) ::pause();
    const double digit = habit == digit_of_the_process && ::getpid() != tester ? 1 + 2.3e-16 : 1;
    const Tensor b = step.F1 * step.F1.transpose();
    return ((habit == keeps_the_first ? kept : 1) * (b - Tensor::Identity()) + std::log(J) * Tensor::Identity()) / J *
           digit;
  }
  bool rest(const Tensor&, double*) const { return true; }
  void misbehave(std::size_t, double*, double*) const {}
};

Material spring(Habit habit) {
  static const assay_parameter parameters[] = {{"habit", "1", 0, 0, 4, "which"}};
  static const assay_material table = check_tests::table_of<Spring>("spring_for_tests", 0, parameters, {});
  called = false;
  return {&table, {{"habit", habit}}};
}

check::Report battery_with_elsewhere(Habit habit) {
  const Material material = spring(habit);
  check::Options options;
  options.elsewhere = history_elsewhere(material, options.effort);
  EXPECT_FALSE(options.elsewhere.empty());
  return check::run_battery(material, options);
}

TEST(CheckElsewhere, NamesWhatIsKeptOfTheFirstCall) {
  const check::Report right = battery_with_elsewhere(none), wrong = battery_with_elsewhere(keeps_the_first);
  EXPECT_TRUE(right.passes()) << right.diagnosis.front().sentence;
  ASSERT_FALSE(wrong.passes());
  EXPECT_EQ(wrong.diagnosis.front().cause, check::causes::hidden_state);
  EXPECT_NE(wrong.diagnosis.front().sentence.find("another process"), std::string::npos);
}

TEST(CheckElsewhere, NamesWhatDiffersInTheLastDigitsOfAnotherProcess) {
  const check::Report wrong = battery_with_elsewhere(digit_of_the_process);
  ASSERT_FALSE(wrong.passes());
  EXPECT_EQ(wrong.diagnosis.front().cause, check::causes::not_reproducible);
  EXPECT_NE(wrong.diagnosis.front().sentence.find("another process"), std::string::npos);
}

ResolvedMaterial library(const std::string& file) {
  MaterialChoice choice;
  choice.adapter = built() + file;
  choice.density = 1000;
  return resolve_material(choice, Example::all);
}

TEST(CheckElsewhere, NamesWhatIsKeptOfTheFirstInstance) {
  const ResolvedMaterial wrong = library("/tests/plugins/first_instance.so");
  check::Options options;
  options.only = "calls.repeated";
  const auto verdict_with = [&](const check::History& others) {
    options.others_elsewhere = others;
    const check::Report report = check::run_battery(wrong.material, options);
    return report.diagnosis.empty() ? std::string() : report.diagnosis.front().sentence;
  };
  EXPECT_EQ(verdict_with({}).find("of an instance of other parameters"), std::string::npos);
  EXPECT_NE(verdict_with(history_of_others(wrong, {})).find("of an instance of other parameters"), std::string::npos);
}

TEST(CheckElsewhere, LoadsACopyOfAnyLibraryAndOfNothingElse) {
  EXPECT_FALSE(history_of_others(library("/materials/libneo_hookean.so"), {}).empty());
  MaterialChoice built_in;
  built_in.adapter = "zener";
  built_in.density = 1000;
  EXPECT_TRUE(history_of_others(resolve_material(built_in, Example::all), {}).empty());
}

TEST(CheckElsewhere, IsTheSameHistoryToTheLastBit) {
  const Material material = spring(none);
  const check::Effort effort;
  EXPECT_EQ(history_elsewhere(material, effort), check::history(material, check::amplitudes_of_first(effort).back()));
}

TEST(CheckElsewhere, IsEmptyWhereTheOtherProcessEndsOrHangs) {
  EXPECT_TRUE(history_elsewhere(spring(crashes_first), {}).empty());
  const Stopwatch watch;
  EXPECT_TRUE(history_elsewhere(spring(never_comes_back), {}, 0.2).empty());
  EXPECT_LT(watch.seconds(), nobody_waited_s);
}

}  // namespace
}  // namespace assay::drivers::test_check_elsewhere
