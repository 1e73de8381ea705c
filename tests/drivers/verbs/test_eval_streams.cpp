// SPDX-License-Identifier: BSD-3-Clause
// `eval` as a program between others: standard input and output, what fails half-way, and memory.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "drivers/format/zip.hpp"
#include "tests/drivers/process.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_eval_streams {
namespace {

const std::string scene = tree_folder() + "/configs/paper/vortex_cpdi.yaml";

std::string many_points(int rows) {
  std::string text = "X,Y,t\n";
  for (int k = 0; k < rows; ++k)
    text += "0." + std::to_string(800 + k % 199) + ",0." + std::to_string(100 + k % 211) + ",0.5\n";
  return text;
}

class EvalStreams : public testing::Test {
 protected:
  Ending with_input(std::vector<std::string> words, const std::string& text, const std::function<void()>& more = {}) {
    const std::string input = scratch_.write("input", text);
    words.insert(words.begin(), {"eval", scene, "--quiet"});
    return assay(words, [&] {
      ::alarm(100);
      if (::chdir((scratch_ / "").c_str()) != 0) ::_exit(126);
      ::dup2(::open(input.c_str(), O_RDONLY), STDIN_FILENO);
      if (more) more();
    });
  }
  std::size_t files() const {
    const auto all = std::filesystem::directory_iterator(scratch_ / "");
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }
  ScratchFolder scratch_, said_;
};
using LongEvalStreams = EvalStreams;

TEST_F(LongEvalStreams, StandardInputAndOutputAreFiles) {
  const std::string text = many_points(10'000);
  const std::string points = scratch_.write("points.csv", text);
  ASSERT_EQ(with_input({"--points", points, "-o", "file.csv"}, "").status, 0);
  const std::string expected = bytes_of(scratch_ / "file.csv");
  EXPECT_TRUE(with_input({"--points", "-"}, text).said == expected);
  EXPECT_TRUE(with_input({"--points", "-", "-o", "-"}, text).said == expected);
  ASSERT_EQ(with_input({"--points", "-", "-o", "file.npz"}, text).status, 0);
  EXPECT_TRUE(with_input({"--points", "-", "--format", "npz"}, text).said == bytes_of(scratch_ / "file.npz"));
  ASSERT_EQ(with_input({"--points", "-", "-o", "file.npy", "--columns", "b"}, text).status, 0);
  EXPECT_TRUE(with_input({"--points", "-", "--format", "npy", "--columns", "b"}, text).said ==
              bytes_of(scratch_ / "file.npy"));
  ASSERT_EQ(with_input({"--points", "-", "-o", "file.vtu"}, text).status, 0);
  EXPECT_TRUE(with_input({"--points", "-", "--format", "vtu"}, text).said == bytes_of(scratch_ / "file.vtu"));
  const Ending several = with_input({"--points", "-", "--format", "vtu"}, text + "1,0,0.25\n");
  EXPECT_EQ(several.status, 2);
  EXPECT_EQ(several.said, "--format: vtu writes a file for each of several times: name the first with -o NAME.vtu\n");
  const Ending times = with_input({"--points", points, "--times", "-"}, "0\n1\n");
  EXPECT_EQ(times.said, "--times: the points have a column t: leave out the column or the option\n");
}

/// Names that say nothing of the format, of the times, or are no place for several files.
TEST_F(EvalStreams, NamesThatCannotBeMeantAreRefused) {
  const std::string points = scratch_.write("points.csv", "X,Y\n1,0\n");
  const std::size_t before = files() + 1;  // the input
  for (const auto& [words, message] :
       {std::pair{std::vector<std::string>{"--times", "0", "-o", "exact.xyz"}, "-o: no table ends in '.xyz'"},
        {{"--times", "nan", "-o", "exact.csv"}, "--times: 'nan' is neither a list of numbers"},
        {{"--times", "1d0", "-o", "exact.csv"}, "--times: '1d0' is neither a list of numbers"},
        {{"--times", "0,x", "-o", "exact.csv"}, "--times: 'x' is no finite number"},
        {{"--times", "0", "-o", "/dev/null", "--format", "vtu"}, "-o: '/dev/null' is no regular file"}}) {
    std::vector<std::string> all{"--points", points};
    all.insert(all.end(), words.begin(), words.end());
    const Ending ending = with_input(all, "");
    EXPECT_EQ(ending.status, 2);
    EXPECT_TRUE(ending.said.starts_with(message)) << ending.said;
    EXPECT_EQ(files(), before);
  }
  EXPECT_EQ(with_input({"--points", points, "--times", "0", "-o", "exact.dat"}, "").status, 0);
}

TEST_F(EvalStreams, TimesAfterTheEndOfTheSceneAreToldOf) {
  const std::string points = scratch_.write("points.csv", "X,Y\n1,0\n");
  EXPECT_EQ(with_input({"--points", points, "--times", "0,1", "-o", "a.csv"}, "").said, "");
  EXPECT_EQ(with_input({"--points", points, "--times", "0,3", "-o", "b.csv"}, "").said,
            "warning: the last time, 3 s, is after time.end of the scene, 1 s\n");
}

/// The last row is wrong: nothing is written before it is seen.
TEST_F(EvalStreams, BadInputIsRefusedBeforeAnythingIsWritten) {
  const std::string text = many_points(20'000);
  const std::size_t before = files() + 1;  // the input
  for (const auto& [row, message] : {std::pair{"1,0,zero\n", "standard input:20002:5: t: 'zero' is no finite number"},
                                     {"1,0,-1\n", "standard input:20002:1: t: negative"},
                                     {"1,0\n", "standard input:20002:3: 2 fields"}}) {
    for (const char* out : {"-", "out.csv", "out.npz"}) {
      const Ending ending = with_input({"--points", "-", "-o", out}, text + row);
      EXPECT_EQ(ending.status, 2);
      EXPECT_TRUE(ending.said.starts_with(message)) << ending.said.substr(0, 200);
      EXPECT_EQ(std::count(ending.said.begin(), ending.said.end(), '\n'), 1);
      EXPECT_EQ(files(), before);
    }
  }
}

TEST_F(LongEvalStreams, AFullDiskLeavesNothing) {
  const std::string text = many_points(20'000);
  const std::size_t before = files() + 1;
  for (const char* out : {"out.csv", "out.npy", "out.npz", "out.vtu"}) {
    const Ending ending = with_input({"--points", "-", "-o", out}, text, [] {
      const rlimit limit{1 << 20, 1 << 20};  // of the spooled points, too, which are smaller
      ::setrlimit(RLIMIT_FSIZE, &limit);
      ::signal(SIGXFSZ, SIG_IGN);
    });
    EXPECT_EQ(ending.status, 3) << out << ending.said;
    EXPECT_NE(ending.said.find(std::string(out) + ": cannot be written"), std::string::npos) << ending.said;
    EXPECT_EQ(files(), before) << out;
  }
  if (::access("/dev/full", W_OK) != 0) return;
  EXPECT_EQ(with_input({"--points", "-", "-o", "/dev/full"}, text).status, 3);
  const Ending full = with_input({"--points", "-"}, text, [] { ::dup2(::open("/dev/full", O_WRONLY), STDOUT_FILENO); });
  EXPECT_EQ(full.status, 3);
  EXPECT_EQ(full.said, "standard output cannot be written\n");
  const Ending spooled = with_input({"--points", "-"}, text, [&] { ::setenv("TMPDIR", "/nowhere", 1); });
  EXPECT_EQ(spooled.status, 3);
  EXPECT_TRUE(spooled.said.starts_with("a temporary file in '/nowhere' cannot be made")) << spooled.said;
}

/// The signal comes when a part of the table is written under its hidden name.
TEST_F(EvalStreams, AnInterruptLeavesNothing) {
  const std::string points = scratch_.write("points.csv", many_points(300'000));
  for (const char* out : {"out.csv", "out.npz"}) {
    const std::size_t before = files();
    const pid_t child =
        start_assay({"eval", scene, "--points", points, "-o", scratch_ / out, "--quiet"}, said_ / "said");
    int status = 0;
    bool sent = false;
    while (::waitpid(child, &status, WNOHANG) == 0) {
      if (!sent && files() > before) sent = ::kill(child, SIGINT) == 0;
      ::usleep(1000);
    }
    EXPECT_TRUE(sent);
    EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), 128 + SIGINT) << out;
    EXPECT_EQ(files(), before) << out;
  }
}

/// Peak memory [KiB] of a table of so many rows.
long peak_memory(const ScratchFolder& scratch, int rows, const std::string& out) {
  const std::string points = scratch.write("many.csv", many_points(rows));
  const pid_t child =
      start_assay({"eval", scene, "--points", points, "-o", scratch / out, "--quiet"}, scratch / "said");
  rusage usage{};
  int status = 0;
  ::wait4(child, &status, 0, &usage);
  EXPECT_EQ(status, 0) << bytes_of(scratch / "said");
  return usage.ru_maxrss;
}

TEST_F(LongEvalStreams, MemoryDoesNotGrowWithTheRows) {
  constexpr int rows = 150'000;     // more than the blocks whose points are remembered
  constexpr long margin = 8 << 10;  // [KiB], what an allocator keeps; all rows would take 300 MiB more
  for (const char* out : {"a.csv", "a.npy", "a.npz", "a.vtu"})
    EXPECT_LT(peak_memory(scratch_, 3 * rows, out), peak_memory(scratch_, rows, out) + margin) << out;
}

}  // namespace
}  // namespace assay::drivers::test_eval_streams
