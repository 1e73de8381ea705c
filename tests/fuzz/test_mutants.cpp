// SPDX-License-Identifier: BSD-3-Clause
// Thousands of damaged scenes through `assay run`, each in a process of its own within bounds of time and memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "tests/drivers/scratch_folder.hpp"
#include "tests/fuzz/mutants.hpp"
#include "tests/fuzz/run_faults.hpp"
#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::fuzz::test_mutants {

namespace {

namespace fs = std::filesystem;

const std::string sources = tree_folder() + "/tests/fuzz/scenes/";
const std::string program = built("assay");
const std::string kept = built("mutants/");  ///< those that found a fault

/// A mutant may ask for much: it is refused beyond 100 times the particle-steps of the scenes that it was made from, or
/// two periods of a sheet of a material with a history.
const std::vector<std::string> limits{"limits.particle_steps=100000", "limits.memory_gib=0.01"};

const Bounds bounds = sanitized() ? Bounds{.cpu_s = 200} : Bounds{.cpu_s = 20, .address_bytes = std::int64_t{2} << 30};
const Promise promise = sanitized() ? Promise{.cpu_s = 150, .resident_bytes = std::int64_t{1536} << 20}
                                    : Promise{.cpu_s = 15, .resident_bytes = std::int64_t{256} << 20};
const int in_sample = sanitized() ? 20 : 60;

const Mutants& mutants() {
  static const Mutants all = mutants_of_the_tree();
  return all;
}

std::vector<std::string> words_for(const std::string& scene, const std::string& out) {
  std::vector<std::string> words{"run", scene, "-o", out, "--quiet", "--threads", "1"};
  for (const std::string& limit : limits) words.insert(words.end(), {"--set", limit});
  return words;
}

struct Tally {
  std::map<int, int> statuses;
  double cpu_s = 0, longest = 0;
  std::int64_t most_bytes = 0;

  void add(const Outcome& outcome) {
    ++statuses[outcome.status];
    cpu_s += outcome.cpu_s;
    longest = std::max(longest, outcome.cpu_s);
    most_bytes = std::max(most_bytes, outcome.resident_bytes);
  }
  void print() const {
    std::printf("%.0f s of CPU in all, longest %.2f s, most memory %lld MiB; exit", cpu_s, longest,
                static_cast<long long>(most_bytes >> 20));
    for (const auto& [status, count] : statuses) std::printf(" %d: %d", status, count);
    std::printf("\n");
  }
};

/// A home without materials of anybody's; sheets are kept as long as the test lasts.
void use_own_home() {
  static const drivers::ScratchFolder home;
  ::setenv("ASSAY_DATA_HOME", (home / "data").c_str(), 1);
  ::setenv("ASSAY_CACHE_HOME", (home / "cache").c_str(), 1);
  ::unsetenv("ASSAY_MATERIAL_PATH");
}

/// Runs one in a folder of its own, which is gone afterwards.
std::vector<std::string> faults_of_text(const std::string& text, Tally& tally) {
  use_own_home();
  const drivers::ScratchFolder scratch;
  scratch.write("scene.yaml", text);
  fs::copy_file(sources + "path.csv", scratch / "path.csv");
  const Outcome outcome = run_bounded(program, words_for("scene.yaml", "out"), scratch / "", bounds);
  tally.add(outcome);
  std::vector<std::string> faults = faults_of(outcome, scratch / "out", promise);
  if (!faults.empty() && !outcome.error.empty()) faults.push_back("said: " + outcome.error.substr(0, 4000));
  return faults;
}

/// Leaves the mutant where a person can run it, and says how.
std::string complaint(const Mutant& mutant, const std::vector<std::string>& faults) {
  fs::create_directories(kept);
  std::error_code ignored;
  fs::copy_file(sources + "path.csv", kept + "path.csv", ignored);
  const std::string file = kept + std::to_string(mutant.number) + ".yaml";
  std::ofstream(file, std::ios::binary) << mutant.text;
  std::string text = "mutant " + std::to_string(mutant.number) + " of " + mutant.base + ", " + mutant.kind + "\n";
  for (const std::string& fault : faults) text += "  " + fault + "\n";
  text += "again: " + program;
  for (const std::string& word : words_for(file, kept + "out")) text += " " + word;
  return text + "\n" + mutant.text;
}

/// `count` numbers from `first` on, each `stride` after the one before.
void run_mutants(int first, int count, int stride = 1) {
  Tally tally;
  for (int k = 0; k < count; ++k) {
    const Mutant mutant = mutants().at(first + k * stride);
    const std::vector<std::string> faults = faults_of_text(mutant.text, tally);
    if (!faults.empty()) ADD_FAILURE() << complaint(mutant, faults);
  }
  tally.print();
}

TEST(Mutants, BasesRunAsTheyAre) {
  ASSERT_GE(mutants().bases().size(), 12u);
  for (const Mutants::Base& base : mutants().bases()) {
    Tally tally;
    EXPECT_EQ(faults_of_text(base.text, tally), std::vector<std::string>{}) << base.name;
    EXPECT_EQ(tally.statuses, (std::map<int, int>{{0, 1}})) << base.name;
  }
}

TEST(Mutants, AreTheSameEachTimeAndOfEveryKind) {
  std::map<std::string, int> kinds;
  for (int number = 0; number < 1000; ++number) {
    const Mutant mutant = mutants().at(number);
    EXPECT_EQ(mutant.text, mutants().at(number).text);
    ++kinds[mutant.kind];
  }
  EXPECT_EQ(kinds.size(), 7u);
  for (const auto& [kind, count] : kinds) EXPECT_GE(count, 30) << kind;
}

class Sample : public testing::TestWithParam<int> {};

/// Spread over all kinds and scenes: what runs every day, and under the sanitizers.
TEST_P(Sample, EndsWithAStatusAndALine) { run_mutants(GetParam() * 127, in_sample, 7); }

INSTANTIATE_TEST_SUITE_P(Mutants, Sample, testing::Range(0, 5));  // the counts stand in tests/yaml.cmake, too

class LongMutants : public testing::TestWithParam<int> {};

TEST_P(LongMutants, EndWithAStatusAndALine) { run_mutants(1000 * GetParam(), 1000); }

INSTANTIATE_TEST_SUITE_P(Thousand, LongMutants, testing::Range(0, 10));

}  // namespace

}  // namespace assay::fuzz::test_mutants
