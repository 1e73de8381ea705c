// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/mfront.hpp"

#include <gtest/gtest.h>

#include "harness/check/battery.hpp"
#include "tests/adapters/foreign/foreign_steps.hpp"

namespace assay::adapters::test_mfront {
namespace {

ForeignModel odd(const std::string& behaviour) {
  ForeignModel model;
  model.interface = ForeignInterface::mfront;
  model.library = double_library("mfront_odd");
  model.name = "odd";
  model.symbol = behaviour;
  model.temperature = 293.15;
  return model;
}

StepEnd stretched(const ForeignModel& model, const std::map<std::string, double>& properties) {
  Tensor F = Tensor::Identity();
  F(0, 0) = std::exp(1e-3);
  return StepsOfOnePoint(model, properties).tried(0, 1, Tensor::Identity(), F);
}

TEST(Mfront, AValueThatTheInterfaceDoesNotHaveIsAFailure) {
  const auto report = [](double status) { return stretched(odd("Returns"), {{"status", status}}).report; };
  EXPECT_EQ(report(1).worst, ASSAY_GOOD);
  EXPECT_EQ(report(0).worst, ASSAY_DOUBTFUL);
  EXPECT_EQ(report(-1).worst, ASSAY_FAILED);
  for (const int status : {-7, 2, 77}) {
    const UpdateReport found = report(status);
    EXPECT_EQ(found.worst, ASSAY_FAILED) << status;
    EXPECT_NE(found.message.find("returned " + std::to_string(status) + ","), std::string::npos) << found.message;
  }
}

TEST(Mfront, AParameterThatIsNotTakenIsAFailure) {
  const UpdateReport found = stretched(odd("Deaf"), {{"YoungModulus", 1e3}}).report;
  EXPECT_EQ(found.worst, ASSAY_FAILED);
  EXPECT_EQ(found.message, "the library does not take its own parameter 'theta'");
}

TEST(Mfront, ABehaviourThatWritesNoForceHasNoStress) {
  const Material material(foreign_table(odd("Silent")), {{"YoungModulus", 1e3}});
  const check::Report report = check::run_battery(material, {.effort = {.quick = true}});
  ASSERT_FALSE(report.diagnosis.empty());
  EXPECT_EQ(report.diagnosis[0].cause, check::causes::no_stress) << report.diagnosis[0].sentence;
}

TEST(Mfront, ATemperatureAmongItsOwnVariablesIsThatOfTheDescription) {
  const auto force = [](const ForeignModel& model) {
    return stretched(model, {{"YoungModulus", 1}}).cauchy(0, 0) * std::exp(1e-3) / 1e-3;
  };
  ForeignModel model = odd("Warm");
  EXPECT_NEAR(force(model), 293.15, 1e-9);
  model.temperature = 400, model.temperature_is_said = true;
  EXPECT_NEAR(force(model), 400, 1e-9);
  model.fields = {{"Temperature", 300}};
  EXPECT_THROW(foreign_table(model), ModelRefused) << "twice";
  model.temperature_is_said = false;
  EXPECT_NEAR(force(model), 300, 1e-9);
  ForeignModel cold = odd("Cold");
  EXPECT_NO_THROW(foreign_table(cold));
  cold.temperature_is_said = true;
  EXPECT_THROW(foreign_table(cold), ModelRefused) << "it takes none";
}

/// In the plane the two functions of a behaviour answer alike, with their tangents; in small and in finite strain.
TEST(Mfront, TheHypothesisOfThePlaneAnswersAsThatOfSpace) {
  constexpr double same = 1e-12;  ///< rounding, relative to the modulus
  for (const char* name : {"mfront_norton", "mfront_neo_hookean"}) {
    SCOPED_TRACE(name);
    ForeignModel space = foreign_double(name), plane = space;
    plane.hypothesis = "PlaneStrain";
    StepsOfOnePoint in_space(space), in_plane(plane);
    EXPECT_TRUE(in_plane.material.has(ASSAY_IN_PLANE));
    Tensor F0 = Tensor::Identity(), F1 = F0;
    for (int k = 1; k <= 3; ++k) {
      F1(0, 0) = 1 + 0.01 * k, F1(0, 1) = 0.02 * k, F1(1, 0) = -0.01 * k, F1(2, 2) = 1 - 0.005 * k;
      const std::vector<double> a = in_space.tangent(k, 0.5, F0, F1), b = in_plane.tangent(k, 0.5, F0, F1);
      for (int row = 0; row < 9; ++row) {
        for (int column = 0; column < 9; ++column) {
          if (!is_in_plane(row) || !is_in_plane(column)) continue;
          const auto at = static_cast<std::size_t>(9 * row + column);
          EXPECT_NEAR(a[at], b[at], same * 1e3) << row << " " << column;
        }
      }
      const StepEnd whole = in_space.taken(k, 0.5, F0, F1), part = in_plane.taken(k, 0.5, F0, F1);
      EXPECT_LT((whole.cauchy - part.cauchy).cwiseAbs().maxCoeff(), same * 1e3) << k;
      F0 = F1;
    }
    F1(0, 2) = 0.01;
    EXPECT_EQ(in_plane.tried(4, 0.5, F0, F1).report.worst, ASSAY_FAILED);
  }
}

TEST(Mfront, AHypothesisThatTheBehaviourDoesNotHaveIsRefused) {
  ForeignModel model = foreign_double("mfront_norton");
  model.hypothesis = "Axisymmetrical";
  try {
    foreign_table(model);
    FAIL() << "accepted";
  } catch (const ModelRefused& refused) {
    EXPECT_EQ(refused.key(), "hypothesis") << refused.what();
  }
}

}  // namespace
}  // namespace assay::adapters::test_mfront
