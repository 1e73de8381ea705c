// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include "adapters/elf_symbols.hpp"
#include "adapters/foreign/foreign_library.hpp"
#include "adapters/worker/remote_table.hpp"
#include "tests/adapters/foreign/foreign_steps.hpp"

namespace assay::adapters::test_absent_routines {
namespace {

Tensor stretched(double by) { return Vector3(1 + by, 1, 1).asDiagonal(); }

TEST(AbsentRoutines, AreAllKnownBeforeTheFirstCall) {
  const std::vector<std::string> expected{"flow_rule_", "report_"};
  EXPECT_EQ(load_foreign_library(double_library("umat_incomplete")).missing, expected);
  const std::vector<std::string> wanted = wanted_symbols(double_library("umat_incomplete"));
  EXPECT_TRUE(std::includes(wanted.begin(), wanted.end(), expected.begin(), expected.end()));
}

TEST(AbsentRoutines, AreToldWithTheModel) {
  EXPECT_STREQ(foreign_table(foreign_double("umat_incomplete"))->doc,
               "; calls flow_rule_ and report_, which nobody provides");
  EXPECT_EQ(missing_words({}), "");
  EXPECT_EQ(missing_words({"a_"}), "calls a_, which nobody provides");
  EXPECT_EQ(missing_words({"a", "b", "c", "d", "e", "f", "g"}),
            "calls a, b, c, d, e and 2 more, which nobody provides");
}

TEST(AbsentRoutines, EndTheCallThatNeedsThemAlone) {
  const StepsOfOnePoint point(foreign_double("umat_incomplete"));
  EXPECT_EQ(point.tried(0, 1, stretched(0), stretched(0.01)).report.worst, ASSAY_GOOD);
  const auto told = [&](double by) { return point.tried(0, 1, stretched(0), stretched(by)).report.message; };
  EXPECT_EQ(told(0.3), "the UMAT called flow_rule_, which nobody provides");
  EXPECT_EQ(told(1), "the UMAT called report_, which nobody provides");
  EXPECT_EQ(point.tried(0, 1, stretched(0), stretched(0.01)).report.worst, ASSAY_GOOD);
}

TEST(AbsentRoutines, AreNamedFromAWorkerThatLives) {
  const assay_material* table = remote_table(
      {"model\ntest.yaml\nlibrary: " + double_library("umat_incomplete") + "\ninterface: umat\nname: incomplete\n"});
  EXPECT_STREQ(table->doc, "umat; calls flow_rule_ and report_, which nobody provides");
  const Material material(table, {});
  const double I[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, F[9] = {1.3, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::vector<double> state0 = material.initial_state(1);
  std::vector<double> state1(state0.size()), cauchy(9);
  for (int k = 0; k < 2; ++k) {
    const UpdateReport report = material.update(0, 1, 1, I, F, state0.data(), state1.data(), cauchy.data());
    EXPECT_EQ(report.message, "the UMAT called flow_rule_, which nobody provides");
  }
  end_workers();
}

}  // namespace
}  // namespace assay::adapters::test_absent_routines
