// SPDX-License-Identifier: BSD-3-Clause
// Texts of an MTest file, its tolerances, and the settings that have no effect here.
#include "drivers/point_drivers/mtest_reading.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

constexpr const char* of_convergence = "how the solver of MTest converges";
constexpr const char* of_output = "what MTest writes";
constexpr const char* of_steps = "how MTest chooses its steps";
constexpr const char* of_tangent = "how MTest tests the tangent";

struct SettingWithoutEffect {
  const char* keyword;
  const char* what;
};

constexpr SettingWithoutEffect without_effect[] = {
    {"@AccelerationAlgorithm", of_convergence},
    {"@AccelerationAlgorithmParameter", of_convergence},
    {"@UseCastemAccelerationAlgorithm", of_convergence},
    {"@CastemAccelerationPeriod", of_convergence},
    {"@CastemAccelerationTrigger", of_convergence},
    {"@StiffnessMatrixType", of_convergence},
    {"@StiffnessUpdatePolicy", of_convergence},
    {"@PredictionPolicy", of_convergence},
    {"@OutputFile", of_output},
    {"@OutputFilePrecision", of_output},
    {"@OutputFrequency", of_output},
    {"@XMLOutputFile", of_output},
    {"@ResidualFile", of_output},
    {"@ResidualFileName", of_output},
    {"@ResidualFilePrecision", of_output},
    {"@UserDefinedPostProcessing", of_output},
    {"@PrintLagrangeMultipliers", of_output},
    {"@Print", of_output},
    {"@Message", of_output},
    {"@DynamicTimeStepScaling", of_steps},
    {"@MaximalTimeStep", of_steps},
    {"@MinimalTimeStep", of_steps},
    {"@MaximalTimeStepScalingFactor", of_steps},
    {"@MinimalTimeStepScalingFactor", of_steps},
    {"@CompareToNumericalTangentOperator", of_tangent},
    {"@TangentOperatorComparisonCriterium", of_tangent},
    {"@TangentOperatorComparisonCriterion", of_tangent},
    {"@NumericalTangentOperatorPerturbationValue", of_tangent},
    {"@Event", "events, which only constraints with options name"},
};

MtestHandler ignored_setting(const SettingWithoutEffect& setting) {
  return [setting](MtestReading& reading) {
    const Location where = reading.tokens.where();
    const std::string said = reading.tokens.up_to_semicolon();
    reading.out.ignored.push_back({setting.keyword, said + ": " + setting.what, where});
  };
}

MtestHandler plain_text(std::string MtestFile::*text) {
  return [text](MtestReading& reading) { reading.out.*text = reading.tokens.up_to_semicolon(); };
}

void read_mtest_description(MtestReading& reading) {
  reading.out.description = reading.tokens.between_braces();
  reading.tokens.take(";");
}

MtestHandler read_epsilon(std::optional<double> MtestFile::*epsilon) {
  return [epsilon](MtestReading& reading) {
    MtestTokens& tokens = reading.tokens;
    const Location where = tokens.where();
    const double value = read_number(reading);
    if (!(value > 0)) tokens.refuse(where, "must be positive");
    reading.out.*epsilon = value;
    tokens.expect(";");
  };
}

MtestHandler read_most(std::optional<int> MtestFile::*most) {
  return [most](MtestReading& reading) {
    MtestTokens& tokens = reading.tokens;
    const Location where = tokens.where();
    const int value = tokens.count();
    if (value < 1) tokens.refuse(where, "must be at least 1");
    reading.out.*most = value;
    tokens.expect(";");
  };
}

}  // namespace

void add_setting_keywords(MtestHandlers& handlers) {
  for (const SettingWithoutEffect& setting : without_effect) handlers[setting.keyword] = ignored_setting(setting);
  handlers["@Author"] = plain_text(&MtestFile::author);
  handlers["@Date"] = plain_text(&MtestFile::date);
  handlers["@Description"] = read_mtest_description;
  for (const char* keyword :
       {"@StrainEpsilon", "@DeformationGradientEpsilon", "@DrivingVariableEpsilon", "@GradientEpsilon"})
    handlers[keyword] = read_epsilon(&MtestFile::strain_epsilon);
  for (const char* keyword : {"@StressEpsilon", "@ThermodynamicForceEpsilon"})
    handlers[keyword] = read_epsilon(&MtestFile::stress_epsilon);
  handlers["@MaximumNumberOfIterations"] = read_most(&MtestFile::most_iterations);
  handlers["@MaximumNumberOfSubSteps"] = read_most(&MtestFile::most_substeps);
  handlers["@RotationMatrix"] = read_rotation;
  handlers["@Import"] = [](MtestReading& reading) {
    reading.tokens.refuse("functions of libraries are not served in formulas: write the formula out");
  };
}

}  // namespace assay::drivers
