// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/process/kept_process.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "harness/material/progress_mark.hpp"

namespace assay::adapters::test_kept_process {
namespace {

namespace fs = std::filesystem;

constexpr WorkerLimits no_limits{.seconds = 0, .gigabytes = 0};

bool is_over_soon(const KeptProcess& process) {
  for (int waited = 0; waited < 10000; ++waited, ::usleep(1000)) {
    if (process.is_over()) return true;
  }
  return false;
}

[[noreturn]] void sleep_for_long() {
  for (;;) ::pause();
}

/// How a process ends that does so.
template <class Work, class Look>
void kept(const Work& work, const WorkerLimits& limits, const Look& look, Kept how = {}) {
  how.work = work;
  const KeptProcess process(how, limits);
  EXPECT_TRUE(is_over_soon(process));
  look(process.fate());
}

TEST(KeptProcess, TellsItsEndInWords) {
  const auto words = [](const char* expected, int status) {
    return [=](const Fate& fate) {
      EXPECT_EQ(words_of_end(fate), expected);
      EXPECT_EQ(fate.exit_status(), status);
    };
  };
  kept([](Fate&) {}, no_limits, words("ended the process with status 0", 0));
  kept([](Fate&) { leave_now(7); }, no_limits, words("ended the process with status 7", 7));
  kept([](Fate&) { std::raise(SIGTERM); }, no_limits, words("was ended by signal 15 (Terminated)", 128 + SIGTERM));
  const auto say = [](Fate& fate) {
    mark_crashes(fate);
    end_by_word("called XIT");
  };
  kept(say, no_limits, [](const Fate& fate) { EXPECT_EQ(words_of_end(fate), "called XIT"); });
}

TEST(KeptProcess, IsEndedAtItsLimits) {
  const auto busy = [](Fate& fate) {
    fate.busy_since = now_ns();
    sleep_for_long();
  };
  kept(busy, {.seconds = 0.1, .gigabytes = 0}, [](const Fate& fate) { EXPECT_EQ(fate.end(), Death::time_limit); });
  const auto greedy = [](Fate& fate) {
    fate.busy_since = now_ns();
    constexpr std::size_t size = 300'000'000;
    volatile char* memory = new char[size];
    for (std::size_t k = 0; k < size; k += 4096) memory[k] = 1;
    sleep_for_long();
  };
  kept(greedy, {.seconds = 0, .gigabytes = 0.1}, [](const Fate& fate) { EXPECT_EQ(fate.end(), Death::memory); });
}

TEST(KeptProcess, IsHeardAndStandsInAFolderOfItsOwn) {
  std::string folder;
  kept(
      [](Fate& fate) {
        std::printf("%d", fs::current_path() == fate.folder ? 1 : 0);
        std::fflush(stdout);
        const auto says = [](const char* word) { return ::write(STDERR_FILENO, word, 1) == 1; };
        EXPECT_TRUE(says("!") && std::fgetc(stdin) == EOF && says("?"));
      },
      no_limits,
      [&](const Fate& fate) {
        EXPECT_EQ(fate.output.text(), "1!?");
        folder = fate.folder;
        EXPECT_TRUE(fs::path(folder).filename().string().starts_with("assay-check-")) << folder;
      },
      {.folders = "assay-check-"});
  EXPECT_FALSE(fs::exists(folder));
}

TEST(KeptProcess, EndsWithWhatItHasStarted) {
  const auto leave = [](Fate& fate) {
    if (::fork() != 0) return;
    ::setsid();
    fate.habits = static_cast<std::uint64_t>(::getpid()) << 8;
    sleep_for_long();
  };
  kept(leave, no_limits, [](const Fate& fate) {
    const auto left = static_cast<pid_t>(fate.habits.load() >> 8);
    EXPECT_TRUE(left == 0 || ::kill(left, 0) != 0) << "it is gone, or has not begun";
  });
}

TEST(KeptProcess, ThatEndsItsKeeperIsLost) {
  const auto end_keeper = [](Fate&) { ::kill(::getppid(), SIGKILL), sleep_for_long(); };
  kept(end_keeper, no_limits, [](const Fate& fate) {
    EXPECT_EQ(fate.end(), Death::lost);
    EXPECT_TRUE(fate.was_killed());
  });
}

TEST(KeptProcess, AKeeperThatIsStoppedGoesOnOrIsLost) {
  const auto stop_keeper = [](Fate&) { ::kill(::getppid(), SIGSTOP); };
  kept(stop_keeper, no_limits, [](const Fate& fate) { EXPECT_EQ(fate.end(), Death::exit); });
  kept(stop_keeper, no_limits, [](const Fate& fate) { EXPECT_EQ(fate.end(), Death::lost); },
       {.ends_when_stopped = true});
}

TEST(KeptProcess, SignalsToItsKeeperAreLeft) {
  const auto terminate = [](Fate&) { ::kill(::getppid(), SIGTERM), ::usleep(10000); };
  kept(terminate, no_limits, [](const Fate& fate) { EXPECT_EQ(fate.end(), Death::exit); }, {.defers_signals = true});
  kept(terminate, no_limits, [](const Fate& fate) { EXPECT_EQ(fate.end(), Death::lost); });
}

// As on a full disk.
TEST(KeptProcess, NeedsNoFileForItsPage) {
  const pid_t host = ::fork();
  if (host == 0) {
    const rlimit tiny{16, 16};
    std::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &tiny);
    const KeptProcess process({.work = [](Fate&) {}}, no_limits);
    ::_exit(is_over_soon(process) && process.fate().end() == Death::exit ? 0 : 1);
  }
  int status = 1;
  ::waitpid(host, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST(KeptProcess, GoesWithItsHostWhateverEndsThat) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t host = ::fork();
  if (host == 0) {
    const KeptProcess process({.work = [](Fate&) { sleep_for_long(); }}, no_limits);
    const pid_t kept_process = static_cast<pid_t>(process.fate().process.load());
    if (::write(ends[1], &kept_process, sizeof kept_process) < 0) ::_exit(1);
    sleep_for_long();
  }
  pid_t process = 0;
  ASSERT_EQ(::read(ends[0], &process, sizeof process), static_cast<ssize_t>(sizeof process));
  ::kill(host, SIGKILL);
  ::waitpid(host, nullptr, 0);
  for (int waited = 0; waited < 5000 && ::kill(process, 0) == 0; ++waited) ::usleep(1000);
  EXPECT_NE(::kill(process, 0), 0);
  for (const int end : ends) ::close(end);
}

}  // namespace
}  // namespace assay::adapters::test_kept_process
