// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/process_watch.hpp"

#include "adapters/foreign/written_inputs.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <memory>
#include <string>

#include "adapters/worker/kept_output.hpp"

namespace assay::adapters::test_process_watch {
namespace {

struct Deed {
  const char* name;
  void (*done)();
  std::uint32_t habit;
};

void nothing() {}
void leave() { static_cast<void>(::chdir("/")); }
void close_output() { ::close(STDOUT_FILENO); }
void redirect_errors() { ::dup2(::open("/dev/full", O_WRONLY), STDERR_FILENO); }
void take_signal() {
  std::signal(SIGFPE, [](int) {});
}
void fork_one() {
  if (::fork() == 0) ::_exit(0);
}
void leave_and_come_back() {
  char before[4096];
  if (::getcwd(before, sizeof before) && ::chdir("/") == 0) static_cast<void>(::chdir(before));
}

const Deed deeds[] = {{"nothing", nothing, no_habit},
                      {"changes_the_folder", leave, folder_changed},
                      {"comes_back", leave_and_come_back, no_habit},
                      {"closes_output", close_output, output_closed},
                      {"redirects_errors", redirect_errors, output_closed},
                      {"takes_a_signal", take_signal, signals_taken},
                      {"leaves_a_process", fork_one, processes_left}};

class ProcessWatchDeed : public testing::TestWithParam<Deed> {};

TEST_P(ProcessWatchDeed, IsSeenAndNoOther) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const ProcessWatch watch;
    GetParam().done();
    ::_exit(static_cast<int>(watch.habits()));
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(static_cast<std::uint32_t>(WEXITSTATUS(status)), GetParam().habit);
  EXPECT_EQ(habit_words(GetParam().habit).empty(), GetParam().habit == no_habit);
}

INSTANTIATE_TEST_SUITE_P(All, ProcessWatchDeed, testing::ValuesIn(deeds),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(ProcessWatch, WordsOfSeveralHabitsAreAList) {
  EXPECT_EQ(habit_words(folder_changed | processes_left), "changes the folder of the process, leaves processes behind");
  EXPECT_EQ(habit_words(std::uint32_t{signals_taken} | written_stran | written_props),
            "takes over signals of the process, writes to its inputs (STRAN, PROPS)");
}

TEST(KeptOutput, KeepsBothEndsAndSaysHowMuchIsLeftOut) {
  const auto output = std::make_unique<KeptOutput>();
  EXPECT_EQ(output->text(), "");
  output->add("one\ntwo\n", 8);
  EXPECT_EQ(output->text(), "one\ntwo\n");
  EXPECT_EQ(last_line(output->text()), "two");
  const std::string flood(1000, '#');
  for (int k = 0; k < 1000; ++k) output->add(flood.data(), flood.size());
  output->add("the end\n", 8);
  const std::string text = output->text();
  EXPECT_LT(text.size(), 2 * KeptOutput::size + 100);
  EXPECT_TRUE(text.starts_with("one\ntwo\n###"));
  EXPECT_TRUE(text.ends_with("###the end\n"));
  const std::size_t left_out = 1000016 - 2 * KeptOutput::size;
  EXPECT_NE(text.find("\n[" + std::to_string(left_out) + " bytes are left out]\n"), std::string::npos);
}

}  // namespace
}  // namespace assay::adapters::test_process_watch
