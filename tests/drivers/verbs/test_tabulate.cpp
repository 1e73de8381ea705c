// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/verbs/verbs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "drivers/format/csv.hpp"
#include "drivers/system/input_error.hpp"
#include "tests/adapters/models/references/zener.hpp"
#include "tests/drivers/process.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_tabulate {
namespace {

const std::string configs = tree_folder() + "/configs/paper/";
const std::vector<std::string> sheet_columns{"xi",         "t",          "gamma",     "tau11",      "tau12",
                                             "tau21",      "tau22",      "tau33",     "dtau11_dxi", "dtau12_dxi",
                                             "dtau21_dxi", "dtau22_dxi", "dtau33_dxi"};

TabulateOptions options_for(const std::string& scene, const std::string& out, std::vector<std::string> sets = {}) {
  TabulateOptions options;
  options.scene = configs + scene;
  options.out = out;
  options.sets = std::move(sets);
  options.verbosity = Verbosity::quiet;
  return options;
}

TEST(Tabulate, WritesSheetCurveAndPlots) {
  const ScratchFolder scratch;
  const std::string out = scratch / "out";
  ASSERT_EQ(tabulate(options_for("vortex_cpdi.yaml", out)), 0);  // its expectations of a run are not judged here
  for (const char* name : {"result.json", "resolved.yaml", "sheet.csv", "curve.csv", "tau.png", "slope.png"}) {
    EXPECT_TRUE(std::filesystem::exists(out + "/" + name)) << name;
  }
  const CsvTable sheet = read_csv(bytes_of(out + "/sheet.csv"), "sheet.csv", sheet_columns);
  const double mu = 1e3 / 2.6;
  double largest_shear = 0;
  for (std::size_t i = 0; i < sheet.rows(); ++i) {
    const double gamma = (*sheet.column("gamma"))[i];
    EXPECT_NEAR((*sheet.column("tau12"))[i], mu * gamma, 1e-9);
    EXPECT_NEAR((*sheet.column("tau11"))[i], 0, 1e-9);
    largest_shear = std::max(largest_shear, std::abs(gamma));
  }
  EXPECT_NEAR(largest_shear, 7.07, 0.01);
  const auto result = nlohmann::json::parse(bytes_of(out + "/result.json"));
  EXPECT_LT(result["sheet"]["error_tau"].get<double>(), 1e-10);
}

TEST(Tabulate, AnswersPointsInTheOrderAskedAlsoOutsideTheRing) {
  const ScratchFolder scratch;
  TabulateOptions options = options_for("vortex_cpdi.yaml", scratch / "out",
                                        {"material.parameters.E=2.0e5", "material.parameters.nu=0.4",
                                         "motion.amplitude={type: one_minus_cosine, peak: 0.7}"});
  options.points = scratch.write("points.csv", "t,xi\n0.9,-2\n0.1,9.5\n1.7,0.3\n0,1\n");
  ASSERT_EQ(tabulate(options), 0);
  const CsvTable table = read_csv(bytes_of(options.out + "/points.csv"), "points.csv", sheet_columns);
  ASSERT_EQ(table.rows(), 4u);
  const double xi[] = {-2, 9.5, 0.3, 1}, t[] = {0.9, 0.1, 1.7, 0}, mu = 2e5 / 2.8;
  for (std::size_t i = 0; i < 4; ++i) {
    const double g = 0.7 * (1 - std::cos(2 * std::numbers::pi * t[i])) / 2;
    EXPECT_EQ((*table.column("xi"))[i], xi[i]);
    EXPECT_EQ((*table.column("t"))[i], t[i]);
    EXPECT_NEAR((*table.column("gamma"))[i], 2 * xi[i] * g, 1e-14 * 10);
    EXPECT_NEAR((*table.column("tau21"))[i], 2 * mu * xi[i] * g, 1e-10 * mu * 10);
    EXPECT_NEAR((*table.column("dtau21_dxi"))[i], 2 * mu * g, 1e-10 * mu * 10);
  }
}

/// The command line prints what the equations of a model with memory give, through loading, unloading and reversal.
TEST(LongTabulate, AnswersPointsOfAModelWithMemoryByItsEquations) {
  const ScratchFolder scratch;
  const std::string scene =
      scratch.write("scene.yaml",
                    "motion: {type: vortex, amplitude: {type: sine, peak: 0.4}}\ntime: {end: 2.0}\n"
                    "material: {adapter: zener, parameters: {E: 1500, nu: 0.25, viscous_ratio: 2.5, relaxation_time: "
                    "0.4}, density: 1}\n");
  const std::string points = scratch.write("points.csv", "xi,t\n1.7,0.31\n-2.2,0.64\n0.4,0.97\n2.1,1.5\n-1.1,1.83\n");
  const std::string out = scratch / "out";
  const Ending ending = assay({"tabulate", scene, "--points", points, "-o", out});
  ASSERT_EQ(ending.status, 0) << ending.said;
  const CsvTable table = read_csv(bytes_of(out + "/points.csv"), "points.csv", sheet_columns);
  ASSERT_EQ(table.rows(), 5u);
  const auto exact = [](double xi, double t) {
    const double pi = std::numbers::pi;
    Tensor D = Tensor::Zero();
    D(1, 0) = 0.8 * xi;
    const auto F = [=](double s) { return Tensor(Tensor::Identity() + std::sin(pi * s) * D); };
    const auto F_rate = [=](double s) { return Tensor(pi * std::cos(pi * s) * D); };
    return Tensor(model_tests::zener_stress({F, F_rate, t}, {1500, 0.25}, 2.5, 0.4) * F(t).inverse().transpose());
  };
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double xi = (*table.column("xi"))[i], t = (*table.column("t"))[i], h = 1e-3;
    const Tensor tau = exact(xi, t);
    const Tensor slope =
        (8 * (exact(xi + h, t) - exact(xi - h, t)) - (exact(xi + 2 * h, t) - exact(xi - 2 * h, t))) / (12 * h);
    const double scale = tau.cwiseAbs().maxCoeff(), slope_scale = slope.cwiseAbs().maxCoeff();
    for (const auto& [name, r, c] : {std::tuple{"11", 0, 0}, {"12", 0, 1}, {"21", 1, 0}, {"22", 1, 1}, {"33", 2, 2}}) {
      EXPECT_NEAR((*table.column("tau" + std::string(name)))[i], tau(r, c), 1e-8 * scale) << name << ' ' << i;
      EXPECT_NEAR((*table.column("dtau" + std::string(name) + "_dxi"))[i], slope(r, c), 1e-8 * slope_scale) << i;
    }
  }
}

/// A path that shears out of the plane has stress there: P F^T is symmetric only with all nine components.
TEST(Tabulate, WritesAllComponentsWhereThePathLeavesThePlane) {
  const ScratchFolder scratch;
  const std::string scene = scratch.write(
      "scene.yaml",
      "motion: {type: homogeneous, final: [[1, 0, 0.4], [0, 1, 0.2], [0, 0, 1]], period: 1}\ntime: {end: 1.0}\n"
      "material: {adapter: neo_hookean, parameters: {E: 1000, nu: 0.3}, density: 1}\n");
  const std::string out = scratch / "out";
  const Ending ending = assay({"tabulate", scene, "-o", out});
  ASSERT_EQ(ending.status, 0) << ending.said;
  const auto columns = [](const std::string& before, const std::string& after) {
    std::vector<std::string> names;
    for (const char* c : {"11", "12", "13", "21", "22", "23", "31", "32", "33"}) names.push_back(before + c + after);
    return names;
  };
  std::vector<std::string> names{"xi", "t", "gamma"};
  for (const auto& list : {columns("tau", ""), columns("dtau", "_dxi")}) {
    names.insert(names.end(), list.begin(), list.end());
  }
  const CsvTable sheet = read_csv(bytes_of(out + "/sheet.csv"), "sheet.csv", names);
  const double mu = 1000 / 2.6;
  double largest = 0;
  for (std::size_t i = 0; i < sheet.rows(); ++i) {
    const double g = (*sheet.column("xi"))[i] * (*sheet.column("t"))[i];
    EXPECT_NEAR((*sheet.column("tau13"))[i], mu * 0.4 * g, 1e-9 * mu);  // mu (F - F^-T), J = 1
    EXPECT_NEAR((*sheet.column("tau32"))[i], mu * 0.2 * g, 1e-9 * mu);
    largest = std::max(largest, std::abs(g));
  }
  EXPECT_GT(largest, 0.9);
}

TEST(Tabulate, CurveOfUniaxialStrainIsThePapers) {
  const ScratchFolder scratch;
  const std::string out = scratch / "out";
  ASSERT_EQ(tabulate(options_for("tabulate_neo_hookean.yaml", out)), 0);
  const CsvTable curve =
      read_csv(bytes_of(out + "/curve.csv"), "curve.csv", {"eps", "tau11", "tau22", "tau33", "dtau11_deps"},
               {"tau12", "tau21", "dtau12_deps", "dtau21_deps", "dtau22_deps", "dtau33_deps"});
  const double mu = 1e6 / 2.5, lambda = 1e6 * 0.25 / (1.25 * 0.5);
  EXPECT_EQ(curve.column("eps")->front(), 0);
  EXPECT_EQ(curve.column("eps")->back(), 1);
  for (std::size_t i = 0; i < curve.rows(); ++i) {
    const double s = 1 + (*curve.column("eps"))[i];
    EXPECT_NEAR((*curve.column("tau11"))[i], lambda * std::log(s) / s + mu * (s - 1 / s), 1e-9 * mu);
    EXPECT_NEAR((*curve.column("tau22"))[i], lambda * std::log(s), 1e-9 * mu);
    EXPECT_NEAR((*curve.column("dtau11_deps"))[i], lambda * (1 - std::log(s)) / (s * s) + mu * (1 + 1 / (s * s)),
                1e-8 * mu);
  }
}

TEST(Tabulate, AMaterialThatFailsIsAFinding) {
  const ScratchFolder scratch;
  const std::string out = scratch / "out";
  EXPECT_EQ(
      tabulate(options_for("vortex_cpdi.yaml", out,
                           {"material={adapter: " + built("tests/plugins/fails_when_sheared.so") + ", density: 1}"})),
      1);
  const auto result = nlohmann::json::parse(bytes_of(out + "/result.json"));
  EXPECT_EQ(result["outcome"], "material_failed");
  EXPECT_NE(result["reason"].get<std::string>().find("deformed beyond its limit"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(out + "/sheet.csv"));
}

TEST(Tabulate, AnExpectationThatFailsContradicts) {
  const ScratchFolder scratch;
  EXPECT_EQ(tabulate(options_for("tabulate_neo_hookean.yaml", scratch / "out",
                                 {"expect={sheet.error_tau: {below: 1.0e-30}}"})),
            1);
}

TEST(Tabulate, RefusesPointsThatNoDeformationReaches) {
  const ScratchFolder scratch;
  TabulateOptions options = options_for("tabulate_neo_hookean.yaml", scratch / "out");
  for (const char* xi : {"-3", "-1"}) {
    options.points = scratch.write("points.csv", std::string("xi,t\n0.5,1\n") + xi + ",1\n");
    try {
      tabulate(options);
      FAIL() << xi;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()), options.points + ":3:1: xi: det F <= 0 on the way to " + xi);
    }
  }
}

TEST(Tabulate, RefusesTimesBeforeTheStart) {
  const ScratchFolder scratch;
  TabulateOptions options = options_for("vortex_cpdi.yaml", scratch / "out");
  options.points = scratch.write("points.csv", "xi,t\n1,-1\n");
  EXPECT_THROW(tabulate(options), InputError);
  EXPECT_FALSE(std::filesystem::exists(options.out));
}

}  // namespace
}  // namespace assay::drivers::test_tabulate
