// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/input_file.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "tests/drivers/process.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scene_text.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_input_file {
namespace {

const std::string scene = tree_folder() + "/configs/paper/tabulate_neo_hookean.yaml";

/// The program with a text on standard input, in this folder; it is killed where it waits.
Ending with_input(const ScratchFolder& scratch, const std::vector<std::string>& words, const std::string& text) {
  const std::string input = scratch.write("input", text), here = scratch / "";
  return assay(words, [&] {
    ::alarm(60);
    if (::chdir(here.c_str()) != 0) ::_exit(126);
    ::dup2(::open(input.c_str(), O_RDONLY), STDIN_FILENO);
  });
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(InputFile, WhatIsNoRegularFileIsRefusedAtOnce) {
  const ScratchFolder scratch;
  const std::string pipe = scratch / "pipe", socket = scratch / "socket";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  ::symlink("pipe", (scratch / "link").c_str());
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, socket.c_str(), sizeof address.sun_path - 1);
  const int server = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(::bind(server, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  for (const std::string& file : {pipe, scratch / "link"}) {
    EXPECT_TRUE(has(refusal_of([&] { read_bytes(file); }), file + ": is a named pipe, not a regular file")) << file;
  }
  EXPECT_TRUE(has(refusal_of([&] { read_bytes(socket); }), ": is a socket, not a regular file"));
  EXPECT_TRUE(has(refusal_of([&] { read_bytes("/dev/zero"); }), ": is a device, not a regular file"));
  EXPECT_EQ(fault_of_file(scratch / "none"), "no such file: '" + (scratch / "none") + "'");
  EXPECT_TRUE(has(fault_of_file(pipe), "is a named pipe"));
  EXPECT_EQ(fault_of_file("-") + fault_of_file("/dev/stdin") + fault_of_file("/dev/fd/63"), "");
  ::close(server);
}

TEST(LongInputFile, APipeInAnyRoleIsALineAndNotAWait) {
  const ScratchFolder scratch;
  for (const char* name : {"pipe", "pipe.yaml", "pipe.f", "pipe.so"}) ::mkfifo((scratch / name).c_str(), 0600);
  scratch.write("study.yaml", "scene: pipe.yaml\naxes: {grid.spacing: [0.1]}\n");
  scratch.write("path.yaml",
                "motion: {type: homogeneous, path: pipe}\nmaterial: {adapter: neo_hookean, parameters: {E: 1}}\n");
  scratch.write("library.yaml", "library: ./pipe.so\n");
  const std::vector<std::vector<std::string>> calls{{"run", "pipe.yaml"},
                                                    {"study", "pipe.yaml"},
                                                    {"study", "study.yaml"},
                                                    {"tabulate", "path.yaml"},
                                                    {"eval", scene, "--points", "pipe"},
                                                    {"tabulate", scene, "--points", "pipe"},
                                                    {"check", "pipe.yaml"},
                                                    {"check", "pipe.f"},
                                                    {"check", "./pipe.so"},
                                                    {"check", "--replay", "pipe"},
                                                    {"materials", "library.yaml"},
                                                    {"register", "pipe.yaml", "--as", "x"}};
  for (const auto& words : calls) {
    const Ending ending = with_input(scratch, words, "");
    EXPECT_EQ(ending.status, 2) << testing::PrintToString(words) << ending.said;
    EXPECT_EQ(std::count(ending.said.begin(), ending.said.end(), '\n'), 1) << ending.said;
  }
}

TEST(LongInputFile, AHyphenIsStandardInputWhateverIsRead) {
  const ScratchFolder scratch;
  const std::string text = bytes_of(scene), points = "X,Y,t\n1,0,0.5\n";
  EXPECT_EQ(with_input(scratch, {"tabulate", "-", "--quiet"}, text).status, 0);
  EXPECT_TRUE(std::filesystem::exists(scratch / "results/stdin/result.json"));
  const Ending by_hyphen = with_input(scratch, {"eval", scene, "--points", "-", "-o", "-"}, points);
  EXPECT_TRUE(by_hyphen.said.starts_with("X,Y,t,x,y,")) << by_hyphen.said;
  EXPECT_EQ(by_hyphen.said, with_input(scratch, {"eval", scene, "--points", "/dev/stdin"}, points).said);
  EXPECT_FALSE(std::filesystem::exists(scratch / "-"));
  const std::string study =
      "scene: " + tree_folder() + "/configs/paper/vortex_cpdi.yaml\naxes: {material.parameters.nu: [0.1, 0.2]}\n";
  EXPECT_TRUE(has(with_input(scratch, {"study", "-", "--list"}, study).said, "0.2"));
  EXPECT_TRUE(has(with_input(scratch, {"run", "-"}, "motion: {type: vortx}\nmaterial: {adapter: x}\n").said,
                  "standard input:1:16: motion.type: unknown value 'vortx' (nearest: vortex)"));
  EXPECT_TRUE(has(with_input(scratch, {"check", "--replay", "-"}, "material: x\nF0: 1\n").said,
                  "standard input:1:1: parameters: required"));
  EXPECT_TRUE(
      has(with_input(scratch, {"materials", "-"}, "library: ./no.so\n").said, "standard input:1:10: library: "));
}

TEST(InputFile, OneStreamIsOneInput) {
  const ScratchFolder scratch;
  const std::vector<std::vector<std::string>> calls{
      {"eval", "-", "--points", "-"}, {"tabulate", "/dev/stdin", "--points", "-"}, {"compare", "-", "/dev/fd/0"}};
  for (const auto& words : calls) {
    const Ending ending = with_input(scratch, words, "");
    EXPECT_EQ(ending.status, 2) << ending.said;
    EXPECT_TRUE(has(ending.said, "stream, which can be read once")) << ending.said;
  }
}

/// A system gives the number of a file that is gone to the next one.
TEST(InputFile, AFileOfTheSameNumberIsNoInputBeforeItIsRead) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("points.csv", "xi,t\n0,0\n"), longer = "xi,t\n0,0\n0,1\n";
  read_bytes(file);
  EXPECT_TRUE(is_input(file));
  std::filesystem::create_hard_link(file, scratch / "same");
  EXPECT_TRUE(is_input(scratch / "same"));
  scratch.write("points.csv", longer);
  EXPECT_FALSE(is_input(file)) << "another length";
  read_bytes(file);
  std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) + std::chrono::nanoseconds(1));
  EXPECT_FALSE(is_input(file)) << "another time";
  forget_inputs();
}

TEST(InputFile, AFolderCannotBeStandardOutput) {
  const ScratchFolder scratch;
  const std::vector<std::vector<std::string>> calls{{"run", "x.yaml", "-o", "-"},
                                                    {"tabulate", "x.yaml", "-o", "-"},
                                                    {"study", "x.yaml", "-o", "-"},
                                                    {"new-material", "clay", "--language", "c", "-o", "-"}};
  for (const auto& words : calls) {
    const Ending ending = with_input(scratch, words, "");
    EXPECT_EQ(ending.status, 2) << ending.said;
    EXPECT_TRUE(has(ending.said, "-o: is standard output, and a folder is written")) << ending.said;
  }
}

TEST(InputFile, NamesTheResultsOfAStream) {
  EXPECT_EQ(stem_of_input("-"), "stdin");
  EXPECT_EQ(stem_of_input("/dev/stdin"), "stdin");
  EXPECT_EQ(stem_of_input("a/b.yaml"), "b");
  for (const char* dots : {"...yaml", "a/..yaml", "...."}) EXPECT_EQ(stem_of_input(dots), "unnamed") << dots;
}

/// What the table of exit statuses says of signals.
TEST(InputFile, ASignalThatNobodyCatchesLeavesNothing) {
  for (const int signal : {SIGUSR1, SIGALRM, SIGPIPE}) {
    const ScratchFolder scratch;
    const pid_t child = start_assay({"run", tree_folder() + "/configs/paper/vortex_cpdi.yaml", "-o", scratch / "out",
                                     "--set", "grid.spacing=0.00625"},
                                    scratch / "said", [signal] { std::signal(signal, SIG_DFL); });
    ::usleep(300'000);
    ::kill(child, signal);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << signal << ": " << status;
    EXPECT_FALSE(std::filesystem::exists(scratch / "out/result.json"));
  }
}

TEST(InputFile, AReaderThatGoesAwayLosesNoResults) {
  const ScratchFolder scratch;
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ::close(ends[0]);
  const pid_t child = start_assay({"tabulate", scene, "-o", scratch / "out", "--json"}, scratch / "said", [&] {
    std::signal(SIGPIPE, SIG_DFL);
    ::dup2(ends[1], STDOUT_FILENO);
  });
  ::close(ends[1]);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGPIPE) << status;
  EXPECT_TRUE(std::filesystem::exists(scratch / "out/result.json"));
}

}  // namespace
}  // namespace assay::drivers::test_input_file
