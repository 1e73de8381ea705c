// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/whole_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <set>

#include "drivers/system/interrupt.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_whole_file {
namespace {

namespace fs = std::filesystem;

/// Nobody waits for ever for a reader.
TEST(LongWholeFile, APipeThatNobodyReadsIsSaid) {
  const ScratchFolder scratch;
  const std::string pipe = scratch / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  try {
    write_file(pipe, "x");
    ADD_FAILURE() << "written";
  } catch (const SystemError& error) {
    EXPECT_EQ(error.what(), pipe + ": is a pipe that nobody reads");
  }
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  write_file(pipe, "x");
  char read = 0;
  EXPECT_EQ(::read(reader, &read, 1), 1);
  ::close(reader);
}

TEST(WholeFile, WhoCouldNotReadAFileStillCannot) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("private", "x");
  for (const auto mode : {fs::perms::owner_read | fs::perms::owner_write, fs::perms{0640}}) {
    fs::permissions(file, mode);
    write_file(file, "y");
    EXPECT_EQ(fs::status(file).permissions(), mode);
    EXPECT_EQ(bytes_of(file), "y");
  }
}

std::set<std::string> names(const fs::path& folder) {
  std::set<std::string> out;
  for (const auto& entry : fs::directory_iterator(folder)) out.insert(entry.path().filename().string());
  return out;
}

template <typename Action>
std::string system_error(const Action& action) {
  try {
    action();
  } catch (const SystemError& error) {
    return error.what();
  }
  return "no SystemError";
}

TEST(WriteFile, ReplacesWholeFilesAndReportsDevices) {
  const ScratchFolder scratch;
  const std::string path = scratch.write("out.csv", "old"), link = scratch / "link";
  write_file(path, "new");
  EXPECT_EQ(bytes_of(path), "new");
  EXPECT_EQ(names(scratch / ""), std::set<std::string>{"out.csv"});
  fs::create_symlink(path, link);
  write_file(link, "through");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(bytes_of(path), "through");
  const std::string full = system_error([] { write_file("/dev/full", "x"); });
  EXPECT_TRUE(full.starts_with("/dev/full: cannot be written: ")) << full;
  const std::string missing = system_error([&] { write_file(scratch / "none/x", "x"); });
  EXPECT_TRUE(missing.starts_with((scratch / "none/x") + ": ")) << missing;
  EXPECT_NE(system_error([&] { write_file(scratch / "", "x"); }), "no SystemError");
}

TEST(WriteFile, SweepsWhatAKilledProcessLeft) {
  const ScratchFolder scratch;
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    scratch.write(hidden_name(), "half");
    ::_exit(0);
  }
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  ASSERT_EQ(names(scratch / "").size(), 1u);
  const std::string alive = hidden_name();
  scratch.write(alive, "of a process that lives");
  write_file(scratch / "out.csv", "x");
  EXPECT_EQ(names(scratch / ""), (std::set<std::string>{"out.csv", alive}));
}

TEST(WriteFileDeathTest, LeavesNothingWhenInterrupted) {
  const ScratchFolder scratch;
  EXPECT_EXIT(
      {
        watch_interrupts();
        std::raise(SIGTERM);
        try {
          write_file(scratch / "out.csv", "x");
        } catch (const Interrupted& stop) {
          std::_Exit(128 + stop.signal);
        }
        std::_Exit(0);
      },
      testing::ExitedWithCode(143), "");
  EXPECT_TRUE(names(scratch / "").empty());
}

}  // namespace
}  // namespace assay::drivers::test_whole_file
