// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>
#include <unistd.h>

#include "adapters/foreign/foreign_table.hpp"
#include "adapters/worker/remote_table.hpp"
#include "harness/exact/response.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "tests/adapters/foreign/foreign_doubles.hpp"
#include "tests/support/wait.hpp"

namespace assay::adapters::test_remote_histories {
namespace {

const Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.02, 1.0}}.baseline();
constexpr double end = 0.8;
const std::vector<double> times{0.01, 0.2, 0.55, end};
const HistoryOptions options{.tolerance = 1e-9, .watch = true};

std::string j2() {
  return "library: " + double_library("umat_j2") +
         "\ninterface: umat\nname: umat_j2\nproperties: {E: 1.0e3, nu: 0.3, yield: 5, isotropic: 0, kinematic: 50}\n"
         "state: {back_stress: symmetric_tensor, p: scalar}\nflags: [non_smooth]\n";
}

std::string misbehaving(int which) {
  return "library: " + double_library("misbehaving_umat") + "\ninterface: umat\nname: misbehaving\n" +
         "properties: {E: 1.0e3, nu: 0.3, which: " + std::to_string(which) + ", from: 0.3}\nstate: 1\n";
}

class RemoteHistories : public testing::Test {
 protected:
  void SetUp() override {
    if (!double_exists("umat_j2")) GTEST_SKIP() << "no Fortran compiler";
  }
  void TearDown() override { end_workers(); }

  /// With workers of its own.
  static Material apart(const std::string& description, double seconds = 20) {
    WorkerStart start{"model\ntest.yaml\n" + description};
    start.limits.seconds = seconds;
    return Material(remote_table(start), {});
  }
  static Material here() {
    ForeignModel model = foreign_double("umat_j2");
    for (std::size_t k = 2; k < 5; ++k) model.properties[k].value = std::array{5, 0, 50}[k - 2];
    return Material(foreign_table(model), {});
  }
};
using LongRemoteHistories = RemoteHistories;

TEST_F(RemoteHistories, AreTheBitsOfHistoriesHereAndTakeOneHandOverEach) {
  const Material there = apart(j2()), model = here();
  const Course remote(there, path, end), local(model, path, end);
  ASSERT_TRUE(remote.elsewhere && !local.elsewhere);
  EXPECT_EQ(remote.scales.state, local.scales.state);
  EXPECT_EQ(marks_of(&there.table()).hand_overs, 1) << "the coarse march";
  std::int64_t calls = 0;
  for (const double xi : {-3.2, -0.4, 0.05, 2.1}) {
    const HistoryTrail expected = follow(local, xi, options, times), found = follow(remote, xi, options, times);
    EXPECT_EQ(found.rows, expected.rows) << xi;
    EXPECT_EQ(found.calls, expected.calls) << xi;
    ASSERT_EQ(found.branches.size(), expected.branches.size()) << xi;
    for (std::size_t k = 0; k < found.branches.size(); ++k) {
      EXPECT_EQ(found.branches[k].begin, expected.branches[k].begin) << xi;
    }
    calls += found.calls;
  }
  EXPECT_GT(calls, 3000);
  EXPECT_EQ(marks_of(&there.table()).hand_overs, 5);
  EXPECT_LE(marks_of(&there.table()).wake_ups, 2 * (5 + 3)) << "one a side, for these, metadata and instance";
}

TEST_F(RemoteHistories, GoOnTogetherInOneHandOver) {
  const Material there = apart(j2()), model = here();
  const Course remote(there, path, end), local(model, path, end);
  const std::vector<double> xi{-3.2, -0.4, 0.05, 2.1};
  Troop expected(local, xi, options), found(remote, xi, options);
  const std::int64_t before = marks_of(&there.table()).hand_overs;
  for (const double t : times) {
    expected.advance(t);
    found.advance(t);
    for (std::size_t k = 0; k < xi.size(); ++k) {
      EXPECT_EQ(found.tau(k), expected.tau(k)) << xi[k] << " at " << t;
      EXPECT_EQ(found.branches(k).size(), expected.branches(k).size()) << xi[k] << " at " << t;
    }
  }
  EXPECT_EQ(found.calls(), expected.calls());
  EXPECT_EQ(found.error(), expected.error());
  EXPECT_EQ(marks_of(&there.table()).hand_overs - before, static_cast<std::int64_t>(times.size()));
}

/// Each thread's share lives in a worker of its own.
TEST_F(RemoteHistories, OfShadowPointsDoNotDependOnTheNumberOfThreads) {
  const auto there = std::make_shared<const Material>(apart(j2()));
  Shadow one(there, path, {.radii = 7, .tolerance = 1e-6, .end = end}),
      two(there, path, {.radii = 7, .tolerance = 1e-6, .end = end, .workers = {2}});
  for (const double t : times) {
    one.advance(t);
    two.advance(t);
    for (const double xi : {-3.0, -0.2, 0.3, 2.5}) {
      Tensor tau, slope, other_tau, other_slope;
      one.curve()->at(xi, tau, slope);
      two.curve()->at(xi, other_tau, other_slope);
      EXPECT_EQ(tau, other_tau) << xi << " at " << t;
    }
  }
  EXPECT_EQ(one.calls(), two.calls());
}

struct Misdeed {
  int which;
  const char* words;
  bool final = true;    ///< no shorter step would do
  double limit_s = 20;  ///< of a call: a stack of 8 MB takes its time on a machine that is busy
};

class HistoryOfMisdeeds : public RemoteHistories, public testing::WithParamInterface<Misdeed> {};

TEST_P(HistoryOfMisdeeds, TellsTheStep) {
  const Material material = apart(misbehaving(GetParam().which), GetParam().limit_s);
  const Course course(material, path, 0.2);  // good so far
  const auto failure_of = [&](double xi, const auto& go) -> std::optional<MaterialFailure> {
    try {
      go(xi);
    } catch (const MaterialFailure& failure) {
      return failure;
    }
    return std::nullopt;
  };
  CourseFacts facts = course;
  facts.end = 1;
  const Course longer(material, path, facts);
  const auto alone = failure_of(1.7, [&](double xi) { follow(longer, xi, options, times); });
  const auto among = failure_of(1.7, [&](double xi) {
    Troop troop(longer, {-2.0, xi, 0.3}, options);
    troop.advance(0.1);
    troop.advance(end);
  });
  for (const auto& [failure, xi] : {std::pair(alone, 1.7), std::pair(among, -2.0)}) {
    ASSERT_TRUE(failure);
    EXPECT_NE(std::string(failure->what()).find(GetParam().words), std::string::npos) << failure->what();
    EXPECT_EQ(failure->final, GetParam().final);
    EXPECT_EQ(failure->xi, xi);
    ASSERT_TRUE(failure->step);
    EXPECT_GE(failure->step->t + failure->step->dt, 0.3 - 1e-9);
    EXPECT_LT((failure->step->F1 - path.deformation_gradient(xi, failure->step->t + failure->step->dt)).norm(), 1e-12);
    EXPECT_EQ(failure->step->state0.size(), material.state_size());
    EXPECT_GT(failure->step->state0[15], 0) << "the clock of the loaded point";
  }
  EXPECT_EQ(follow(course, 1.7, options, std::array{0.2}).rows.size(), 9 + material.state_size()) << "a new worker";
}

INSTANTIATE_TEST_SUITE_P(Kinds, HistoryOfMisdeeds,
                         testing::Values(Misdeed{1, "was ended by signal 11"},
                                         Misdeed{2, "ended the process with status 0, without a result"},
                                         Misdeed{3, "did not return within 0.5 s", true, 0.5},
                                         Misdeed{5, "the stack overflowed"}, Misdeed{10, "changes the rounding mode"},
                                         Misdeed{14, "called XIT", false},
                                         Misdeed{22, "did not return within 0.5 s", true, 0.5}),
                         [](const auto& instance) { return "number_" + std::to_string(instance.param.which); });

/// What a model writes past its own arrays ends one step, as elsewhere: shorter ones are tried.
TEST_F(RemoteHistories, TellOfOverruns) {
  const Material material = apart(misbehaving(11));
  try {
    const Course course(material, path, end);
    follow(course, 1.7, options, times);
    ADD_FAILURE() << "went through";
  } catch (const MaterialFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("writes past STATEV"), std::string::npos) << failure.what();
  }
}

/// The limit of time is that of a call: 10 ms each here, and many of them.
TEST_F(LongRemoteHistories, MayTakeLongerThanACall) {
  constexpr double limit_s = 1;
  const Material material = apart(misbehaving(30), limit_s);
  const Stopwatch watch;
  const Course course(material, path, end);
  EXPECT_GT(watch.seconds(), limit_s);
}

}  // namespace
}  // namespace assay::adapters::test_remote_histories
