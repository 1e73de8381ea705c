// SPDX-License-Identifier: BSD-3-Clause
// Foreign materials inside a host: their workers are processes of the program, started without fork, and whatever
// becomes of them, or of the host's children, ends in a code.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

#include "harness/numeric/stopwatch.hpp"
#include "tests/drivers/library/handles.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::library_test::test_workers {
namespace {

namespace fs = std::filesystem;
using drivers::ScratchFolder;

const std::string foreign = tree_folder() + "/tests/adapters/foreign/mfront_neo_hookean.yaml";

class Workers : public testing::Test {
 protected:
  void SetUp() override { ::setenv("ASSAY_MATERIAL_PATH", built("tests/foreign").c_str(), 1); }
  void TearDown() override { std::signal(SIGCHLD, SIG_DFL); }

  /// A vortex until a time that takes a moment to be tabulated.
  static std::string text(const std::string& adapter = foreign, const std::string& more = {}) {
    return "motion: {type: vortex, amplitude: {type: sine, peak: .5}}\nmaterial: {adapter: '" + adapter +
           "', density: 1000" + more + "}\nforce: {tolerance: 1e-4, cache: false}\n";
  }
};
using LongWorkers = Workers;

/// The processes whose ancestor is this one.
std::vector<pid_t> descendants() {
  std::vector<pid_t> found{::getpid()};
  for (std::size_t seen = 0; seen < found.size(); ++seen) {
    for (const auto& entry : fs::directory_iterator("/proc")) {
      const pid_t process = static_cast<pid_t>(std::strtol(entry.path().filename().c_str(), nullptr, 10));
      if (process <= 0) continue;
      const std::string stat = drivers::bytes_of(entry.path() / "stat");
      const std::size_t name = stat.rfind(')');
      if (name == stat.npos || name + 4 > stat.size()) continue;
      if (stat[name + 2] != 'Z' && std::strtol(stat.c_str() + name + 4, nullptr, 10) == found[seen])
        found.push_back(process);
    }
  }
  found.erase(found.begin());
  return found;
}

/// While one lives, `act` is done again and again in a thread.
class Meanwhile {
 public:
  explicit Meanwhile(const std::function<void()>& act)
      : thread_([this, act] {
          while (!over_) act(), ::usleep(2000);
        }) {}
  ~Meanwhile() {
    over_ = true;
    thread_.join();
  }
  Meanwhile(const Meanwhile&) = delete;
  Meanwhile& operator=(const Meanwhile&) = delete;

 private:
  std::atomic<bool> over_{false};
  std::thread thread_;
};

void kill_descendants() {
  for (const pid_t process : descendants()) ::kill(process, SIGKILL);
}

int code_of(const std::string& text, std::string* words = nullptr) {
  assay_options options = ASSAY_OPTIONS_INIT;
  options.text = text.c_str();
  assay_error error = ASSAY_ERROR_INIT;
  assay_problem* problem = nullptr;
  const int code = assay_open(&options, &problem, &error);
  EXPECT_EQ(problem != nullptr, code == ASSAY_DONE);
  assay_close(problem);
  if (words) *words = error.message;
  return code;
}

TEST_F(Workers, GiveTheFieldsOfTheModel) {
  constexpr double alike = 1e-3;  // both responses are tabulated to 1e-4
  const auto problem = opened(text());
  const auto own = opened(text("neo_hookean", ", parameters: {E: 1e3, nu: .3}"));
  const double b = evaluated(points_at(problem, {.9, .2}, 2), .3, 1).front().b[0];
  EXPECT_NEAR(b, evaluated(points_at(own, {.9, .2}, 2), .3, 1).front().b[0], alike * std::abs(b));
}

/// A copy of the host has workers of its own, whose answers do not mix with the host's. The material is asked at each
/// time.
TEST_F(LongWorkers, OfAHostThatForks) {
  constexpr unsigned patience_s = 60;
  const auto ask = [](const Owned<assay_points>& points, double t) { return evaluated(points, t, 1).front().P[1]; };
  const std::string scene =
      "motion: {type: homogeneous, final: [[1.6, .3, 0], [-.1, .8, 0], [0, 0, 1]]}\n"
      "material: {adapter: '" +
      tree_folder() + "/tests/adapters/foreign/umat_j2.yaml', density: 1000}\n";
  std::vector<double> expected;
  for (int k = 0; k < 20; ++k) expected.push_back(ask(points_at(opened(scene), {.9, .2}, 2), .02 * k + .01));
  auto problem = opened(scene);
  const auto points = points_at(problem, {.9, .2}, 2);
  EXPECT_EQ(ask(points, .5), ask(points_at(opened(scene), {.9, .2}, 2), .5));
  const auto all_are_right = [&] {
    bool right = true;
    for (int k = 0; k < 20; ++k) right &= ask(points, .02 * k + .01) == expected[static_cast<std::size_t>(k)];
    return right;
  };
  const pid_t child = ::fork();
  if (child == 0) {
    ::alarm(patience_s);
    const bool right = all_are_right();
    problem = {};
    ::_exit(right ? 0 : 1);
  }
  EXPECT_TRUE(all_are_right());
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  EXPECT_TRUE(all_are_right());
}

/// What a scene comes to whose workers are killed as often as they start: at work, while the library was still tried in
/// one, or twice at the same step, which cannot be told from a model that does it to itself.
::testing::AssertionResult tells_of_their_end(const std::string& text) {
  std::string words;
  const int code = code_of(text, &words);
  const bool killed = words.find("signal 9") != words.npos || words.find("lost with the process") != words.npos;
  if (code == ASSAY_SYSTEM || code == ASSAY_BAD_INPUT || (code == ASSAY_FINDING && killed))
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "code " << code << ": " << words;
}

TEST_F(Workers, EndWithTheirProblem) {
  {
    const auto problem = opened(text());
    EXPECT_FALSE(descendants().empty());
  }
  EXPECT_TRUE(descendants().empty());
}

TEST_F(Workers, ThatAreKilledAreACodeAndTheNextProblemIsWhole) {
  {
    const Meanwhile killer(kill_descendants);
    EXPECT_TRUE(tells_of_their_end(text()));
  }
  std::string words;
  EXPECT_EQ(code_of(text(), &words), ASSAY_DONE) << words;
}

TEST_F(Workers, OfAHostThatTakesEveryChild) {
  const Meanwhile thief([] { ::waitpid(-1, nullptr, WNOHANG); });
  std::string words;
  EXPECT_EQ(code_of(text(), &words), ASSAY_DONE) << words;
  const Meanwhile killer(kill_descendants);
  EXPECT_TRUE(tells_of_their_end(text()));
}

TEST_F(Workers, OfAHostThatIgnoresItsChildren) {
  std::signal(SIGCHLD, SIG_IGN);
  std::string words;
  EXPECT_EQ(code_of(text(), &words), ASSAY_DONE) << words;
  {
    const Meanwhile killer(kill_descendants);
    EXPECT_TRUE(tells_of_their_end(text()));
  }
  EXPECT_EQ(std::signal(SIGCHLD, SIG_DFL), SIG_IGN);
}

TEST_F(Workers, AreWhereForeignModelsRun) {
  std::string words;
  EXPECT_EQ(code_of(text(foreign, ", isolation: none"), &words), ASSAY_BAD_INPUT);
  EXPECT_NE(words.find("runs in workers"), words.npos) << words;
}

TEST_F(Workers, WhoseModelCrashesAreAFinding) {
  std::string words;
  EXPECT_EQ(code_of(text(built("tests/plugins/crashes.so"), ", isolation: worker"), &words), ASSAY_FINDING) << words;
  EXPECT_NE(words.find("signal 6"), words.npos) << words;
}

/// However many parts of the library would ask the model.
TEST_F(LongWorkers, WhoseModelHangsAreWaitedForOnce) {
  const std::string library = built("tests/foreign/misbehaving_umat.so");
  if (!fs::exists(library)) GTEST_SKIP() << "there is no gfortran";
  constexpr double limit_s = 3;
  const ScratchFolder scratch;
  const std::string model = scratch.write(
      "hangs.yaml", "library: " + library +
                        "\ninterface: umat\nname: misbehaving\nproperties: {E: 1.0e3, nu: 0.3, which: 3, from: 0.3}\n"
                        "state: 1\ntime_limit: 3\n");
  const Stopwatch since;
  std::string words;
  EXPECT_EQ(code_of(text(model), &words), ASSAY_FINDING);
  EXPECT_NE(words.find("did not return within 3 s"), words.npos) << words;
  EXPECT_LT(since.seconds(), 2 * limit_s);
}

TEST_F(Workers, TryNativeLibrariesFirst) {
  std::string words;
  EXPECT_EQ(code_of(text(built("tests/plugins/entry_crashes.so")), &words), ASSAY_BAD_INPUT) << words;
  EXPECT_NE(words.find("entry_crashes.so"), words.npos) << words;
  EXPECT_EQ(code_of(text(built("tests/plugins/frozen_1_0.so")), &words), ASSAY_DONE) << words;
}

TEST_F(Workers, CompileASource) {
  if (std::system("command -v gfortran >/dev/null 2>&1") != 0) GTEST_SKIP() << "there is no gfortran";
  const ScratchFolder cache;
  ::setenv("ASSAY_CACHE_HOME", (cache / "").c_str(), 1);
  std::string words;
  EXPECT_EQ(code_of(text(tree_folder() + "/tests/downstream/hooke_umat.f", ", parameters: {p1: 1e3, p2: .3}"), &words),
            ASSAY_DONE)
      << words;
}

}  // namespace
}  // namespace assay::library_test::test_workers
