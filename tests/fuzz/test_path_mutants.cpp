// SPDX-License-Identifier: BSD-3-Clause
// Damaged paths and damaged histories through `assay tabulate`, each in a process of its own within bounds.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "drivers/path/path_result.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/words.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/fuzz/mutants.hpp"
#include "tests/fuzz/run_faults.hpp"
#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::fuzz::test_path_mutants {
namespace {

namespace fs = std::filesystem;

const std::string sources = tree_folder() + "/tests/fuzz/paths/";
const std::string program = built("assay");
const std::string kept = built("mutants/");

const Bounds bounds = sanitized() ? Bounds{.cpu_s = 200} : Bounds{.cpu_s = 20, .address_bytes = std::int64_t{2} << 30};
const Promise promise = sanitized() ? Promise{.cpu_s = 150, .resident_bytes = std::int64_t{1536} << 20}
                                    : Promise{.cpu_s = 15, .resident_bytes = std::int64_t{256} << 20};
constexpr int every_day = 24, every_day_watched = 12;

const Mutants& mutants() {
  static const Mutants all(
      {sources + "tension.yaml", sources + "file.yaml", sources + "triaxial.yaml", sources + "shear.yaml"}, {});
  return all;
}

/// What is wrong with the folder of a path that ended with 0 or 1.
std::vector<std::string> path_folder_faults(const std::string& folder) {
  std::vector<std::string> faults;
  for (const char* name : {"result.json", "resolved.yaml"}) {
    if (!fs::exists(folder + "/" + name)) faults.push_back(std::string("no ") + name);
  }
  if (!faults.empty()) return faults;
  const auto json = nlohmann::json::parse(drivers::read_bytes(folder + "/result.json", 1 << 26), nullptr, false);
  if (json.is_discarded()) return {"result.json is no JSON"};
  const std::string outcome = json.value("outcome", "");
  if (!drivers::is_one_of(outcome, drivers::path_outcomes())) faults.push_back("outcome " + outcome);
  if (outcome != "completed" && json["reason"].is_null()) faults.push_back(outcome + " without a reason");
  if (outcome == "completed" && !fs::exists(folder + "/path.csv")) faults.emplace_back("no path.csv");
  try {
    const std::string file = folder + "/resolved.yaml", text = drivers::read_bytes(file);
    drivers::path_scene_of(drivers::read_yaml(text, file), file, {});
  } catch (const std::exception& error) {
    faults.push_back(std::string("resolved.yaml does not read back: ") + error.what());
  }
  return faults;
}

struct Damaged {
  std::string scene, history;
};

std::vector<std::string> faults_of_damaged(const Damaged& damaged, std::map<int, int>& statuses) {
  const drivers::ScratchFolder scratch;
  ::setenv("ASSAY_DATA_HOME", (scratch / "data").c_str(), 1);
  ::unsetenv("ASSAY_MATERIAL_PATH");
  scratch.write("scene.yaml", damaged.scene);
  scratch.write("history.csv", damaged.history);
  const Outcome outcome =
      run_bounded(program, {"tabulate", "scene.yaml", "-o", "out", "--quiet"}, scratch / "", bounds);
  ++statuses[outcome.status];
  std::vector<std::string> faults = process_faults(outcome, promise);
  const std::string folder = scratch / "out";
  if (outcome.status == 0 || outcome.status == 1) {
    for (std::string& fault : path_folder_faults(folder)) faults.push_back(std::move(fault));
  } else if (fs::exists(folder)) {
    faults.emplace_back("bad input, and a folder of results");
  }
  if (!faults.empty()) faults.push_back("said: " + outcome.error.substr(0, 2000));
  return faults;
}

void complain(const std::string& name, const Damaged& damaged, const std::vector<std::string>& faults) {
  fs::create_directories(kept);
  std::ofstream(kept + name + ".yaml", std::ios::binary) << damaged.scene;
  std::ofstream(kept + "history.csv", std::ios::binary) << damaged.history;
  std::string text = name + "\n";
  for (const std::string& fault : faults) text += "  " + fault + "\n";
  ADD_FAILURE() << text << "again: " << program << " tabulate " << kept << name << ".yaml\n" << damaged.scene;
}

void run_damaged(int first, int count, int stride) {
  std::map<int, int> statuses;
  const std::string history = drivers::read_bytes(sources + "history.csv"),
                    of_file = drivers::read_bytes(sources + "file.yaml");
  for (int k = 0; k < count; ++k) {
    const int number = first + k * stride;
    Damaged damaged{mutants().at(number).text, history};
    if (number % 4 == 3) {  // the file in place of the scene
      damaged = {of_file, history};
      Dice dice(static_cast<std::uint64_t>(number));
      for (std::size_t times = 1 + dice.below(4); times > 0; --times) damage_bytes(damaged.history, dice);
      if (dice.one_in(5)) truncate(damaged.history, dice);
    }
    const std::vector<std::string> faults = faults_of_damaged(damaged, statuses);
    if (!faults.empty()) complain("path_" + std::to_string(number), damaged, faults);
  }
  for (const auto& [status, number] : statuses) std::printf("exit %d: %d  ", status, number);
  std::printf("\n");
}

TEST(PathMutants, BasesEndAsTheyShould) {
  for (const Mutants::Base& base : mutants().bases()) {
    std::map<int, int> statuses;
    EXPECT_EQ(faults_of_damaged({base.text, drivers::read_bytes(sources + "history.csv")}, statuses),
              std::vector<std::string>{})
        << base.name;
    EXPECT_EQ(statuses, (std::map<int, int>{{0, 1}})) << base.name;
  }
}

TEST(PathMutants, EndWithAStatusAndALine) { run_damaged(0, sanitized() ? every_day_watched : every_day, 17); }

TEST(LongPathMutants, EndWithAStatusAndALine) { run_damaged(0, 1000, 1); }

}  // namespace
}  // namespace assay::fuzz::test_path_mutants
