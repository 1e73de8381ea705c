// SPDX-License-Identifier: BSD-3-Clause
// What `eval` writes where not all is wanted: columns, times for all points, b without inertia.
#include <gtest/gtest.h>

#include "drivers/format/csv.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/verbs/verbs.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_eval_columns {
namespace {

const std::string ring = tree_folder() + "/configs/paper/vortex_cpdi.yaml";
const std::string ball =
    "motion: {type: vortex3d, axis: [1, 2, 3], amplitude: {peak: 0.5}}\n"
    "material: {adapter: mooney_rivlin, parameters: {c10: 120, c01: 60, bulk_modulus: 900}, density: 1000}\n";
const std::string framed =
    "dimension: 3\nmotion: {type: vortex, amplitude: {peak: 0.5}}\nframe: {spin: 0.7, velocity: [1, 2]}\n"
    "material: {adapter: neo_hookean, parameters: {E: 1000, nu: 0.3}, density: 1000}\n";
const std::string box =
    "motion: {type: axis_aligned, amplitude: {peak: 0.05}}\n"
    "material: {adapter: neo_hookean, parameters: {E: 1000, nu: 0.3}, density: 1000}\n";
const std::string stretch =
    "motion: {type: rotating_stretch, stretch: 0.06, shear: 0.08, rotation: 1.1, axis: [1, 2, 3]}\n"
    "material: {adapter: zener, parameters: {E: 1e6, relaxation_time: 0.3}, density: 1000}\n";

class EvalColumns : public testing::Test {
 protected:
  std::string text(const std::string& columns, const std::string& points, const std::string& times = {},
                   bool is_static = false) {
    EvalOptions options;
    options.scene = scene_;
    options.points = scratch_.write("points.csv", points);
    options.out = scratch_ / "out.csv";
    options.columns = columns;
    options.times = times;
    options.is_static = is_static;
    options.verbosity = Verbosity::quiet;
    EXPECT_EQ(eval(options), 0);
    return bytes_of(options.out);
  }
  std::vector<std::vector<std::string>> rows_of(const std::string& text) {
    std::vector<std::vector<std::string>> rows;
    CsvLines lines(text, name_);
    while (const auto fields = lines.next()) rows.push_back(mapped(*fields, &CsvField::text));
    return rows;
  }
  std::string refusal(const std::string& columns, const std::string& points, const std::string& times = {}) {
    try {
      text(columns, points, times);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
  ScratchFolder scratch_;
  std::string scene_ = ring, name_ = "out.csv";
};
using LongEvalColumns = EvalColumns;

/// Each column by itself holds the same text as in the full table, whatever else is left out.
TEST_F(LongEvalColumns, AreThoseOfTheFullTable) {
  const std::string plane = "X,Y,t\n0.9,0.3,0.4\n-0.2,1.1,0.7\n0.5,0.7,0.4\n1.4,0,0.3\n0.9,0.3,0.7\n";
  const std::string space = "X,Y,Z,t\n0.4,0.3,0.2,0.4\n-0.2,0.1,0.1,0.7\n0.5,0.2,0,0.4\n0.4,0.3,0.2,0.7\n";
  const std::vector<std::pair<std::string, std::string>> scenes{
      {ring, plane},
      {scratch_.write("ball.yaml", ball), space},
      {scratch_.write("framed.yaml", framed), space},
      {scratch_.write("box.yaml", box), "X,Y,t\n0.9,0.3,0.4\n0.2,0.1,0.7\n0.9,0.3,0.2\n"},
      {scratch_.write("stretch.yaml", stretch), space}};
  for (const auto& [scene, points] : scenes) {
    scene_ = scene;
    const auto full = rows_of(text("", points));
    for (std::size_t c = 0; c < full[0].size(); ++c) {
      const auto one = rows_of(text(full[0][c], points));
      ASSERT_EQ(one.size(), full.size());
      for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i][0], full[i][c]) << scene << " " << full[0][c];
    }
  }
}

TEST_F(EvalColumns, StandInTheOrderAskedFor) {
  const std::string points = "X,Y,t\n0.9,0.3,0.4\n";
  const auto full = rows_of(text("", points)), some = rows_of(text("by,x,F,t", points));
  EXPECT_EQ(some[0], (std::vector<std::string>{"by", "x", "F11", "F12", "F21", "F22", "F33", "t"}));
  EXPECT_EQ(some[1][0], full[1].back());
  EXPECT_EQ(some[1][1], full[1][3]);
  EXPECT_EQ(some[1].back(), "0.4");
  EXPECT_TRUE(refusal("bxx", points).starts_with("--columns: unknown column 'bxx' (nearest: bx)"));
  EXPECT_EQ(refusal("bz", points), "--columns: column 'bz' is there in three dimensions alone");
}

/// Without stress there is nothing to tabulate: a material that has no response at all is not asked.
TEST_F(EvalColumns, TheMotionAloneNeedsNoResponse) {
  scene_ = scratch_.write("closed.yaml",
                          "motion: {type: vortex, amplitude: {peak: 0.5}}\nforce: {response: closed_form}\n"
                          "material: {adapter: zener, parameters: {E: 1e6, relaxation_time: 0.3}, density: 1000}\n");
  const std::string points = "X,Y,t\n0.9,0.3,0.4\n";
  EXPECT_NE(refusal("bx", points).find("offers no closed form"), std::string::npos) << refusal("bx", points);
  EXPECT_EQ(refusal("x,v,a,F", points), "accepted");
}

TEST_F(EvalColumns, TimesForAllPoints) {
  const std::string listed = text("", "X,Y,t\n0.9,0.3,0\n1,0,0\n0.9,0.3,0.5\n1,0,0.5\n0.9,0.3,0.25\n1,0,0.25\n");
  const std::string points = "X,Y\n0.9,0.3\n1,0\n";
  EXPECT_EQ(text("", points, "0,.5,.25"), listed);
  EXPECT_EQ(text("", points, scratch_.write("times", "0\n.5\n.25\n")), listed);
  EXPECT_EQ(text("", points, scratch_.write("times.csv", "t\n0\n.5\n.25\n")), listed);
  EXPECT_EQ(refusal("", "X,Y,t\n1,0,0\n", "0,1"),
            "--times: the points have a column t: leave out the column or the option");
  EXPECT_NE(refusal("", points).find("no column 't': each row has its time in a column t, or --times gives the times"),
            std::string::npos);
}

/// b = a - DIV(P)/rho0.
TEST_F(EvalColumns, StaticIsBWithoutInertia) {
  constexpr double rounding = 1e-12;
  const std::string points = "X,Y,t\n0.9,0.3,0.4\n-0.2,1.1,0.7\n1.4,0,0.3\n";
  const auto whole = rows_of(text("b,a", points)), still = rows_of(text("b", points, "", true));
  for (std::size_t i = 1; i < whole.size(); ++i) {
    for (std::size_t d = 0; d < 2; ++d) {
      const double b = std::stod(whole[i][d]), a = std::stod(whole[i][d + 2]);
      EXPECT_NEAR(std::stod(still[i][d]), b - a, rounding * (std::abs(a) + std::abs(b))) << i;
    }
  }
}

}  // namespace
}  // namespace assay::drivers::test_eval_columns
