// SPDX-License-Identifier: BSD-3-Clause
// From made-up verdicts to causes: a cause is of the size of what it explains, and shuts out what follows from it.
#include "harness/check/diagnosis.hpp"

#include <gtest/gtest.h>

namespace assay::check::test_diagnosis {
namespace {

TestResult failed(const std::string& id, double measure, const std::string& cause = "") {
  return {.id = id, .verdict = Verdict::fail, .measure = measure, .threshold = 0, .cause = cause, .sentence = id};
}

/// A state that stays where it was when the body turns.
Evidence left_behind() {
  Evidence evidence;
  evidence.turned.emplace();
  evidence.turned->carried.push_back({"back_stress", false, Turned::not_at_all, 0});
  evidence.turned->taken.push_back({"back_stress", false, Turned::rightly, 1});
  return evidence;
}

std::vector<std::string> causes_of(std::vector<TestResult> tests, const Evidence& evidence = {}) {
  std::vector<std::string> found;
  for (const Diagnosis& d : diagnose(tests, evidence)) found.push_back(d.cause);
  return found;
}

TEST(Diagnosis, ACauseIsOfTheSizeOfWhatItExplains) {
  const std::vector<TestResult> small{failed("rotation.constant", 4e-5, causes::shear_factor),
                                      failed("rotation.during", 2e-2)};
  EXPECT_EQ(causes_of(small, left_behind()).front(), causes::state_not_rotated);
  const std::vector<TestResult> large{failed("rotation.constant", 1e-2, causes::shear_factor),
                                      failed("rotation.during", 2e-2)};
  EXPECT_EQ(causes_of(large, left_behind()).front(), causes::shear_factor);
}

TEST(Diagnosis, ASmallCauseIsSaidAfterALargeOne) {
  const auto found = causes_of(
      {failed("elasticity.shear", 2e-3, causes::not_isotropic), failed("rotation.during", 2e-1)}, left_behind());
  EXPECT_EQ(found, (std::vector<std::string>{causes::state_not_rotated, causes::not_isotropic}));
}

TEST(Diagnosis, WhatFollowsFromTheClockIsNotNamed) {
  const std::vector<TestResult> tests{failed("clock", 1, causes::clock), failed("zero_increment", 1, causes::drifts),
                                      failed("dissipation", 1, causes::dissipation),
                                      failed("rotation.constant", 0.3, causes::rotation_missing)};
  EXPECT_EQ(causes_of(tests), (std::vector<std::string>{causes::clock, causes::rotation_missing}));
}

TEST(Diagnosis, AStrainOfItsOwnExplainsStressAtRestAndInTime) {
  Evidence evidence;
  evidence.grows_at_rest = true;
  evidence.growth_declaration = "flags: [grows]";
  std::vector<TestResult> tests{failed("rest", 0.2, causes::stress_at_rest), failed("clock", 100, causes::clock),
                                failed("dissipation", 1, causes::dissipation), failed("rotation.at_rest", 0.2)};
  const std::vector<Diagnosis> found = diagnose(tests, evidence);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found.front().cause, causes::grows);
  EXPECT_NE(found.front().sentence.find("flags: [grows]"), std::string::npos);
  for (const TestResult& test : tests) EXPECT_EQ(test.cause, causes::grows) << test.id;
}

TEST(Diagnosis, StatesThatAreKeptElsewhereFollowNoClock) {
  EXPECT_EQ(causes_of({failed("calls.repeated", 1, causes::hidden_state), failed("clock", 1, causes::clock)}),
            (std::vector<std::string>{causes::hidden_state}));
}

}  // namespace
}  // namespace assay::check::test_diagnosis
