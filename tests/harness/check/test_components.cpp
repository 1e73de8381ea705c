// SPDX-License-Identifier: BSD-3-Clause
// What a harness of the plane 12 is blind to: components 13, 23 and 33 of a stress that are not what they should be.
#include <gtest/gtest.h>

#include <set>

#include "harness/check/component_slip.hpp"
#include "harness/check/tests.hpp"
#include "tests/harness/check/component_mutants.hpp"

namespace assay::check::test_components {
namespace {

using check_tests::Subject;
namespace mutants = check_tests::component_mutants;

/// Each plant is the first thing that is said of the model, with its components by name.
void expect_components_named(const assay_material* table, const std::map<std::string, double>& parameters) {
  const std::vector<Subject> subjects = mutants::of_model(table, parameters);
  for (std::size_t k = 0; k < subjects.size(); ++k) {
    const mutants::Plant& plant = mutants::plants()[k];
    const Report report = check_tests::battery_of(subjects[k], {.effort = {.quick = true}});
    ASSERT_FALSE(report.passes()) << subjects[k].name;
    EXPECT_EQ(report.diagnosis.front().cause, plant.cause) << subjects[k].name;
    EXPECT_NE(report.diagnosis.front().sentence.find(plant.words), std::string::npos)
        << subjects[k].name << ": " << report.diagnosis.front().sentence;
  }
}

TEST(Components, AreNamedOfAModelWithoutHistory) {
  expect_components_named(assay_builtin_neo_hookean(ASSAY_ABI_MAJOR, 0), {{"E", 1e3}});
}

TEST(Components, AreNamedOfAModelWithHistory) {
  expect_components_named(assay_builtin_j2_jaumann(ASSAY_ABI_MAJOR, 0),
                          {{"E", 1e3}, {"yield_stress", 5}, {"kinematic_modulus", 50}});
}

/// Whose stiffness at rest is not looked at: the frames alone tell the component.
TEST(Components, AreNamedOfAnAnisotropicModel) {
  expect_components_named(assay_builtin_orthotropic_cylindrical(ASSAY_ABI_MAJOR, 0), unlike_directions);
}

/// sigma_12 and sigma_21 are right, and no shear in the plane 12 tells.
TEST(Components, ThatDifferAreNamedOneByOne) {
  const auto said = [](const Misreport& misreport) {
    const Material material =
        misreporting_material(assay_builtin_neo_hookean(ASSAY_ABI_MAJOR, 0), "skew_for_tests", misreport, {{"E", 1e3}});
    return symmetry(examine(material, {.effort = {.quick = true}}));
  };
  EXPECT_EQ(said([](Tensor&) {}).verdict, Verdict::pass);
  const TestResult of_one = said([](Tensor& sigma) { sigma(2, 1) *= 1 + 1e-6; });
  EXPECT_EQ(of_one.verdict, Verdict::fail);
  EXPECT_NE(of_one.sentence.find("components 23 and 32 differ"), std::string::npos) << of_one.sentence;
  const TestResult of_all = said([](Tensor& sigma) { sigma.triangularView<Eigen::StrictlyUpper>() *= 2; });
  EXPECT_NE(of_all.sentence.find("components 12 and 21, 13 and 31, 23 and 32 differ"), std::string::npos)
      << of_all.sentence;
}

TEST(Components, ASlipIsUndoneOfStressAndStiffness) {
  Tensor sigma;
  sigma << 1, 2, 3, 2, 4, 5, 3, 5, 6;
  Stiffness C;
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) C(row, column) = 10 * row + column;
  }
  std::set<std::string> words;
  for (const ComponentSlip& slip : component_slips()) {
    EXPECT_TRUE(words.insert(slip.of("a tensor")).second) << slip.of("a tensor");
    Tensor slipped = sigma;
    Stiffness of_slipped = C;
    for (std::size_t c = 0; c < 6; ++c) {
      const auto from = static_cast<std::size_t>(slip.from[c]);
      const auto [i, j] = six_places[c];
      const auto [k, l] = six_places[from];
      slipped(i, j) = slipped(j, i) = slip.times[c] * sigma(k, l);
      of_slipped.row(static_cast<int>(c)) = slip.times[c] * C.row(slip.from[c]);
    }
    EXPECT_EQ(slip.undone(slipped), sigma) << slip.of("a tensor");
    EXPECT_EQ(slip.undone(of_slipped), C) << slip.of("a tensor");
  }
  EXPECT_EQ(words.count("component 23 of a tensor is doubled"), 1u);
  EXPECT_EQ(words.count("components 22 and 33 of a tensor are exchanged"), 1u);
}

}  // namespace
}  // namespace assay::check::test_components
