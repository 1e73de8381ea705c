// SPDX-License-Identifier: BSD-3-Clause
// The snapshots of our own runs, judged, have the errors of errors.csv.
#include <gtest/gtest.h>

#include <filesystem>

#include "drivers/output/errors_csv.hpp"
#include "tests/drivers/judge/planted.hpp"
#include "tests/support/some_of.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_judge_of_runs {
namespace {

namespace fs = std::filesystem;

/// Columns of numbers under their names, NaN for an empty field.
std::vector<std::vector<double>> rows_of(const std::string& text) {
  std::vector<std::vector<double>> rows;
  for (std::size_t at = text.find('\n') + 1; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    std::vector<double> row;
    for (const std::string& field : split(text.substr(at, end - at), ','))
      row.push_back(field.empty() ? NAN : std::stod(field));
    rows.push_back(row);
    at = end + 1;
  }
  return rows;
}

class JudgeOfRuns : public testing::TestWithParam<const char*> {};

TEST_P(JudgeOfRuns, EqualsTheErrorsOfTheRun) {
  constexpr double alike = 1e-12;    // of the largest error
  constexpr double rounding = 1e-9;  // [s]
  const ScratchFolder scratch;
  RunOptions options;
  options.scene = tree_folder() + "/configs/" + GetParam();
  options.out = scratch / "run";
  options.sets = {"expect={}", "output.particles=5", "output.errors=5", "output.pictures=false", "output.report=false"};
  options.verbosity = Verbosity::quiet;
  ASSERT_EQ(run(options), 0);
  const std::vector<std::vector<double>> expected = rows_of(bytes_of(scratch / "run/errors.csv"));
  JudgeOptions judge;
  judge.scene = options.scene;
  judge.sets = options.sets;
  judge.runs = {scratch / "run"};
  judge.out = scratch / "verdict";
  judge.verbosity = Verbosity::quiet;
  testing::internal::CaptureStdout();
  EXPECT_EQ(judge_runs(judge), 0);
  const std::string said = testing::internal::GetCapturedStdout();
  const std::vector<std::vector<double>> found = rows_of(bytes_of(scratch / "verdict/errors.csv"));
  std::vector<double> largest(expected.front().size(), 0);
  for (const auto& row : expected) {
    for (std::size_t c = 0; c < row.size(); ++c) largest[c] = std::max(largest[c], std::abs(row[c]));
  }
  std::size_t compared = 0;
  for (const auto& row : found) {
    const auto same =
        std::ranges::find_if(expected, [&](const auto& other) { return std::abs(other[0] - row[0]) < rounding; });
    if (same == expected.end()) continue;
    ++compared;
    constexpr std::size_t rms36 = 3;  // of particles that are held, a run knows
    for (std::size_t c = 1; c < row.size(); ++c) {
      if (c == rms36) continue;
      EXPECT_NEAR(row[c], (*same)[c], alike * std::max(largest[c], 1e-3)) << "column " << c << " at " << row[0];
    }
  }
  EXPECT_GE(compared, 5u) << said;
}

const auto cases_of_judge_of_runs = one_of_each<JudgeOfRuns::ParamType>(
    4,
    testing::Values("paper/vortex_cpdi.yaml", "motions/twisting_ring.yaml", "motions/rotating_stretch.yaml",
                    "motions/axis_aligned.yaml", "motions/bar_1d.yaml", "motions/rigid.yaml",
                    "motions/homogeneous_biaxial.yaml", "motions/homogeneous_shear.yaml", "frames/vortex_rotation.yaml",
                    "frames/vortex_translation.yaml", "space/ball_mooney_rivlin.yaml", "space/homogeneous.yaml",
                    "space/rotating_stretch.yaml", "space/axis_aligned.yaml", "space/frame.yaml"));
const auto name_of_judge_of_runs = [](const auto& info) { return "scene_" + std::to_string(info.index); };
INSTANTIATE_TEST_SUITE_P(Scenes, JudgeOfRuns, testing::ValuesIn(cases_of_judge_of_runs.some), name_of_judge_of_runs);
INSTANTIATE_TEST_SUITE_P(LongScenes, JudgeOfRuns, testing::ValuesIn(cases_of_judge_of_runs.others),
                         name_of_judge_of_runs);

}  // namespace
}  // namespace assay::drivers::test_judge_of_runs
