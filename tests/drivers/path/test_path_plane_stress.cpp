// SPDX-License-Identifier: BSD-3-Clause
// Paths of a UMAT of plane stress: what follows, and what cannot be prescribed.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "drivers/verbs/verbs.hpp"
#include "tests/drivers/foreign_checks.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_path_plane_stress {
namespace {

constexpr double E = 1000, nu = 0.3;
constexpr double tolerance = 1e-8;  ///< the path is solved to 1e-10

class PathPlaneStress : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_foreign("umat_plane_stress")) GTEST_SKIP() << "no Fortran compiler";
  }

  nlohmann::json tabulated(const std::string& model, const std::string& path) {
    scratch_.write("model.yaml", "library: " + built("tests/foreign/") +
                                     "umat_plane_stress.so\ninterface: umat\ncomponents: [3]\n" + model);
    TabulateOptions options;
    options.scene = scratch_.write("path.yaml", "material: {adapter: model.yaml}\npath: " + path + "\n");
    options.out = scratch_ / "out";
    options.verbosity = Verbosity::quiet;
    EXPECT_EQ(tabulate(options), 0);
    return nlohmann::json::parse(bytes_of(options.out + "/result.json"));
  }

  std::string refused(const std::string& model, const std::string& path) {
    return refusal_of([&] { tabulated(model, path); });
  }

  const std::string elastic = "properties: {E: 1000, nu: 0.3, law: 1}\nthickness: 0.3\n";
  const std::string rubber = "properties: {E: 1000, nu: 0.3, law: 2}\nstrain: finite\n";

 private:
  ScratchFolder scratch_;
};
using LongPathPlaneStress = PathPlaneStress;

/// sigma11 = mu (l^2 - 1/l) of incompressible neo-Hookean elasticity; its energy mu/2 (l^2 + 2/l - 3) is the work.
TEST_F(PathPlaneStress, TensionOfRubberIsThatOfTheClosedForm) {
  const auto last = tabulated(rubber, "{type: uniaxial_stress, control: {e11: {type: ramp, to: 0.6}}}")["last"];
  const double mu = E / (2 * (1 + nu)), l = std::exp(0.6);
  EXPECT_NEAR(last["s11"].get<double>(), mu * (l * l - 1 / l), tolerance * mu * l * l);
  EXPECT_NEAR(last["e33"].get<double>(), -0.3, tolerance);
  EXPECT_NEAR(last["J"].get<double>(), 1, tolerance);
  EXPECT_NEAR(last["work"].get<double>(), mu / 2 * (l * l + 2 / l - 3), tolerance * mu * l * l);
}

/// Hypoelasticity in tension: sigma11 = E e11, e22 = e33 = -nu e11.
TEST_F(LongPathPlaneStress, TensionOfASheetIsThatOfABar) {
  for (const char* control : {"{e11: {type: ramp, to: 0.2}}", "{L11: 0.2}", "{e11: {type: ramp, to: 0.2}, s33: 0}"}) {
    const auto result = tabulated(elastic, std::string("{type: uniaxial_stress, control: ") + control + "}");
    EXPECT_NEAR(result["last"]["s11"].get<double>(), E * 0.2, tolerance * E) << control;
    EXPECT_NEAR(result["last"]["e22"].get<double>(), -nu * 0.2, tolerance) << control;
    EXPECT_NEAR(result["last"]["e33"].get<double>(), -nu * 0.2, tolerance) << control;
    EXPECT_NE(result["warnings"][0].get<std::string>().find("plane stress"), std::string::npos);
  }
}

TEST_F(LongPathPlaneStress, AConstantThicknessGoesWithF) {
  const auto result = tabulated("properties: {E: 1000, nu: 0.3, law: 1}\nthickness: constant\n",
                                "{type: simple_shear, control: {F12: {type: ramp, to: 0.1}}}");
  EXPECT_EQ(result["last"]["F33"].get<double>(), 1);
  EXPECT_GT(result["last"]["s12"].get<double>(), 30);
}

TEST_F(PathPlaneStress, WhatIsNotInThePlaneIsRefused) {
  const auto line = [&](const std::string& control) {
    return refused(elastic, "{control: {e11: 0.1, " + control + "}}");
  };
  for (const char* control : {"e33: 0.1", "s33: 5", "e13: 0.01", "s23: 1", "e33 - e11: 0", "e22: 0, pressure: 3"}) {
    EXPECT_NE(line(control).find("prescribes what is not in the plane"), std::string::npos) << line(control);
    EXPECT_NE(line(control).find("path.yaml:2:"), std::string::npos) << line(control);
  }
  EXPECT_NE(refused(elastic, "{control: {F11: 1.1}}").find("Prescribe e or L"), std::string::npos);
  EXPECT_NE(refused(elastic, "{initial_stress: [0, 0, 1, 0, 0, 0], control: {e11: 0.1}}").find("path.initial_stress"),
            std::string::npos);
}

TEST_F(PathPlaneStress, AMotionOfPlaneStrainIsRefused) {
  const ScratchFolder scratch;
  scratch.write("model.yaml", "library: " + built("tests/foreign/") +
                                  "umat_plane_stress.so\ninterface: umat\ncomponents: [3]\ndensity: 1000\n" + elastic);
  const Ending ending = assay({"run", tree_folder() + "/configs/paper/vortex_cpdi.yaml", "--set",
                               "material.adapter=" + (scratch / "model.yaml"), "--set",
                               "material.parameters={E: 1000, nu: 0.3, law: 1}", "-o", scratch / "out"});
  EXPECT_EQ(ending.status, 2) << ending.said;
  EXPECT_NE(ending.said.find("plane stress"), std::string::npos) << ending.said;
}

}  // namespace
}  // namespace assay::drivers::test_path_plane_stress
