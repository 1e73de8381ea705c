// SPDX-License-Identifier: BSD-3-Clause
// UEXTERNALDB and SDVINI, which the host calls where a library has them, and what models call in return: in a worker,
// which finds the companion library beside the program.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "adapters/worker/remote_table.hpp"
#include "harness/material/material.hpp"
#include "tests/adapters/foreign/foreign_doubles.hpp"
#include "tests/support/wait.hpp"

namespace assay::adapters::test_callbacks {
namespace {

enum Deed { nothing = 0, sdvini_overruns = 1, sdvini_exits = 2, ends_with_a_lock = 3, reports_errors = 4 };
constexpr std::size_t deed = 16, beginnings = 17, of_sdvini = 18;  // after UMAT's own state

class Callbacks : public testing::Test {
 protected:
  void make(Deed what) {
    WorkerStart start{"model\ntest.yaml\nlibrary: " + double_library("umat_callbacks") +
                      "\ninterface: umat\nname: callbacks\nstate: {deed: {initial: " + std::to_string(what) +
                      "}, beginnings: scalar, of_sdvini: scalar}\n"};
    start.limits.seconds = 2;
    material_ = std::make_unique<Material>(remote_table(start), std::map<std::string, double>{});
    state_ = material_->initial_state(1);
  }
  void TearDown() override { end_workers(); }

  UpdateReport stretch(double by) {
    const double F0[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, F1[9] = {by, 0, 0, 0, 1, 0, 0, 0, 1};
    after_.resize(state_.size());
    return material_->update(0, 0.1, 1, F0, F1, state_.data(), after_.data(), cauchy_);
  }

  std::string refusal(Deed what) {
    try {
      make(what);
      return "accepted";
    } catch (const std::exception& error) {
      return error.what();
    }
  }

  std::unique_ptr<Material> material_;
  std::vector<double> state_, after_;
  double cauchy_[9] = {};
};

TEST_F(Callbacks, SdviniWritesTheInitialState) {
  make(nothing);
  EXPECT_EQ(state_[deed], nothing);
  EXPECT_EQ(state_[of_sdvini], 3113) << "three coordinates, the first element and point, three state variables";
}

TEST_F(Callbacks, TheBeginningOfTheAnalysisIsToldOnce) {
  make(nothing);
  for (int k = 0; k < 3; ++k) {
    ASSERT_EQ(stretch(1.01).worst, ASSAY_GOOD);
    EXPECT_EQ(after_[beginnings], 1);
  }
  constexpr double modulus = 1e3, rounding = 1e-12;  // of the double; of a logarithm
  EXPECT_NEAR(cauchy_[0], modulus * std::log(1.01), rounding);
}

TEST_F(Callbacks, AnOverrunBySdviniIsNamed) {
  const std::string found = refusal(sdvini_overruns);
  EXPECT_NE(found.find("SDVINI writes past STATEV, which has 3 components"), std::string::npos) << found;
}

TEST_F(Callbacks, AnExitInSdviniIsNamed) {
  const std::string found = refusal(sdvini_exits);
  EXPECT_NE(found.find("SDVINI called XIT"), std::string::npos) << found;
}

TEST_F(Callbacks, ACallThatEndsWithALockLeavesNone) {
  make(ends_with_a_lock);
  for (int k = 0; k < 3; ++k) {
    const Stopwatch watch;
    const UpdateReport failed = stretch(2);
    EXPECT_EQ(failed.worst, ASSAY_FAILED);
    EXPECT_NE(failed.message.find("called XIT"), std::string::npos) << failed.message;
    EXPECT_EQ(stretch(1.01).worst, ASSAY_GOOD);
    EXPECT_LT(watch.seconds(), nobody_waited_s) << "nobody waited";
  }
}

TEST_F(Callbacks, AnErrorThatEndsTheAnalysisIsTheCause) {
  make(reports_errors);
  const UpdateReport failed = stretch(2);
  EXPECT_EQ(failed.worst, ASSAY_FAILED);
  EXPECT_NE(failed.message.find("reported an error that ends the analysis: strain 0.693147 in call 7 of callback"),
            std::string::npos)
      << failed.message;
  EXPECT_EQ(stretch(1.01).worst, ASSAY_GOOD);
}

}  // namespace
}  // namespace assay::adapters::test_callbacks
