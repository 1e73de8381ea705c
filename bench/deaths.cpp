// SPDX-License-Identifier: BSD-3-Clause
// Whether runs are said to have died when their particles broke down.
//   deaths RESULTS...   folders of `assay study`: of each case that ended early, when that was reported and when a loop
//                       without a watch sees the first breakdown; exit 1 where they are more than 1 % of the run apart
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/drivers/simulation/first_breakdown.hpp"

namespace {

namespace fs = std::filesystem;
constexpr double share_of_run = 0.01;

/// False where the two times are apart.
bool compare(const fs::path& folder) {
  std::ifstream file(folder / "result.json");
  if (!file) return true;
  const auto result = nlohmann::json::parse(file);
  const std::string outcome = result["outcome"];
  if (outcome != "unstable" && outcome != "material_failed") return true;
  const double told = result["t"];
  const auto first = assay::drivers::first_breakdown(folder / "case.yaml", {"output.pictures=false"});
  const bool same = std::abs(told - first.t) <= share_of_run * first.run;
  std::printf("%s %-6s t %.5g, first %.5g of %.4g s (%s); %s\n", folder.filename().c_str(), same ? "same" : "APART",
              told, first.t, first.run, first.what.c_str(), result["reason"].get<std::string>().c_str());
  std::fflush(stdout);
  return same;
}

}  // namespace

int main(int count, char** words) try {
  int apart = 0, cases = 0;
  for (int k = 1; k < count; ++k) {
    for (const auto& entry : fs::directory_iterator(fs::path(words[k]) / "cases")) {
      ++cases;
      if (!compare(entry.path())) ++apart;
    }
  }
  std::printf("%d cases, %d apart\n", cases, apart);
  return apart > 0 ? 1 : 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
