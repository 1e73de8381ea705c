// SPDX-License-Identifier: BSD-3-Clause
// Foreign materials inside a host: their workers are processes of the program, started without fork, and whatever
// becomes of them, or of the host's children, ends in a code.
#include <dlfcn.h>
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

#include "tests/drivers/library/handles.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/built.hpp"

namespace assay::library_test::test_workers {
namespace {

namespace fs = std::filesystem;
using drivers::ScratchFolder;

const std::string foreign = ASSAY_SOURCE_DIR "/tests/adapters/foreign/mfront_neo_hookean.yaml";

class Workers : public testing::Test {
 protected:
  void SetUp() override { ::setenv("ASSAY_MATERIAL_PATH", built("tests/foreign").c_str(), 1); }
  void TearDown() override {
    std::signal(SIGCHLD, SIG_DFL);
    ::setenv("PATH", path_.c_str(), 1);
    ::unsetenv("ASSAY_PROGRAM");
  }

  /// A vortex until a time that takes a moment to be tabulated.
  static std::string text(const std::string& adapter = foreign, const std::string& more = {}) {
    return "motion: {type: vortex, amplitude: {type: sine, peak: .5}}\nmaterial: {adapter: '" + adapter +
           "', density: 1000" + more + "}\nforce: {tolerance: 1e-4, cache: false}\n";
  }

 private:
  const std::string path_ = std::getenv("PATH");
};

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
TEST_F(Workers, OfAHostThatForks) {
  constexpr unsigned patience_s = 60;
  const auto ask = [](const Owned<assay_points>& points, double t) { return evaluated(points, t, 1).front().P[1]; };
  const std::string scene =
      "motion: {type: homogeneous, final: [[1.6, .3, 0], [-.1, .8, 0], [0, 0, 1]]}\n"
      "material: {adapter: '" ASSAY_SOURCE_DIR "/tests/adapters/foreign/umat_j2.yaml', density: 1000}\n";
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
  EXPECT_EQ(code_of(text(ASSAY_SOURCE_DIR "/tests/downstream/hooke_umat.f", ", parameters: {p1: 1e3, p2: .3}"), &words),
            ASSAY_DONE)
      << words;
}

/// A copy of the library in a folder of its own.
class Copied {
 public:
  Copied() {
    Dl_info known{};
    ::dladdr(reinterpret_cast<const void*>(&assay_version), &known);
    fs::copy_file(fs::canonical(known.dli_fname), scratch / "libassay.so.1");
    handle_ = ::dlopen((scratch / "libassay.so.1").c_str(), RTLD_NOW | RTLD_LOCAL);
  }
  int code_of_foreign(std::string& words) const {
    assay_options options = ASSAY_OPTIONS_INIT;
    const std::string text = "motion: {type: vortex}\nmaterial: {adapter: '" + foreign + "', density: 1000}\n";
    options.text = text.c_str();
    assay_error error = ASSAY_ERROR_INIT;
    assay_problem* problem = nullptr;
    const auto open = reinterpret_cast<decltype(&assay_open)>(::dlsym(handle_, "assay_open"));
    const int code = open(&options, &problem, &error);
    words = error.message;
    return code;
  }
  const ScratchFolder scratch;

 private:
  void* handle_ = nullptr;
};

TEST_F(Workers, NeedTheProgram) {
  const Copied copied;
  ::setenv("PATH", "/nowhere", 1);
  std::string words;
  EXPECT_EQ(copied.code_of_foreign(words), ASSAY_SYSTEM);
  EXPECT_NE(words.find("$ASSAY_PROGRAM"), words.npos) << words;
}

TEST_F(Workers, AreOfTheProgramThatIsNamed) {
  const Copied copied;
  ::setenv("ASSAY_PROGRAM", built("assay").c_str(), 1);
  std::string words;
  EXPECT_EQ(copied.code_of_foreign(words), ASSAY_DONE) << words;
}

/// What is no assay is named, and not what it was to compile or to run; nothing of its words reaches the host's.
TEST_F(Workers, OfAProgramThatIsNoneAreRefused) {
  const ScratchFolder scratch;
  const std::string loud = scratch.write("loud", "#!/bin/sh\necho words >&2\necho words\nexit 1\n");
  fs::permissions(loud, fs::perms::owner_all);
  for (const std::string& program : {std::string("/bin/false"), loud, std::string("/nowhere/assay")}) {
    ::setenv("ASSAY_PROGRAM", program.c_str(), 1);
    for (const std::string& scene : {text(), text(ASSAY_SOURCE_DIR "/tests/downstream/hooke_umat.f")}) {
      std::string words;
      testing::internal::CaptureStderr();
      testing::internal::CaptureStdout();
      EXPECT_EQ(code_of(scene, &words), ASSAY_SYSTEM);
      EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
      EXPECT_NE(words.find(program), words.npos) << words;
      EXPECT_EQ(words.find("gfortran"), words.npos) << words;
    }
  }
}

TEST_F(Workers, OfAnotherBuildAreRefused) {
  const Copied copied;
  const std::string program =
      copied.scratch.write("assay",
                           "#!/bin/sh\nprintf '0.1.0 older' | dd of=/proc/self/fd/3 bs=1 seek=$((268435456 - 4096)) "
                           "conv=notrunc 2>/dev/null\nexit 2\n");
  fs::permissions(program, fs::perms::owner_all);
  std::string words;
  EXPECT_EQ(copied.code_of_foreign(words), ASSAY_SYSTEM) << words;
  EXPECT_NE(words.find("is assay 0.1.0 older, and the library is "), words.npos) << words;
}

}  // namespace
}  // namespace assay::library_test::test_workers
