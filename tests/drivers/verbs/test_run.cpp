// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/verbs/verbs.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "drivers/format/csv.hpp"
#include "drivers/system/input_error.hpp"
#include "tests/drivers/quiet_run.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/built.hpp"

namespace assay::drivers::test_run {
namespace {

/// The paper's vortex on a coarse grid, short and silent.
RunOptions quick(const std::string& out, const std::vector<std::string>& more = {}) {
  std::vector<std::string> sets{"grid.spacing=0.125", "output.particles=2"};
  sets.insert(sets.end(), more.begin(), more.end());
  return quiet_run("paper/vortex_cpdi", out, sets);
}

TEST(Run, LeavesACompleteResult) {
  const ScratchFolder scratch;
  const std::string out = scratch / "out";
  ASSERT_EQ(run(quick(out)), 0);
  for (const char* name : {"result.json", "errors.csv", "resolved.yaml", "particles.pvd", "particles_0000.vtu",
                           "particles_0002.vtu", "error.png", "shear.png", "error_history.png", "report.html"}) {
    EXPECT_TRUE(std::filesystem::exists(out + "/" + name)) << name;
  }
  const auto result = result_in(out);
  EXPECT_EQ(result["outcome"], "completed");
  EXPECT_DOUBLE_EQ(result["t"].get<double>(), 1.0);
  EXPECT_EQ(result["work"]["particle_steps"].get<long>(),
            result["steps"].get<long>() * result["particles"].get<long>());
  EXPECT_EQ(result["provenance"]["scene_sha256"].get<std::string>().size(), 64u);
}

/// The figures of result.json against the table that they come from.
TEST(LongRun, ItsFiguresAreThoseOfItsHistory) {
  const ScratchFolder scratch;
  const std::string out = scratch / "out";
  ASSERT_EQ(run(quick(out)), 0);
  const auto error = result_in(out)["error"];
  const CsvTable csv = read_csv(bytes_of(out + "/errors.csv"), "errors.csv", {"t", "l2", "linf", "rms36"},
                                {"velocity_l2", "velocity_linf", "deformation_gradient_l2", "deformation_gradient_linf",
                                 "jacobian_l2", "jacobian_linf", "stress_l2", "stress_linf"});
  const auto& t = *csv.column("t");
  const auto& l2 = *csv.column("l2");
  double largest = 0, half = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    largest = std::max(largest, l2[i]);
    if (t[i] == 0.5) half = l2[i];
  }
  EXPECT_EQ(t.front(), 0);
  EXPECT_EQ(t.back(), 1);
  EXPECT_EQ(error["l2_max"].get<double>(), largest);
  EXPECT_EQ(error["l2_end"].get<double>(), l2.back());
  EXPECT_GT(half, 0);
  EXPECT_EQ(error["l2_half"].get<double>(), half);
}

TEST(LongRun, RepeatsItselfBitForBitAlsoFromItsResolvedScene) {
  const ScratchFolder scratch;
  const std::string a = scratch / "a", b = scratch / "b", c = scratch / "c";
  ASSERT_EQ(run(quick(a)), 0);
  ASSERT_EQ(run(quick(b)), 0);
  RunOptions again = quick(c);
  again.scene = a + "/resolved.yaml";
  again.sets.clear();
  ASSERT_EQ(run(again), 0);
  for (const char* name : {"errors.csv", "resolved.yaml", "particles.pvd", "particles_0000.vtu", "particles_0001.vtu",
                           "particles_0002.vtu"}) {
    const std::string first = bytes_of(a + "/" + name);
    EXPECT_FALSE(first.empty()) << name;
    EXPECT_EQ(first, bytes_of(b + "/" + name)) << name;
    EXPECT_EQ(first, bytes_of(c + "/" + name)) << name;
  }
}

TEST(LongRun, AnUnstableRunIsAFinding) {
  const ScratchFolder scratch;
  const std::string out = scratch / "out";
  EXPECT_EQ(run(quick(out, {"method.basis=ugimp", "grid.spacing=0.05"})), 1);  // not expected
  const auto result = result_in(out);
  EXPECT_EQ(result["outcome"], "unstable");
  EXPECT_LT(result["t"].get<double>(), 0.5);
  EXPECT_TRUE(result["error"]["l2_end"].is_null());
  EXPECT_TRUE(result["error"]["l2_half"].is_null());
  EXPECT_GT(result["error"]["l2_max"].get<double>(), 0);
  EXPECT_EQ(run(quick(out, {"method.basis=ugimp", "grid.spacing=0.05", "expect={outcome: unstable}"})), 0);
}

TEST(LongRun, AMaterialThatFailsIsAFindingBeforeAndDuringTheSteps) {
  const ScratchFolder scratch;
  const std::string out = scratch / "out";
  const auto material = [](double modulus) {
    return "material={adapter: " + built("tests/plugins/fails_when_sheared.so") +
           ", parameters: {modulus: " + std::to_string(modulus) + "}, density: 1000}";
  };
  EXPECT_EQ(run(quick(out, {material(1000)})), 1);  // on the baseline path
  EXPECT_EQ(result_in(out)["outcome"], "material_failed");
  EXPECT_TRUE(result_in(out)["steps"].is_null());
  // the baseline stays just below the limit; the rotation of the particles adds to it
  EXPECT_EQ(run(quick(out, {material(1000), "motion.amplitude.peak=0.055"})), 1);
  EXPECT_EQ(result_in(out)["outcome"], "material_failed");
  EXPECT_GT(result_in(out)["steps"].get<long>(), 0);
  EXPECT_NE(result_in(out)["reason"].get<std::string>().find("particle"), std::string::npos);
}

TEST(LongRun, AnExpectationThatFailsContradicts) {
  const ScratchFolder scratch;
  EXPECT_EQ(run(quick(scratch / "a", {"expect={error.l2_max: {below: 1e-6}}"})), 1);
  EXPECT_EQ(run(quick(scratch / "b", {"expect={error.l2_max: {below: 1}, outcome: completed}"})), 0);
}

TEST(Run, WithoutABodyForceThereIsNoErrorToTell) {
  const ScratchFolder scratch;
  const std::string out = scratch / "out";
  ASSERT_EQ(run(quick(out, {"force={response: none}", "time.end=0.05"})), 0);
  const auto result = result_in(out);
  EXPECT_TRUE(result["error"]["l2_max"].is_null());
  for (const auto& pass : result["passes"]) EXPECT_NE(pass["name"], "body_force");
}

TEST(LongRun, SquareIsLargerInParticlesButNotInWork) {
  const ScratchFolder scratch;
  const std::string out = scratch / "out";
  ASSERT_EQ(run(quick(out, {"body={domain: square, outside: held}", "grid.spacing=0.1"})), 0);
  const auto result = result_in(out);
  EXPECT_EQ(result["particles"].get<long>(), 30 * 30 * 4);
  const double stepped =
      result["work"]["particle_steps"].get<double>() / static_cast<double>(result["steps"].get<long>());
  EXPECT_NEAR(stepped, 3.1416 * (1.25 * 1.25 - 0.75 * 0.75) / (0.05 * 0.05), 0.05 * stepped);
  const double ratio = result["error"]["l2_max"].get<double>() / result["error"]["rms36_max"].get<double>();
  EXPECT_NEAR(ratio, std::sqrt(3600 / stepped), 1e-9);
}

/// Every body and lattice with either evaluation: it runs, it has its mass, and the error is that of a good run.
TEST(LongRun, EveryLatticeCompletesWithEitherEvaluation) {
  const ScratchFolder scratch;
  for (const char* body : {"body={domain: ring, lattice: polar}", "body={domain: ring, cut: clipped}",
                           "body={domain: square, outside: held}", "body={domain: square, outside: free}"}) {
    for (const char* evaluation : {"force.evaluation=point", "force.evaluation=domain_average"}) {
      for (const char* basis : {"method.basis=cpdi", "method.basis=ugimp"}) {
        const std::string out = scratch / "out";
        ASSERT_EQ(run(quick(out, {body, evaluation, basis, "grid.spacing=0.1", "motion.amplitude.peak=0.1"})), 0)
            << body << " " << evaluation << " " << basis;
        const auto result = result_in(out);
        EXPECT_LT(result["error"]["l2_max"].get<double>(), 0.022) << body << " " << evaluation << " " << basis;
        EXPECT_LT(result["drift"]["mass"].get<double>(), 1e-12) << body;
        EXPECT_LT(result["drift"]["momentum"].get<double>(), 1e-11) << body;
      }
    }
  }
}

TEST(Run, BadInputLeavesNothing) {
  const ScratchFolder scratch;
  const std::string out = scratch / "out";
  for (const char* set : {"grid.spacing=-1", "material.adapter=nothing", "material.parameters.E=.nan",
                          "grid={spacing: 0.05, lower: [-1, -1], upper: [1, 1]}", "limits.memory_gib=1e-6",
                          "limits.particle_steps=10", "motion={type: homogeneous, final: [[2,0,0],[0,1,0],[0,0,1]]}",
                          "method.courant=0", "time.step=1e-300", "method.courant=1e-300", "title=\"\\x1b[31mred\"",
                          "grid={spacing: 0.1, lower: [-1e9, -1e9], upper: [1e9, 1e9]}",
                          "grid={spacing: 0.1, lower: [-1e300, -2], upper: [1e300, 2]}"}) {
    EXPECT_THROW(run(quick(out, {set})), InputError) << set;
    EXPECT_FALSE(std::filesystem::exists(out)) << set;
  }
}

TEST(LongRun, EveryFieldsErrorSeesADissipatingTransfer) {
  const ScratchFolder scratch;
  const std::string good = scratch / "good", bad = scratch / "bad";
  ASSERT_EQ(run(quick(good, {"grid.spacing=0.0625", "time.end=0.3"})), 0);
  ASSERT_EQ(run(quick(bad, {"grid.spacing=0.0625", "time.end=0.3", "method.transfer=pic"})), 0);
  const auto a = result_in(good)["error"], b = result_in(bad)["error"];
  EXPECT_GT(b["l2_max"].get<double>(), 2 * a["l2_max"].get<double>());
  for (const char* field : {"velocity", "deformation_gradient", "stress"}) {
    EXPECT_GT(b[field]["l2_max"].get<double>(), 1.2 * a[field]["l2_max"].get<double>()) << field;
  }
}

/// The sheet and the particles agree on the direction: on another one, or left Cartesian, the error would be large.
TEST(LongRun, ACylindricallyOrthotropicRingMovesAsItShould) {
  const ScratchFolder scratch;
  const std::string out = scratch / "out";
  const std::string wood =
      "material={adapter: orthotropic_cylindrical, density: 1000, parameters: {E_r: 3e3, E_t: 1e3, E_z: 2e3, nu_rt: "
      "0.3, nu_rz: 0.2, nu_tz: 0.25, G_rt: 700, G_rz: 500, G_tz: 400}";
  for (const char* direction : {"}", ", direction: [0.6, 0.8, 0]}"}) {
    double relative[2];
    for (const int fine : {0, 1}) {
      const std::string spacing = fine ? "grid.spacing=0.03125" : "grid.spacing=0.0625";
      ASSERT_EQ(run(quick(out, {wood + direction, "motion.amplitude.peak=0.05", spacing})), 0);
      relative[fine] = result_in(out)["error"]["relative"].get<double>();
    }
    EXPECT_LT(relative[0], 0.2) << direction;
    EXPECT_LT(relative[1], 0.6 * relative[0]) << direction;
  }
  EXPECT_THROW(run(quick(out, {"material.direction=[1, 0, 0]"})), InputError);
}

}  // namespace
}  // namespace assay::drivers::test_run
