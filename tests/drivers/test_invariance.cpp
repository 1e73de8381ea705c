// SPDX-License-Identifier: BSD-3-Clause
// The same problem in other units, or with another density in proportion, has the same answer; a body cut by the grid
// anywhere and turned by any angle lives.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/drivers/quiet_run.hpp"

namespace assay::drivers::test_invariance {
namespace {

constexpr double same = 1e-10;  ///< relative: rounding of other numbers, over some hundred steps

std::string number(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

/// The vortex in units of `length` m, `time` s and `mass` kg.
nlohmann::json vortex_in(double length, double time, double mass, const std::string& method) {
  const double density = 1000 / mass * std::pow(length, 3), modulus = 1e3 / mass * length * time * time;
  const auto metres = [&](double x) { return number(x / length); };
  return result_of_run(
      "methods/best_total",
      {"motion={type: vortex, inner: " + metres(0.75) + ", outer: " + metres(1.25) + ", period: " + number(1 / time) +
           ", amplitude: {type: sine, peak: 0.5}}",
       "material={adapter: neo_hookean, parameters: {E: " + number(modulus) +
           ", nu: 0.3}, density: " + number(density) + "}",
       "body={domain: square, outside: free, lower: [" + metres(-1.5) + ", " + metres(-1.5) + "], upper: [" +
           metres(1.5) + ", " + metres(1.5) + "]}",
       "grid.spacing=" + metres(0.125), "method=" + method, "time.end=" + number(1 / time),
       "force={response: closed_form}", "output={particles: 0, pictures: false, report: false, errors: 20}"});
}

// SI, mm-t-s and m-Mg-s with kPa.
TEST(Invariance, TheAnswerDoesNotDependOnTheUnits) {
  for (const char* method : {"{basis: cpdi, courant: 0.3}",
                             "{basis: bspline2, formulation: total, transfer: aflip, mass: series, terms: 4}"}) {
    const auto si = vortex_in(1, 1, 1, method);
    ASSERT_EQ(si["outcome"], "completed");
    const double error = si["error"]["l2_max"], stress = si["error"]["stress"]["l2_max"];
    struct Units {
      double length, time, mass;
    };
    for (const Units& units : {Units{1e-3, 1, 1e3}, Units{1, 1, 1e3}, Units{1, 1e-3, 1}}) {
      const auto other = vortex_in(units.length, units.time, units.mass, method);
      EXPECT_EQ(other["steps"], si["steps"]);
      EXPECT_NEAR(other["error"]["l2_max"].get<double>() * units.length, error, same * error) << units.length;
      const double pascal = units.mass / (units.length * units.time * units.time);
      EXPECT_NEAR(other["error"]["stress"]["l2_max"].get<double>() * pascal, stress, same * stress) << units.mass;
    }
  }
}

TEST(Invariance, OfDensityAndModulusTheirRatioCounts) {
  const auto of = [](double factor) {
    return result_of_run("methods/best_total", {"grid.spacing=0.1875", "material.density=" + number(1000 * factor),
                                                "material.parameters.E=" + number(1e3 * factor), "output.particles=0",
                                                "output.pictures=false", "output.report=false"});
  };
  const auto light = of(1e-6), usual = of(1), heavy = of(1e7);
  const double error = usual["error"]["l2_max"];
  EXPECT_NEAR(light["error"]["l2_max"], error, same * error);
  EXPECT_NEAR(heavy["error"]["l2_max"], error, same * error);
}

/// A free ring, clipped cells: hundreds of them with less than a hundredth of a cell's mass.
nlohmann::json cut_ring(const std::string& method, double x, double y, double angle) {
  return result_of_run("hard/cut_ring",
                       {"method=" + method, "grid={spacing: 0.0625, offset: [" + number(x) + ", " + number(y) + "]}",
                        "frame.angle=" + number(angle), "output.errors=20", "output.report=false"});
}

void expect_cut_bodies_live(int count) {
  constexpr const char* total =
      "{basis: bspline2, formulation: total, transfer: aflip, mass: series, terms: 4, integrator: leapfrog, courant: "
      "0.4}";
  double least = INFINITY, most = 0;
  for (int k = 0; k < count; ++k) {  // a Kronecker sequence; the study has hundreds
    const auto part = [&](double step) { return step * k - std::floor(step * k); };
    const auto result = cut_ring(total, part(0.8191725133961645), part(0.6710436067037893), part(0.5497004779019703));
    ASSERT_EQ(result["outcome"], "completed") << k << result["reason"];
    least = std::min(least, result["error"]["l2_max"].get<double>());
    most = std::max(most, result["error"]["l2_max"].get<double>());
  }
  EXPECT_GT(most, least);  // they are cut otherwise
  EXPECT_LT(most, 1.2 * least);
}

TEST(CutBodies, LiveAtAnyOffsetAndAngle) { expect_cut_bodies_live(6); }
TEST(LongCutBodies, LiveAtAnyOffsetAndAngle) { expect_cut_bodies_live(24); }

TEST(CutBodies, FlyOverTheGridWhereverItsNodesLie) {
  for (const char* offset : {"[0, 0]", "[0.999999, 1.0e-6]", "[0.5, 0.25]"}) {
    const auto result =
        result_of_run("hard/flight_1000", {"time.end=1", std::string("grid.offset=") + offset, "grid.upper=[7, 3.5]"});
    EXPECT_EQ(result["outcome"], "completed");
    EXPECT_LT(result["drift"]["momentum"], 1e-12);
    EXPECT_GT(result["health"]["jacobian_min"], 1 - 1e-9);
  }
}

}  // namespace
}  // namespace assay::drivers::test_invariance
