// SPDX-License-Identifier: BSD-3-Clause
// A study, and what reads it, beside programs that keep all processors busy.
#include <gtest/gtest.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "drivers/study/analysis/clock.hpp"
#include "drivers/study/run/runner.hpp"
#include "tests/drivers/study/study_program.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_busy_machine {
namespace {

using Json = nlohmann::json;

const std::string words = "times were measured while other programs used ";

/// One busy loop for each processor, as long as this lives.
class BusyLoops {
 public:
  BusyLoops() {
    for (int k = 0; k < cores_of(machine_name()); ++k) {
      loops_.emplace_back("/bin/sh", std::vector<std::string>{"-c", "while :; do :; done"}, 0.0);
    }
  }
  BusyLoops(const BusyLoops&) = delete;
  BusyLoops& operator=(const BusyLoops&) = delete;

 private:
  std::vector<CaseProcess> loops_;
};

/// Without the line breaks of the terminal.
std::string unwrapped(std::string text) {
  for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos;) {
    const std::size_t end = text.find_first_not_of(" \n", at);
    text.replace(at, (end == text.npos ? text.size() : end) - at, " ");
  }
  return text;
}

TEST(LongBusyMachine, StudyReportComparisonAndRecommendationSaySo) {
  const SmallStudy small(
      "scene: " + tree_folder() +
      "/configs/paper/vortex_square.yaml\n"
      "set: {output.errors: 5, output.pictures: false, body.outside: free, time.end: 0.05, grid.spacing: 0.375}\n"
      "axes: {method: {CPDI: {method.basis: cpdi}}}\ntiming: {repeat: 1, seconds: 1}\n");
  {
    const BusyLoops loops;
    const Ending ended = small.run("busy");
    EXPECT_EQ(ended.status, 0) << ended.said;
    EXPECT_NE(unwrapped(ended.said).find("warning: " + words), std::string::npos) << ended.said;
  }
  const std::string folder = small.scratch / "busy";
  const Json load = Json::parse(bytes_of(folder + "/study.json")).at("load");
  EXPECT_TRUE(load.at("noticeable").get<bool>()) << load;
  EXPECT_GT(load.at("share").get<double>(), disturbing_share) << load;
  EXPECT_EQ(load.at("timed"), 1) << load;
  EXPECT_NE(bytes_of(folder + "/report.html").find(words), std::string::npos);
  const Ending compared = assay({"compare", folder, folder}), as_json = assay({"compare", folder, folder, "--json"});
  EXPECT_NE(unwrapped(compared.said).find("warning: B: " + words), std::string::npos) << compared.said;
  EXPECT_EQ(Json::parse(as_json.said).at("load").at("a"), load);
  const Ending advice = assay({"recommend", folder, "--error", "1000 %"});
  EXPECT_NE(unwrapped(advice.said).find("warning: " + words), std::string::npos) << advice.said;
  EXPECT_EQ(Json::parse(assay({"recommend", folder, "--error", "1000 %", "--json"}).said).at("load"), load);
}

}  // namespace
}  // namespace assay::drivers::test_busy_machine
