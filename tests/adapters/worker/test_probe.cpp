// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/probe.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "adapters/builtin.hpp"
#include "adapters/library.hpp"
#include "tests/support/built.hpp"

namespace assay::adapters::test_probe {
namespace {

std::optional<std::string> probed(const std::string& name, const std::map<std::string, double>& given = {}) {
  return probe_defect(table_of_library(built("tests/plugins/") + name + ".so", ""), given);
}

TEST(Probe, AcceptsModelsThatAnswer) {
  for (const assay_material* table : builtin_tables()) EXPECT_EQ(probe_defect(table, {}), std::nullopt) << table->name;
  EXPECT_EQ(probed("frozen_1_0"), std::nullopt);
  EXPECT_EQ(probed("anisotropic"), std::nullopt);
}

TEST(Probe, SaysWhyAModelIsRefused) {
  EXPECT_EQ(probed("not_finite"), "refuses an undeformed point: the material returned a stress that is not finite");
  EXPECT_EQ(probed("refuses"), "material 'refuses' could not be created: no licence\nfor this model");
  EXPECT_EQ(probed("exits"), "ends the process on an undeformed point");
  EXPECT_TRUE(probed("crashes").value_or("").starts_with("crashes on an undeformed point: "));
  EXPECT_TRUE(probed("anisotropic", {{"modulus", -1}}).value_or("").starts_with("parameter 'modulus': must lie from"));
  EXPECT_TRUE(probed("anisotropic", {{"module", 1}}).value_or("").ends_with("known: modulus, angle"));
}

TEST(Probe, ParametersLieInsideTheirBounds) {
  const double inf = std::numeric_limits<double>::infinity(), none = NAN;
  const assay_parameter list[] = {{"with_default", "1", 0.3, 0, 1, ""}, {"positive", "1", none, 1e-300, 1e300, ""},
                                  {"two_sided", "1", none, -4, 2, ""},  {"below", "1", none, -inf, -3, ""},
                                  {"above", "1", none, 5, inf, ""},     {"free", "1", none, -inf, inf, ""}};
  assay_material table{};
  table.parameter_count = 6;
  table.parameters = list;
  const auto values = probe_parameters(table);
  EXPECT_EQ(values.at("with_default"), 0.3);
  EXPECT_NEAR(values.at("positive"), 1, 1e-12);
  EXPECT_EQ(values.at("two_sided"), -1);
  EXPECT_EQ(values.at("below"), -3);
  EXPECT_EQ(values.at("above"), 5);
  EXPECT_EQ(values.at("free"), 1);
}

}  // namespace
}  // namespace assay::adapters::test_probe
