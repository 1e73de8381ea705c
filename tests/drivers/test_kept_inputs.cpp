// SPDX-License-Identifier: BSD-3-Clause
// No output replaces what a command has read.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/drivers/process.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_kept_inputs {
namespace {

namespace fs = std::filesystem;

class KeptInputs : public testing::Test {
 protected:
  KeptInputs() {
    scratch_.write("t.csv", "t,F11,F12,F21,F22,F33\n0,1,0,0,1,1\n0.5,1.1,0,0,1,1\n1,1.2,0,0,1,1\n");
    scratch_.write("X.csv", "X,Y,t\n0,0,0.5\n");
    fs::copy(built("materials/libneo_hookean.so"), scratch_ / "p.so");
    scratch_.write("s.yaml", scene("t.csv"));
  }

  static std::string scene(const std::string& table) {
    return "motion: {type: homogeneous, path: " + table +
           "}\nmaterial: {adapter: ./p.so, parameters: {E: 1.0e+3}, density: 1000}\n"
           "body: {domain: square, lower: [0, 0], upper: [1, 1]}\ngrid: {spacing: 0.5}\n"
           "method: {basis: cpdi, transfer: flip}\ntime: {end: 0.1}\n";
  }

  /// The command ends with 2, one line with the phrase, and the file as it was.
  void refuses(std::vector<std::string> words, const std::string& file, const std::string& phrase) const {
    const std::string before = bytes_of(scratch_ / file);
    const Ending ending = assay(words, [this] { fs::current_path(scratch_ / "."); });
    EXPECT_EQ(ending.status, 2) << words[0] << " " << file << ": " << ending.said;
    EXPECT_EQ(std::count(ending.said.begin(), ending.said.end(), '\n'), 1) << ending.said;
    EXPECT_NE(ending.said.find(phrase), std::string::npos) << ending.said;
    EXPECT_EQ(bytes_of(scratch_ / file), before) << words[0] << " " << file;
    EXPECT_FALSE(fs::exists(scratch_ / "out/result.json"));
  }

  ScratchFolder scratch_;
};
using LongKeptInputs = KeptInputs;

TEST_F(LongKeptInputs, AreNotReplacedByAFile) {
  const std::string phrase = "would replace an input of that name";
  fs::create_hard_link(scratch_ / "p.so", scratch_ / "other.so");
  for (const char* file : {"s.yaml", "t.csv", "p.so", "other.so"})
    refuses({"run", "s.yaml", "-o", "out", "--junit", file}, file, phrase);
  for (const char* file : {"s.yaml", "t.csv", "p.so", "X.csv"})
    refuses({"eval", "s.yaml", "--points", "X.csv", "-o", file}, file, phrase);
  for (const char* option : {"--json", "--junit"})
    refuses({"check", "./p.so", "--quick", "-o", "out", option, "p.so"}, "p.so", phrase);
}

TEST_F(KeptInputs, ASourceIsNotReplaced) {
  fs::copy(tree_folder() + "/configs/umat/j2_kinematic.f", scratch_ / "m.f");
  refuses({"check", "m.f", "--props", "210e3,.3,250,1e3", "--statev", "12", "-o", "out", "--json", "m.f"}, "m.f",
          "would replace an input of that name");
}

TEST_F(KeptInputs, AreNotReplacedByAFolder) {
  const std::string phrase = "would be replaced by the result";
  fs::create_directories(scratch_ / "R");
  std::string within = scene("../t.csv");
  scratch_.write("R/resolved.yaml", within.replace(within.find("./p.so"), 6, "../p.so"));
  refuses({"run", "R/resolved.yaml", "-o", "R"}, "R/resolved.yaml", phrase);
  fs::copy(scratch_ / "t.csv", scratch_ / "R/curve.csv");
  scratch_.write("c.yaml", scene("R/curve.csv"));
  refuses({"run", "c.yaml", "-o", "R"}, "R/curve.csv", phrase);
}

}  // namespace
}  // namespace assay::drivers::test_kept_inputs
