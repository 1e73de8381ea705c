// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/verbs/verbs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <sstream>

#include "drivers/format/csv.hpp"
#include "drivers/scene/scene.hpp"
#include "drivers/system/input_error.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_eval {
namespace {

using std::numbers::pi;

const std::string configs = tree_folder() + "/configs/paper/";
const std::vector<std::string> plane_columns{"X",   "Y",   "t",   "x",   "y",   "vx",  "vy",  "ax",  "ay",
                                             "F11", "F12", "F21", "F22", "F33", "P11", "P12", "P21", "P22",
                                             "P33", "s11", "s12", "s22", "s33", "bx",  "by"};

CsvTable evaluated(const ScratchFolder& scratch, const std::string& scene, const std::string& points,
                   const std::vector<std::string>& sets, const std::vector<std::string>& columns) {
  EvalOptions options;
  options.scene = scene;
  options.points = scratch.write("points.csv", points);
  options.out = scratch / "exact.csv";
  options.sets = sets;
  EXPECT_EQ(eval(options), 0);
  const CsvTable table = read_csv(bytes_of(options.out), options.out, columns);
  EXPECT_EQ(table.names, columns);
  return table;
}

/// The paper's scene as it is without particles.
std::string without_method(const ScratchFolder& scratch, const std::string& scene) {
  std::string text;
  std::istringstream lines(bytes_of(configs + scene));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("method:")) text += line + "\n";
  }
  return scratch.write(scene, text);
}

/// Whatever the motion: the powers of a spin or a rate that are no numbers are empty fields, of which a warning tells.
TEST(Eval, ValuesThatAreNotFiniteAreCounted) {
  const ScratchFolder scratch;
  const std::string motion = scratch.write("v.yaml",
                                           "motion: {type: vortex}\nmaterial: {adapter: neo_hookean, parameters: {E: "
                                           "1000, nu: 0.3}, density: 1000}\n");
  EvalOptions options;
  options.scene = motion;
  options.points = scratch.write("points.csv", "X,Y,t\n2,0,0\n1,0,0.4\n");
  options.out = scratch / "exact.csv";
  const auto said = [&](const std::string& set) {
    options.sets = {set};
    testing::internal::CaptureStderr();
    EXPECT_EQ(eval(options), 0);
    return testing::internal::GetCapturedStderr();
  };
  const std::string text = said("frame.spin=1.0e+308");
  EXPECT_NE(text.find(" of 50 values are not finite and stay empty, first vx of line 2 of the points"), text.npos)
      << text;
  EXPECT_EQ(said("motion.amplitude.peak=0.1").find("finite"), std::string::npos);
}

/// The corrected (35) with any amplitude A sin(pi t/T), in Cartesian components, for the paper's ring.
struct PapersBodyForce {
  double mu, rho, A, T;
  std::array<double, 2> at(double X, double Y, double t) const {
    const double R = std::hypot(X, Y), q = 15 - 32 * R + 16 * R * R, d = R - 1, w = pi / T;
    const double s = A * std::sin(w * t), c = A * std::cos(w * t), h = q * q, h1 = -64 * d + 1024 * d * d * d;
    const double h2 = -64 + 3072 * d * d;
    const double br = -R * w * w * h * h * c * c + R * mu * s * s * h1 * h1 / rho;
    const double bt = -R * w * w * s * h - mu * s * (3 * h1 + R * h2) / rho;
    const double theta = std::atan2(Y, X) + s * h;
    return {br * std::cos(theta) - bt * std::sin(theta), br * std::sin(theta) + bt * std::cos(theta)};
  }
};

TEST(Eval, AgreesWithTheClosedFormAtRandomPoints) {
  const ScratchFolder scratch;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(0.7501, 1.2499), angle(-pi, pi);
  for (const auto& [E, nu, rho, A, T] :
       {std::tuple{1e3, 0.3, 1000.0, 1.0, 1.0}, std::tuple{3.7e4, 0.12, 810.0, 0.37, 2.5},
        std::tuple{2e6, 0.45, 7800.0, 1.9, 0.4}}) {
    std::uniform_real_distribution<double> time(0, 1.3 * T);  // beyond T the motion continues
    std::string points = "X,Y,t\n";
    for (int k = 0; k < 200; ++k) {
      const double R = radius(random), a = angle(random);
      points += std::to_string(R * std::cos(a)) + "," + std::to_string(R * std::sin(a)) + "," +
                std::to_string(time(random)) + "\n";
    }
    const auto set = [](const std::string& key, double value) { return key + "=" + std::to_string(value); };
    for (const char* response : {"sheet", "closed_form"}) {
      const CsvTable table = evaluated(
          scratch, configs + "vortex_cpdi.yaml", points,
          {set("material.parameters.E", E), set("material.parameters.nu", nu), set("material.density", rho),
           set("motion.amplitude.peak", A), set("motion.period", T), "force.response=" + std::string(response)},
          plane_columns);
      const PapersBodyForce exact{E / (2 * (1 + nu)), rho, A, T};
      double largest = 0, scale = 0;
      for (std::size_t i = 0; i < table.rows(); ++i) {
        const auto b = exact.at((*table.column("X"))[i], (*table.column("Y"))[i], (*table.column("t"))[i]);
        largest = std::max(largest, std::hypot((*table.column("bx"))[i] - b[0], (*table.column("by"))[i] - b[1]));
        scale = std::max(scale, std::hypot(b[0], b[1]));
      }
      EXPECT_LT(largest, 1e-11 * scale) << response << " E=" << E;
    }
  }
}

TEST(Eval, GivesTheNeoHookeanStressOfItsOwnDeformationGradient) {
  const ScratchFolder scratch;
  const CsvTable table = evaluated(scratch, configs + "vortex_cpdi.yaml",
                                   "t,Y,X\n0.3,0.2,0.9\n0.71,-1.1,0.2\n0.5,0,0.1\n", {}, plane_columns);
  const double mu = 1e3 / 2.6;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto at = [&](const char* name) { return (*table.column(name))[i]; };
    EXPECT_NEAR(at("F11") * at("F22") - at("F12") * at("F21"), 1, 1e-13);
    EXPECT_NEAR(at("s11"), mu * (at("F11") * at("F11") + at("F12") * at("F12") - 1), 1e-9);  // (34), J = 1
    EXPECT_NEAR(at("s12"), mu * (at("F11") * at("F21") + at("F12") * at("F22")), 1e-9);
    EXPECT_NEAR(at("P12"), mu * (at("F12") + at("F21")), 1e-9);      // P = mu (F - F^-T)
    EXPECT_NEAR(at("vx") * at("x") + at("vy") * at("y"), 0, 1e-13);  // circular motion
  }
  EXPECT_EQ((*table.column("bx"))[2], 0);  // inside the hole of the ring
  EXPECT_EQ((*table.column("x"))[2], 0.1);
}

TEST(Eval, StartsAtTimeZeroWithTheExactVelocity) {
  const ScratchFolder scratch;
  const CsvTable table = evaluated(scratch, configs + "vortex_cpdi.yaml", "X,Y,t\n1,0,0\n", {}, plane_columns);
  EXPECT_NEAR((*table.column("vy"))[0], pi, 1e-14);  // g'(0) h(1) R
  EXPECT_NEAR((*table.column("P12"))[0], 0, 1e-11);
}

TEST(Eval, TractionsOfUniaxialStrain) {
  const ScratchFolder scratch;
  auto columns = plane_columns;
  columns.insert(columns.end(), {"tx", "ty"});
  const CsvTable table = evaluated(scratch, configs + "tabulate_neo_hookean.yaml",
                                   "X,Y,t,NX,NY\n1,0.5,0.25,1,0\n0.5,1,1,0,1\n0,0.5,0.6,-2,0\n", {}, columns);
  const double mu = 1e6 / 2.5, lambda = 1e6 * 0.25 / (1.25 * 0.5);
  const auto at = [&](const char* name, std::size_t i) { return (*table.column(name))[i]; };
  EXPECT_NEAR(at("tx", 0), (lambda * std::log(1.25) + mu * (1.25 * 1.25 - 1)) / 1.25, 1e-6 * 1e-3 * mu);  // (39)
  EXPECT_NEAR(at("s22", 1), lambda * std::log(2) / 2, 1e-9 * mu);                                         // (40)
  EXPECT_NEAR(at("ty", 1), lambda * std::log(2), 1e-9 * mu);  // per reference area
  EXPECT_LT(at("tx", 2), 0);                                  // the normal is normalised and points outward
  EXPECT_NEAR(at("tx", 2), -at("P11", 2), 1e-9 * mu);
  EXPECT_EQ(at("bx", 1), 0);
  EXPECT_EQ(at("x", 1), 1.0);
  EXPECT_EQ(at("vx", 1), 0.5);
}

TEST(Eval, ADirectionMayBeOfAnyLength) {
  Scene scene;
  for (const double length : {1e-170, 1.0, 1e160, 1.7e308}) {
    scene.material.direction = {length, length, 0};
    const auto found = baseline_path(scene).material_direction;
    for (const std::size_t c : {0, 1}) EXPECT_NEAR(found[c], std::sqrt(0.5), 1e-15) << length;
  }
}

/// Squares of these lengths vanish or overflow, of the last one the length itself.
TEST(Eval, ANormalMayBeOfAnyLength) {
  const ScratchFolder scratch;
  auto columns = plane_columns;
  columns.insert(columns.end(), {"tx", "ty"});
  const CsvTable table = evaluated(scratch, configs + "tabulate_neo_hookean.yaml",
                                   "X,Y,t,NX,NY\n1,0.5,1,1,0\n1,0.5,1,1e-162,0\n1,0.5,1,1e155,0\n1,0.5,1,5e-324,0\n"
                                   "1,0.5,1,1,1\n1,0.5,1,1.7e308,1.7e308\n1,0.5,1,1e-170,1e-170\n",
                                   {}, columns);
  for (const char* name : {"tx", "ty"}) {
    const auto& t = *table.column(name);
    for (const std::size_t i : {1, 2, 3}) EXPECT_EQ(t[i], t[0]) << name << i;
    for (const std::size_t i : {5, 6}) EXPECT_NEAR(t[i], t[4], 1e-15 * std::abs(t[4])) << name << i;
  }
  EXPECT_NE((*table.column("tx"))[0], 0);
}

TEST(Eval, WritesAllComponentsOfAMotionOutOfThePlane) {
  const ScratchFolder scratch;
  EvalOptions options;
  options.scene = configs + "tabulate_neo_hookean.yaml";
  options.sets = {"motion.final=[[1.2,0,0.1],[0,1,0],[0,0.3,0.9]]"};
  options.points = scratch.write("points.csv", "X,Y,Z,t\n0.3,0.2,0.5,1\n");
  options.out = scratch / "exact.csv";
  ASSERT_EQ(eval(options), 0);
  const std::string text = bytes_of(options.out);
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "X,Y,Z,t,x,y,z,vx,vy,vz,ax,ay,az,F11,F12,F13,F21,F22,F23,F31,F32,F33,P11,P12,P13,P21,P22,P23,P31,P32,P33,"
            "s11,s22,s33,s12,s13,s23,bx,by,bz");
}

/// A slab of the vortex: every Z has the plane's answer, and nothing acts along Z but the stress 33.
TEST(Eval, ASlabInSpaceIsPlaneStrain) {
  constexpr double rounding = 1e-13;
  const ScratchFolder scratch;
  const CsvTable plane = evaluated(scratch, configs + "vortex_cpdi.yaml",
                                   "X,Y,t\n0.9,0.3,0.4\n-0.2,1.1,0.7\n0.5,0.7,0.9\n1.4,0,0.3\n", {}, plane_columns);
  std::vector<std::string> columns{"X", "Y", "Z", "t", "x", "y", "z", "vx", "vy", "vz", "ax", "ay", "az"};
  for (const char* tensor : {"F", "P"}) {
    for (const char* index : {"11", "12", "13", "21", "22", "23", "31", "32", "33"})
      columns.push_back(std::string(tensor) + index);
  }
  columns.insert(columns.end(), {"s11", "s22", "s33", "s12", "s13", "s23", "bx", "by", "bz"});
  const CsvTable slab = evaluated(scratch, without_method(scratch, "vortex_cpdi.yaml"),
                                  "X,Y,Z,t\n0.9,0.3,-0.6,0.4\n-0.2,1.1,0.2,0.7\n0.5,0.7,7,0.9\n1.4,0,1e-3,0.3\n",
                                  {"dimension=3"}, columns);
  for (const std::string& name : columns) {
    for (std::size_t i = 0; i < plane.rows(); ++i) {
      const double found = (*slab.column(name))[i];
      if (const auto* right = plane.column(name)) {
        EXPECT_NEAR(found, (*right)[i], rounding * (1 + std::abs((*right)[i]))) << name;
      } else {
        EXPECT_EQ(found, name == "z" || name == "Z" ? (*slab.column("Z"))[i] : 0) << name;
      }
    }
  }
}

TEST(Eval, RefusesTimesBeforeTheStart) {
  const ScratchFolder scratch;
  EvalOptions options;
  options.scene = configs + "vortex_cpdi.yaml";
  options.points = scratch.write("points.csv", "X,Y,t\n1,0,-0.1\n");
  EXPECT_THROW(eval(options), InputError);
}

TEST(Eval, NeverReplacesItsInputs) {
  const ScratchFolder scratch;
  EvalOptions options;
  options.scene = scratch.write("scene.yaml", bytes_of(configs + "vortex_cpdi.yaml"));
  options.points = scratch.write("points.csv", "X,Y,t\n1,0,0.5\n");
  std::filesystem::create_symlink(options.points, scratch / "link.csv");
  for (const std::string& out : {options.scene, options.points, scratch / "link.csv"}) {
    options.out = out;
    const std::string before = bytes_of(out);
    EXPECT_THROW(eval(options), InputError) << out;
    EXPECT_EQ(bytes_of(out), before);
  }
}

}  // namespace
}  // namespace assay::drivers::test_eval
