// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/material_description.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_model_files {
namespace {

class ModelFiles : public testing::Test {
 protected:
  ModelFiles() {
    std::filesystem::create_directories(scratch / "in/dir");
    for (const char* name : {"in/a.txt", "in/dir/b.dat", "c.txt"}) scratch.write(name, name);
  }
  /// "name path|" without the scratch folder.
  std::string read(const std::string& yaml) const {
    std::string text;
    for (const ModelFile& file :
         read_model_files(*read_yaml("files: " + yaml, "d.yaml").find("files"), scratch / "in")) {
      text += file.name + " " + file.path.substr((scratch / "").size()) + "|";
    }
    return text;
  }
  std::string refused(const std::string& yaml) const {
    return refusal_of([&] { read(yaml); });
  }
  ScratchFolder scratch;
};

TEST_F(ModelFiles, OfTheFolderKeepTheirPlaceInIt) {
  EXPECT_EQ(read("[a.txt, dir/b.dat, ../c.txt]"), "a.txt in/a.txt|dir/b.dat in/dir/b.dat|c.txt c.txt|");
  EXPECT_EQ(read("[" + (scratch / "in/dir/b.dat") + "]"), "b.dat in/dir/b.dat|");
  EXPECT_EQ(read("{params.dat: a.txt, fort.15: dir/b.dat}"), "params.dat in/a.txt|fort.15 in/dir/b.dat|");
}

TEST_F(ModelFiles, AreRefusedInOneLine) {
  EXPECT_EQ(refused("[no.txt]"), "d.yaml:1:9: files: '" + (scratch / "in/no.txt") + "': no such file");
  EXPECT_EQ(refused("[dir]"), "d.yaml:1:9: files: '" + (scratch / "in/dir") + "' is no file");
  EXPECT_EQ(refused("[a.txt, ./a.txt]"), "d.yaml:1:16: files: 'a.txt' is there twice");
  EXPECT_EQ(refused("{../x: a.txt}"), "d.yaml:1:15: files: '../x' is no name of a file in a folder");
  EXPECT_EQ(refused("{/x: a.txt}"), "d.yaml:1:13: files: '/x' is no name of a file in a folder");
  EXPECT_EQ(refused("{a/b/c: a.txt, a: a.txt}"),
            "d.yaml:1:26: files: 'a' cannot be a file and the folder of another one");
  EXPECT_EQ(refused("{a: a.txt, a/b: dir/b.dat, ab: a.txt}"),
            "d.yaml:1:24: files: 'a' cannot be a file and the folder of another one");
  EXPECT_NE(refused("a.txt").find("d.yaml:1:8: files: must be"), std::string::npos) << refused("a.txt");
}

TEST_F(ModelFiles, AreLaidWhereTheProcessStands) {
  std::filesystem::create_directories(scratch / "work");
  scratch.write("work/c.txt", "the model's own");
  const pid_t child = ::fork();
  if (child == 0) {  // of which the folder may be changed
    int status = ::chdir((scratch / "work").c_str());
    try {
      place_model_files(
          {{"x.txt", scratch / "in/a.txt"}, {"d/e.dat", scratch / "in/dir/b.dat"}, {"c.txt", scratch / "c.txt"}});
    } catch (const std::exception&) {
      status = 1;
    }
    ::_exit(status);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(bytes_of(scratch / "work/x.txt"), "in/a.txt");
  EXPECT_EQ(bytes_of(scratch / "work/d/e.dat"), "in/dir/b.dat");
  EXPECT_EQ(bytes_of(scratch / "work/c.txt"), "the model's own");
}

}  // namespace
}  // namespace assay::drivers::test_model_files
