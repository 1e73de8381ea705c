// SPDX-License-Identifier: BSD-3-Clause
// What the system does not give, or takes away, is no finding about a model: status 3 and one line.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>

#include "tests/drivers/misdeeds.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_shortage {
namespace {

namespace fs = std::filesystem;

struct Limit {
  const char* name;
  __rlimit_resource_t resource;
  rlim_t bytes;
  const char* words;
};

class Shortage : public testing::TestWithParam<Limit> {
 protected:
  void SetUp() override {
    if (sanitized()) GTEST_SKIP() << "the sanitizer itself needs more";
  }
  Ending program(const std::vector<std::string>& words) const {
    return assay(words, [this] {
      the_.arm("");
      const rlimit limit{GetParam().bytes, GetParam().bytes};
      ::setrlimit(GetParam().resource, &limit);
    });
  }
  void expect_told(const Ending& ending) const {
    if (ending.status == 0) return;  // it was enough
    EXPECT_EQ(ending.status, 3) << ending.said;
    EXPECT_NE(ending.said.find(GetParam().words), std::string::npos) << ending.said;
    EXPECT_EQ(std::count(ending.said.begin(), ending.said.end(), '\n'), 1) << ending.said;
  }
  Misdeeds the_;
};

TEST_P(Shortage, IsNoVerdict) {
  const std::string out = the_.scratch / "r";
  expect_told(program({"check", "neo_hookean", "--quick", "-o", out}));
  expect_told(program({"check", built("materials/libneo_hookean.so"), "--quick", "--parameters", "E=1000", "-o", out}));
}

TEST_P(Shortage, IsNoFailureOfARun) {
  for (const char* isolation : {"none", "worker"}) {
    std::vector<std::string> words = the_.run_words(the_.library);
    words.insert(words.end(), {"--set", std::string("material.isolation=") + isolation});
    const Ending ending = program(words);
    EXPECT_TRUE(ending.status == 0 || ending.status == 3) << isolation << ": " << ending.said;
  }
}

INSTANTIATE_TEST_SUITE_P(Limits, Shortage,
                         testing::Values(Limit{"data", RLIMIT_DATA, 8 << 20, "memory"},
                                         Limit{"stack", RLIMIT_STACK, 64 << 10, "the stack is limited to 64 KiB"}),
                         [](const auto& instance) { return std::string(instance.param.name); });

/// The worker, or its warden, whose child it is.
class KilledFromOutside : public testing::TestWithParam<bool> {};

bool is_of_workers(pid_t process) {
  return bytes_of("/proc/" + std::to_string(process) + "/cmdline").starts_with(std::string("assay\0worker\0", 13));
}

pid_t process_of(const Misdeeds& the, bool worker) {
  for (int waited = 0; waited < 500; ++waited, ::usleep(10000)) {
    for (const pid_t each : the.living()) {
      const std::string stat = bytes_of("/proc/" + std::to_string(each) + "/stat");
      const std::size_t name_end = stat.rfind(')');
      if (name_end == stat.npos || !is_of_workers(each)) continue;
      const auto parent = static_cast<pid_t>(std::strtol(stat.c_str() + name_end + 4, nullptr, 10));
      if (is_of_workers(parent) == worker) return each;
    }
  }
  return 0;
}

TEST_P(KilledFromOutside, AWorkerIsNoFailureOfTheModel) {
  const Misdeeds the;
  std::vector<std::string> words = the.run_words(the.library);
  words.insert(words.end(), {"--set", "material.isolation=worker"});
  const pid_t program = start_assay(words, the.scratch / "said", [&] { the.arm("each nap"); });
  ASSERT_GT(process_of(the, true), 0);
  ::usleep(200'000);
  const pid_t process = process_of(the, GetParam());
  ASSERT_GT(process, 0);
  ::kill(process, SIGKILL);
  int status = 0;
  ::waitpid(program, &status, 0);
  const std::string said = bytes_of(the.scratch / "said");
  EXPECT_EQ(WEXITSTATUS(status), 3) << said;
  EXPECT_NE(said.find("a worker was killed (signal 9) from outside"), std::string::npos) << said;
  EXPECT_FALSE(fs::exists(the.scratch / "out/result.json"));
  EXPECT_TRUE(the.nothing_is_left());
}

INSTANTIATE_TEST_SUITE_P(Processes, KilledFromOutside, testing::Bool(),
                         [](const auto& instance) { return instance.param ? "worker" : "warden"; });

/// Whoever dies of it is not to blame, and who dies softly says why.
TEST(LongProcessorTime, ThatIsLimitedIsNoVerdict) {
  const Misdeeds the;
  for (const bool hard : {false, true}) {
    const auto limited = [&] {
      the.arm("each nap");
      const rlimit limit{1, hard ? 1 : RLIM_INFINITY};
      ::setrlimit(RLIMIT_CPU, &limit);
    };
    const Ending check = assay({"check", "norton", "-o", the.scratch / "r"}, limited);
    EXPECT_TRUE(check.status == 0 || check.status == 3) << check.said;
    if (check.status == 3) {
      EXPECT_NE(check.said.find("processor time is limited to 1 s (ulimit -t)"), std::string::npos) << check.said;
    }
  }
  std::vector<std::string> words = the.run_words("neo_hookean");
  words.insert(words.end(),
               {"--set", "material.parameters={E: 1e3, nu: 0.3}", "--set", "grid.spacing=0.01", "--set", "time.end=1"});
  for (const rlimit limit : {rlimit{1, RLIM_INFINITY}, rlimit{2, 2}}) {  // the second as `ulimit -t 2` sets it
    const Ending run = assay(words, [&] { ::setrlimit(RLIMIT_CPU, &limit); });
    EXPECT_EQ(run.status, 3) << run.said;
    const std::string said = "processor time is limited to " + std::to_string(limit.rlim_cur) + " s (ulimit -t)";
    EXPECT_NE(run.said.find(said + ", which is used up"), std::string::npos) << run.said;
    EXPECT_FALSE(fs::exists(the.scratch / "out"));
  }
}

TEST(LongProcessorTime, OfTheCasesOfAStudyIsNoFinding) {
  const ScratchFolder scratch;
  const std::string study = scratch.write(
      "study.yaml", "scene: " + tree_folder() + "/configs/paper/vortex_cpdi.yaml\naxes:\n  grid.spacing: [0.01]\n");
  for (const bool hard : {false, true}) {
    const Ending ending = assay({"study", study, "-o", scratch / "out"}, [&] {
      const rlimit limit{1, hard ? 1 : RLIM_INFINITY};
      ::setrlimit(RLIMIT_CPU, &limit);
    });
    EXPECT_EQ(ending.status, 3) << ending.said;
    EXPECT_NE(ending.said.find("processor time is limited to 1 s (ulimit -t), which is used up"), std::string::npos)
        << ending.said;
  }
}

/// The warden of a worker is no process that the model has left.
TEST(LongDeathInAWorker, LeavesNothingBehind) {
  for (const char* deed : {"update abort", "update null", "update _exit"}) {
    const Misdeeds the;
    std::vector<std::string> words = the.run_words(the.library);
    words.insert(words.end(), {"--set", "material.isolation=worker"});
    const Ending run = the.program(words, deed);
    EXPECT_EQ(run.status, 1) << run.said;
    EXPECT_EQ(run.said.find("leaves processes behind"), std::string::npos) << deed << ": " << run.said;
  }
}

/// Nothing passes because it could not be looked for.
TEST(OpenFiles, OfWhichThereAreTooFewAreNoPass) {
  for (const rlim_t most : {12, 20, 28, 40}) {
    const ScratchFolder scratch;
    const Ending ending = assay({"check", "neo_hookean", "--quick", "-o", scratch / "r"}, [&] {
      const rlimit limit{most, most};
      ::setrlimit(RLIMIT_NOFILE, &limit);
    });
    EXPECT_EQ(ending.status, most < 32 ? 3 : 0) << ending.said;
    if (most < 32) {
      EXPECT_EQ(ending.said, "open files are limited to " + std::to_string(most) + " (ulimit -n), and 32 are needed\n");
    }
  }
}

/// Whoever has so few could not clear away what is staged.
TEST(LongOpenFiles, OfWhichThereAreTooFewAreNoRun) {
  for (const rlim_t most : {7, 16}) {
    const ScratchFolder scratch;
    const std::string scene = tree_folder() + "/configs/paper/vortex_cpdi.yaml";
    const Ending ending =
        assay({"run", scene, "--set", "grid.spacing=0.125", "--set", "expect={}", "-o", scratch / "r"}, [&] {
          const rlimit limit{most, most};
          ::setrlimit(RLIMIT_NOFILE, &limit);
        });
    EXPECT_EQ(ending.status, most < 8 ? 3 : 0) << ending.said;
    if (most < 8) {
      EXPECT_EQ(ending.said, "open files are limited to " + std::to_string(most) + " (ulimit -n), and 8 are needed\n");
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(scratch / "")) {
      EXPECT_FALSE(entry.path().filename().string().starts_with(".assay")) << entry.path();
    }
  }
}

TEST(KilledByItself, IsTheModelsDeed) {
  const Misdeeds the;
  std::vector<std::string> words = the.run_words(the.library);
  words.insert(words.end(), {"--set", "material.isolation=worker"});
  const Ending run = the.program(words, "each kill");
  EXPECT_EQ(run.status, 1) << run.said;
  const Ending check = the.program({"check", the.library, "--quick", "-o", the.scratch / "r"}, "each kill");
  EXPECT_EQ(check.status, 1) << check.said;
  EXPECT_NE(check.said.find("was ended by signal 9"), std::string::npos) << check.said;
}

}  // namespace
}  // namespace assay::drivers::test_shortage
