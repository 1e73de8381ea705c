// SPDX-License-Identifier: BSD-3-Clause
// Foreign models through the program itself.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "drivers/text/numbers.hpp"
#include "tests/drivers/material/fortran_texts.hpp"
#include "tests/drivers/process.hpp"
#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"
#include "tests/support/wait.hpp"

namespace assay::drivers::test_foreign_models {
namespace {

namespace fs = std::filesystem;

const std::string configs = tree_folder() + "/configs/foreign/";
const std::string descriptions = tree_folder() + "/tests/adapters/foreign/";
const std::string doubles = built("tests/foreign/");

/// The program, where the scenes' models are found.
Ending assay_with_doubles(const std::vector<std::string>& words) {
  return assay(words, [] { setenv("ASSAY_MATERIAL_PATH", doubles.c_str(), 1); });
}

bool built(const std::string& name) { return fs::exists(doubles + name + ".so"); }

/// Columns of an errors.csv.
std::vector<std::vector<double>> columns_of(const std::string& file) {
  std::istringstream in(bytes_of(file));
  std::vector<std::vector<double>> columns;
  std::string line, cell;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    for (std::size_t k = 0; std::getline(cells, cell, ','); ++k) {
      if (columns.size() <= k) columns.emplace_back();
      columns[k].push_back(parse_number(cell).value_or(0));
    }
  }
  return columns;
}

class ForeignVortex : public testing::TestWithParam<const char*> {};
using LongForeignVortex = ForeignVortex;

TEST_P(LongForeignVortex, AgreesWithTheNativeModel) {
  constexpr double agreement = 1e-12;  // of the largest value of each column
  const std::string name = GetParam();
  if (!built(name + "_neo_hookean")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const std::string scene = configs + "vortex_" + name + ".yaml";
  const Ending foreign = assay_with_doubles({"run", scene, "-o", scratch / "foreign", "--quiet", "--threads", "2"});
  ASSERT_EQ(foreign.status, 0) << foreign.said;
  const Ending native =
      assay_with_doubles({"run", scene, "-o", scratch / "native", "--quiet", "--set",
                          "material={adapter: neo_hookean, density: 1000, parameters: {E: 1.0e3, nu: 0.3}}"});
  ASSERT_EQ(native.status, 0) << native.said;
  const auto found = columns_of(scratch / "foreign/errors.csv"), expected = columns_of(scratch / "native/errors.csv");
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    double largest = 0;
    for (const double value : expected[k]) largest = std::max(largest, std::abs(value));
    ASSERT_EQ(found[k].size(), expected[k].size());
    for (std::size_t row = 0; row < found[k].size(); ++row) {
      EXPECT_NEAR(found[k][row], expected[k][row], agreement * largest) << k << " " << row;
    }
  }
  const std::string profile = bytes_of(scratch / "foreign/result.json");
  EXPECT_NE(profile.find("\"isolation\""), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Interfaces, LongForeignVortex, testing::Values("umat", "vumat", "mfront"),
                         [](const auto& instance) { return std::string(instance.param); });

/// What `tabulate` found of the small J2 scene.
struct Tabulated {
  std::vector<std::vector<double>> sheet;
  nlohmann::json result;
};
Tabulated tabulated(const ScratchFolder& scratch, const std::string& name, const std::string& material) {
  std::vector<std::string> words{"tabulate",
                                 configs + "../umat/j2_small.yaml",
                                 "-o",
                                 scratch / name,
                                 "--quiet",
                                 "--set",
                                 "force.tolerance=1e-5",
                                 "--set",
                                 "expect={}"};
  if (!material.empty()) words.insert(words.end(), {"--set", "material=" + material});
  const Ending ending = assay_with_doubles(words);
  EXPECT_EQ(ending.status, 0) << ending.said;
  return {columns_of(scratch / (name + "/sheet.csv")),
          nlohmann::json::parse(bytes_of(scratch / (name + "/result.json")))};
}

/// A UMAT with kinks, whether another state counts plastic strain or holds a back stress alone: bounds of counts, which
/// do not depend on the machine. Its own error of first order costs it several times the calls of the built-in model.
TEST(LongForeignModels, AUmatOfJ2TakesCountedCallsAndFewHandOvers) {
  if (!built("umat_j2")) GTEST_SKIP() << "no Fortran compiler";
  constexpr double agreement = 2e-5, more_calls = 8;  // of the largest value; over those of the built-in model
  constexpr std::int64_t calls_a_hand_over = 500;
  const ScratchFolder scratch;
  const Tabulated native = tabulated(
      scratch, "native",
      "{adapter: j2_jaumann, density: 1000, parameters: {E: 1.0e3, nu: 0.3, yield_stress: 5, kinematic_modulus: 50}}");
  EXPECT_EQ(native.result["work"]["hand_overs"], 0);
  for (const std::string& material : {std::string(), "{adapter: " + descriptions + "umat_j2_back_stress_alone.yaml}"}) {
    const Tabulated umat = tabulated(scratch, "umat", material);
    const auto calls = umat.result["work"]["material_calls"].get<std::int64_t>(),
               native_calls = native.result["work"]["material_calls"].get<std::int64_t>(),
               hand_overs = umat.result["work"]["hand_overs"].get<std::int64_t>();
    EXPECT_LT(static_cast<double>(calls), more_calls * static_cast<double>(native_calls)) << material;
    EXPECT_GT(hand_overs, 0);
    EXPECT_GT(calls, calls_a_hand_over * hand_overs) << material;
    EXPECT_LE(umat.result["work"]["wake_ups"].get<std::int64_t>(), 2 * hand_overs + 10) << material;
    EXPECT_LT(umat.result["sheet"]["error_tau"].get<double>(), 1e-5) << material;
    ASSERT_EQ(umat.sheet.size(), native.sheet.size());
    constexpr std::size_t tau12 = 4;
    double largest = 0;
    for (const double value : native.sheet[tau12]) largest = std::max(largest, std::abs(value));
    for (std::size_t row = 0; row < native.sheet[tau12].size(); ++row) {
      EXPECT_NEAR(umat.sheet[tau12][row], native.sheet[tau12][row], agreement * largest) << material << " " << row;
    }
  }
}

TEST(LongForeignModels, ARunSaysWhatIsReadBeyondTheState) {
  if (!has_gfortran()) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const auto run = [&](const std::string& statements, const std::string& state) {
    scratch.write("m.f", fixed_umat(statements + hooke_statements));
    scratch.write("m.yaml",
                  "source: m.f\ninterface: umat\nsymbol: umat_\nproperties: {E: 1e3, nu: 0.3}\nstate: " + state);
    scratch.write("s.yaml",
                  "motion: {type: homogeneous, final: [[1.1, 0, 0], [0, 1, 0], [0, 0, 1]]}\n"
                  "material: {adapter: m.yaml, density: 1000}\n"
                  "body: {domain: box, lower: [0, 0], upper: [1, 1]}\ngrid: {spacing: 0.125}\n"
                  "method: {basis: linear}\ntime: {end: 0.2}\n");
    return assay({"run", scratch / "s.yaml", "-o", scratch / "out", "--threads", "1"});
  };
  const std::string reads = "      IF (STATEV(3).GT.1.D0) STATEV(1)=1.D0\n";
  const Ending few = run(reads, "2");
  EXPECT_EQ(few.status, 1) << few.said;
  EXPECT_NE(few.said.find("reads beyond its arrays"), std::string::npos) << few.said;
  const Ending enough = run(reads, "3");
  EXPECT_EQ(enough.status, 0) << enough.said;
}

/// Kept as it is: a model with a state, not thread-safe, in two workers.
TEST(ForeignModels, TwoCoresGiveTheBitsOfOne) {
  if (!built("umat_j2")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  for (const char* threads : {"1", "2"}) {
    const Ending ending = assay_with_doubles(
        {"run", configs + "vortex_umat.yaml", "-o", scratch / threads, "--quiet", "--threads", threads, "--set",
         "material={adapter: " + descriptions + "umat_j2.yaml}", "--set", "motion.amplitude.peak=0.1", "--set",
         "time.end=0.1", "--set", "force.tolerance=1e-2", "--set", "expect={outcome: completed}"});
    ASSERT_EQ(ending.status, 0) << ending.said;
  }
  const std::string one = bytes_of(scratch / "1/errors.csv");
  EXPECT_GT(one.size(), 100u);
  EXPECT_EQ(bytes_of(scratch / "2/errors.csv"), one);
}

std::string misbehaving(const ScratchFolder& scratch, const std::string& keys) {
  return scratch.write("model.yaml", "library: " + doubles + "misbehaving_umat.so\ninterface: umat\n" +
                                         "properties: {E: 1.0e3, nu: 0.3, which: 0, from: 0.5}\nstate: 1\n" +
                                         "density: 1000\n" + keys);
}

std::vector<std::string> run_of(const ScratchFolder& scratch, const std::string& model, int which) {
  return {"run",   configs + "vortex_umat.yaml",
          "-o",    scratch / "out",
          "--set", "material={adapter: " + model + ", parameters: {which: " + std::to_string(which) + "}}",
          "--set", "force.tolerance=1e-5",
          "--set", "motion.amplitude.peak=0.1",
          "--set", "expect={outcome: completed}"};
}

TEST(ForeignModels, AFailureLeavesAReplayThatReproducesIt) {
  if (!built("misbehaving_umat")) GTEST_SKIP() << "no Fortran compiler";
  constexpr int segmentation_fault = 1;
  const ScratchFolder scratch;
  const Ending ending = assay(run_of(scratch, misbehaving(scratch, ""), segmentation_fault));
  EXPECT_EQ(ending.status, 1);
  EXPECT_NE(ending.said.find("was ended by signal 11"), std::string::npos) << ending.said;
  const Ending again = assay({"check", "--replay", scratch / "out/replay.yaml"});
  EXPECT_EQ(again.status, 1);
  EXPECT_NE(again.said.find("was ended by signal 11"), std::string::npos) << again.said;
}

/// Processes whose environment holds that text.
int processes_with(const std::string& text) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    if (!std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c); })) continue;
    if (bytes_of(entry.path() / "environ").find(text) != std::string::npos) ++count;
  }
  return count;
}

/// For twenty seconds at most.
template <class Condition>
bool wait_until(const Condition& condition, std::chrono::milliseconds look = std::chrono::milliseconds(50)) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!condition() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(look);
  return condition();
}

constexpr int endless_loop = 3;  ///< of the misbehaviours

bool holds_name(const std::string& folder, const std::string& beginning) {
  return std::any_of(fs::directory_iterator(folder), fs::directory_iterator(),
                     [&](const auto& entry) { return entry.path().filename().string().starts_with(beginning); });
}

/// The program with a model that does not come back.
struct HangingProgram {
  HangingProgram(const ScratchFolder& scratch, const std::vector<std::string>& words)
      : tmp(scratch / "tmp"), said(scratch / "said") {
    fs::create_directories(tmp);
    host = start_assay(words, said, [this] { setenv("TMPDIR", tmp.c_str(), 1); });
  }
  /// Of it and of what it has started.
  int processes() const { return processes_with("TMPDIR=" + tmp); }
  bool has_left_nothing() const {
    return wait_until([this] { return processes() == 0; }) && wait_until([this] { return fs::is_empty(tmp); });
  }
  int ended_by(int signal) const {
    int status = 0;
    ::kill(host, signal);
    ::waitpid(host, &status, 0);
    return status;
  }

  std::string tmp, said;
  pid_t host = -1;
};

TEST(ForeignModels, NothingIsLeftWhenTheHostIsKilled) {
  if (!built("misbehaving_umat")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const HangingProgram program(scratch, run_of(scratch, misbehaving(scratch, "time_limit: 1000\n"), endless_loop));
  ASSERT_TRUE(wait_until([&] { return program.processes() >= 3; })) << bytes_of(program.said);
  EXPECT_FALSE(fs::is_empty(program.tmp));
  program.ended_by(SIGKILL);
  EXPECT_TRUE(program.has_left_nothing());
}

/// At the moment that the check has a folder, when its process may not be there yet.
TEST(ForeignModels, NothingIsLeftWhenACheckIsKilled) {
  if (!built("misbehaving_umat")) GTEST_SKIP() << "no Fortran compiler";
  constexpr std::chrono::milliseconds at_once(0);
  for (const int signal : {SIGKILL, SIGTERM}) {
    const ScratchFolder scratch;
    const HangingProgram program(scratch, {"check", misbehaving(scratch, "time_limit: 1000\n"), "--parameters",
                                           "which=" + std::to_string(endless_loop), "-o", scratch / "replays"});
    ASSERT_TRUE(wait_until([&] { return holds_name(program.tmp, "assay-check-"); }, at_once)) << bytes_of(program.said);
    program.ended_by(signal);
    EXPECT_TRUE(program.has_left_nothing()) << signal;
  }
}

TEST(ForeignModels, AnInterruptDoesNotWaitForAModel) {
  if (!built("misbehaving_umat")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const HangingProgram program(scratch, run_of(scratch, misbehaving(scratch, "time_limit: 1000\n"), endless_loop));
  wait_until([&] { return program.processes() >= 3; });
  std::this_thread::sleep_for(std::chrono::milliseconds(500));  // into the loop
  const Stopwatch watch;
  const int status = program.ended_by(SIGINT);
  EXPECT_LT(watch.seconds(), nobody_waited_s);
  EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : 0, 130) << bytes_of(program.said);
  EXPECT_FALSE(fs::exists(scratch / "out"));
  EXPECT_EQ(program.processes(), 0);
  EXPECT_TRUE(fs::is_empty(program.tmp));
}

TEST(ForeignModels, ErrorsStandAtTheKeyOfTheDescription) {
  const ScratchFolder scratch;
  const std::string file = scratch.write(
      "m.yaml", "library: " + doubles + "mfront_neo_hookean.so\ninterface: mfront\nproperties: {Young: 1}\n");
  const Ending ending = assay({"materials", file});
  EXPECT_EQ(ending.status, 2);
  EXPECT_TRUE(ending.said.starts_with(file + ":3:21: properties.Young: behaviour 'NeoHookean' has no such property; "
                                             "known: YoungModulus, PoissonRatio"))
      << ending.said;
}

}  // namespace
}  // namespace assay::drivers::test_foreign_models
