// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/output_folder.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <functional>
#include <optional>
#include <set>
#include <sstream>

#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/whole_file.hpp"

namespace assay::drivers::test_output_folder {
namespace {

namespace fs = std::filesystem;

class OutputFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "assay folder XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    root_ = name;
    target_ = root_ / "a" / "result";
  }
  void TearDown() override { fs::remove_all(root_); }

  static std::string read(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
  }
  static void put(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }
  static std::set<std::string> names(const fs::path& folder) {
    std::set<std::string> out;
    for (const auto& entry : fs::directory_iterator(folder)) out.insert(entry.path().filename().string());
    return out;
  }
  static std::string refusal(const std::function<void()>& action) {
    try {
      action();
    } catch (const InputError& error) {
      return error.what();
    }
    return "no InputError";
  }
  void publish(const std::set<std::string>& files, const std::string& text) const {
    OutputFolder folder(target_);
    for (const std::string& name : files) folder.write(name, text);
    folder.commit();
  }
  template <typename Action>
  static std::string system_error(const Action& action) {
    try {
      action();
    } catch (const SystemError& error) {
      return error.what();
    }
    return "no SystemError";
  }

  fs::path root_, target_;
};

TEST_F(OutputFolderTest, FilesOfSubFoldersAppearAndAreReplaced) {
  const std::vector<std::string> all{"h_1/a.csv", "h_1/deep/b.csv", "README.md"};
  for (const std::string text : {"first", "second"}) {
    OutputFolder folder(target_, all);
    for (const std::string& name : all) folder.write(name, text);
    folder.commit();
    for (const std::string& name : all) EXPECT_EQ(read(target_ / name), text);
    put(target_ / "h_1" / "own.csv", "of the user");
  }
  EXPECT_EQ(read(target_ / "h_1" / "own.csv"), "of the user");
  EXPECT_EQ(names(target_), (std::set<std::string>{"README.md", "h_1"}));
}

TEST_F(OutputFolderTest, SubFoldersThatCannotBeMadeLeaveAllAsItWas) {
  fs::create_directories(target_);
  put(target_ / "z", "a file in the way");
  put(target_ / "a.csv", "before");
  const std::string found = system_error([&] {
    OutputFolder folder(target_, {"a.csv", "h_1/a.csv", "z/b.csv"});
    for (const char* name : {"a.csv", "h_1/a.csv", "z/b.csv"}) folder.write(name, "new");
    folder.commit();
  });
  EXPECT_NE(found.find("z: "), std::string::npos) << found;
  EXPECT_EQ(read(target_ / "a.csv"), "before");
  EXPECT_EQ(names(target_), (std::set<std::string>{"a.csv", "z"}));
}

TEST_F(OutputFolderTest, ARunAndAStudyTakeFoldersOfTheirOwn) {
  const std::vector<std::string> of_a_study{"study.json", "report.html"};
  publish({"result.json", "report.html"}, "run");
  EXPECT_NE(refusal([&] { OutputFolder(target_, of_a_study); }).find("holds the results of a run (result.json)"),
            std::string::npos);
  EXPECT_EQ(read(target_ / "report.html"), "run");
  publish({"result.json"}, "run again");
  fs::remove_all(target_);
  fs::create_directories(target_);
  put(target_ / "study.json", "study");
  put(target_ / "report.html", "study");
  EXPECT_NE(refusal([&] { OutputFolder folder(target_); }).find("holds the results of a study (study.json)"),
            std::string::npos);
  EXPECT_EQ(names(target_), (std::set<std::string>{"report.html", "study.json"}));
  EXPECT_EQ(refusal([&] { OutputFolder(target_, of_a_study); }), "no InputError");
}

TEST_F(OutputFolderTest, nothing_is_there_before_commit_and_all_of_it_after) {
  OutputFolder folder(target_);
  folder.write("result.json", "{}");
  folder.write("errors.csv", std::string("a\0b", 3));
  EXPECT_FALSE(fs::exists(target_ / "result.json"));
  folder.commit();
  EXPECT_EQ(names(target_), (std::set<std::string>{"result.json", "errors.csv"}));
  EXPECT_EQ(read(target_ / "errors.csv"), std::string("a\0b", 3));
}

TEST_F(OutputFolderTest, a_file_may_come_in_pieces_at_any_places) {
  OutputFolder folder(target_);
  folder.write_pieces("last_good.vtu", [](const PutBytes& put) { put(3, "def"), put(0, "abc"); });
  folder.write("result.json", "{}");
  folder.commit();
  EXPECT_EQ(read(target_ / "last_good.vtu"), "abcdef");
  EXPECT_THROW(folder.write_pieces("mine.vtu", [](const PutBytes&) {}), std::logic_error);
}

TEST_F(OutputFolderTest, pieces_that_fail_leave_nothing) {
  const std::string found = system_error([&] {
    OutputFolder folder(target_);
    folder.write_pieces("last_good.vtu", [](const PutBytes& put) { put(std::uint64_t{1} << 63, "beyond any file"); });
  });
  EXPECT_NE(found.find("last_good.vtu: cannot be written"), found.npos) << found;
  EXPECT_EQ(found.find(".assay-"), found.npos) << "the name that the user knows: " << found;
  EXPECT_TRUE(names(root_).empty());
}

TEST_F(OutputFolderTest, without_commit_nothing_is_left_not_even_the_folders) {
  { OutputFolder(target_).write("result.json", "{}"); }
  EXPECT_TRUE(names(root_).empty());
}

TEST_F(OutputFolderTest, failed_run_leaves_the_old_result_as_it_was) {
  publish({"result.json", "errors.csv", "particles_0003.vtu"}, "old");
  {
    OutputFolder folder(target_);
    folder.write("errors.csv", "new");
  }
  EXPECT_EQ(names(target_), (std::set<std::string>{"result.json", "errors.csv", "particles_0003.vtu"}));
  EXPECT_EQ(read(target_ / "errors.csv"), "old");
}

TEST_F(OutputFolderTest, commit_removes_stale_files_of_ours_and_no_others) {
  publish({"result.json", "errors.csv", "particles_0003.vtu", "particles_12345.vtu", "shear.png"}, "old");
  for (const char* name : {"particles_.vtu", "particles_1.vtu.bak", "notes.txt", "my.png"}) put(target_ / name, "mine");
  fs::create_directory(target_ / "particles_7.vtu");
  publish({"result.json", "errors.csv", "particles_0000.vtu"}, "new");
  EXPECT_EQ(names(target_), (std::set<std::string>{"result.json", "errors.csv", "particles_0000.vtu", "particles_.vtu",
                                                   "notes.txt", "particles_1.vtu.bak", "my.png", "particles_7.vtu"}));
  EXPECT_EQ(read(target_ / "errors.csv"), "new");
}

TEST_F(OutputFolderTest, names_that_users_also_use_are_not_removed) {
  publish({"result.json", "sheet.csv"}, "old");
  put(target_ / "points.csv", "mine");
  publish({"result.json"}, "new");
  EXPECT_EQ(names(target_), (std::set<std::string>{"result.json", "points.csv"}));
  EXPECT_EQ(read(target_ / "points.csv"), "mine");
  publish({"result.json", "points.csv"}, "new");
  EXPECT_EQ(read(target_ / "points.csv"), "new");
}

TEST_F(OutputFolderTest, folder_that_holds_no_result_keeps_all_but_what_is_written) {
  fs::create_directories(target_);
  for (const char* name : {"errors.csv", "sheet.csv"}) put(target_ / name, "mine");
  publish({"result.json", "errors.csv"}, "new");
  EXPECT_EQ(names(target_), (std::set<std::string>{"result.json", "errors.csv", "sheet.csv"}));
  EXPECT_EQ(read(target_ / "sheet.csv"), "mine");
}

TEST_F(OutputFolderTest, half_a_commit_is_taken_back) {
  publish({"result.json", "errors.csv", "shear.png"}, "old");
  OutputFolder folder(target_);
  folder.write("errors.csv", "new");
  folder.write("report.html", "new");
  folder.write("result.json", "new");
  fs::create_directory(target_ / "report.html");  // came between write() and commit()
  put(target_ / "report.html" / "file", "");
  EXPECT_NE(system_error([&] { folder.commit(); }).find("report.html"), std::string::npos);
  for (const char* name : {"result.json", "errors.csv", "shear.png"}) EXPECT_EQ(read(target_ / name), "old") << name;
}

TEST_F(OutputFolderTest, refuses_names_that_it_could_not_clean_up) {
  OutputFolder folder(target_);
  EXPECT_THROW(folder.write("other.txt", ""), std::logic_error);
  EXPECT_THROW(folder.write("../result.json", ""), std::logic_error);
}

TEST_F(OutputFolderTest, says_what_is_in_the_way) {
  put(root_ / "file", "");
  const std::string file = system_error([&] { OutputFolder(root_ / "file"); });
  EXPECT_NE(file.find((root_ / "file").string() + ": "), std::string::npos) << file;
  EXPECT_NE(system_error([&] { OutputFolder(root_ / "file" / "below"); }).find("file"), std::string::npos);
  EXPECT_NE(system_error([&] { OutputFolder("/proc/assay/result"); }).find("/proc/assay: "), std::string::npos);
  fs::create_directories(target_ / "errors.csv");
  OutputFolder folder(target_);
  const std::string blocked = system_error([&] { folder.write("errors.csv", ""); });
  EXPECT_NE(blocked.find((target_ / "errors.csv").string() + ": "), std::string::npos) << blocked;
}

TEST_F(OutputFolderTest, unwritable_folder_is_refused) {
  fs::create_directories(target_);
  fs::permissions(root_, static_cast<fs::perms>(0755));
  fs::permissions(target_, static_cast<fs::perms>(0555));
  const bool root = ::geteuid() == 0;  // who may write everywhere: somebody else tries
  constexpr uid_t nobody = 65534;
  if (root) {
    ASSERT_EQ(::seteuid(nobody), 0);
  }
  const std::string refused = system_error([&] { OutputFolder folder(target_); });
  if (root) {
    ASSERT_EQ(::seteuid(0), 0);
  }
  EXPECT_NE(refused.find(target_.string()), std::string::npos) << refused;
  fs::permissions(target_, fs::perms::owner_all);
}

// A disk that is full in the middle of a file: the limit on file sizes fails write() in the same place.
TEST_F(OutputFolderTest, full_disk_is_an_error_that_leaves_nothing) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4096, 4096};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    std::string what;
    try {
      OutputFolder folder(target_);
      folder.write("result.json", "{}");
      folder.write("errors.csv", std::string(1 << 20, 'x'));
      folder.commit();
    } catch (const SystemError& error) {
      what = error.what();
    }
    ::_exit(what.starts_with((target_ / "errors.csv").string() + ": ") ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_TRUE(names(root_).empty());
}

TEST_F(OutputFolderTest, next_run_sweeps_up_after_a_killed_one) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    OutputFolder folder(target_);
    folder.write("result.json", "{}");
    ::_exit(0);  // no destructor
  }
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  const std::set<std::string> left = names(target_);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_TRUE(left.begin()->starts_with(".assay-")) << *left.begin();
  const std::string alive = hidden_name();
  fs::create_directory(target_ / alive);
  publish({"result.json"}, "new");
  EXPECT_EQ(names(target_), (std::set<std::string>{"result.json", alive}));
}

TEST_F(OutputFolderTest, a_second_writer_is_refused) {
  OutputFolder first(target_);
  EXPECT_EQ(system_error([&] { OutputFolder second(target_); }), target_.string() + ": another run is writing here");
  first.write("result.json", "first");
  first.commit();
  EXPECT_EQ(names(target_), std::set<std::string>{"result.json"}) << "the lock leaves no file";
}

TEST_F(OutputFolderTest, the_lock_ends_with_the_folder) {
  { OutputFolder first(target_); }
  publish({"result.json"}, "x");
  publish({"result.json"}, "y");
  EXPECT_EQ(read(target_ / "result.json"), "y");
}

TEST_F(OutputFolderTest, two_processes_never_mix_their_results) {
  for (int round = 0; round < 30; ++round) {
    std::vector<pid_t> writers;
    for (const char* text : {"a", "b"}) {
      writers.push_back(::fork());
      ASSERT_GE(writers.back(), 0);
      if (writers.back() != 0) continue;
      int status = 0;
      try {
        publish({"result.json", "errors.csv", "sheet.csv", "curve.csv"}, text);
      } catch (const SystemError& error) {
        status = error.what() == target_.string() + ": another run is writing here" ? 1 : 2;
      }
      ::_exit(status);
    }
    int done = 0;
    for (const pid_t writer : writers) {
      int status = 0;
      ASSERT_EQ(::waitpid(writer, &status, 0), writer);
      ASSERT_LE(WEXITSTATUS(status), 1);
      done += WEXITSTATUS(status) == 0;
    }
    EXPECT_GE(done, 1);
    for (const char* name : {"errors.csv", "sheet.csv", "curve.csv"}) {
      EXPECT_EQ(read(target_ / name), read(target_ / "result.json"));
    }
  }
}

TEST_F(OutputFolderTest, a_stale_table_of_points_goes_with_the_rest) {
  publish({"result.json", "points.csv"}, "xi,t,gamma,tau11\n0,0,0,0\n");
  publish({"result.json"}, "new");
  EXPECT_EQ(names(target_), std::set<std::string>{"result.json"});
}

TEST_F(OutputFolderTest, an_input_that_the_result_would_replace_is_refused) {
  publish({"result.json"}, "x");
  put(target_ / "points.csv", "xi,t\n0,0\n");
  put(target_ / "mine.csv", "xi,t\n0,0\n");
  OutputFolder folder(target_);
  read_bytes(target_ / "mine.csv");
  folder.keep_inputs();
  fs::create_symlink(target_ / "points.csv", root_ / "link");
  read_bytes(root_ / "link");
  EXPECT_THROW(folder.keep_inputs(), InputError);
  forget_inputs();
  folder.keep_inputs();
  note_input(target_ / "points.csv");
  EXPECT_THROW(folder.keep_inputs(), InputError);
  forget_inputs();
}

TEST_F(OutputFolderTest, serves_under_any_umask) {
  const mode_t before = ::umask(0777);
  const auto mode = [](const fs::path& path) { return fs::status(path).permissions(); };
  {
    OutputFolder folder(target_);
    EXPECT_EQ(mode(target_.parent_path()), fs::perms::owner_all);
    EXPECT_EQ(mode(target_ / *names(target_).begin()), fs::perms::owner_all);
    folder.write("result.json", "{");
    folder.write("result.json", "{}");
    folder.commit();
  }
  ::umask(before);
  EXPECT_EQ(mode(target_ / "result.json"), fs::perms::none) << "files are as the umask says";
}

}  // namespace
}  // namespace assay::drivers::test_output_folder
