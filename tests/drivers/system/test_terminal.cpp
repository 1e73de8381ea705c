// SPDX-License-Identifier: BSD-3-Clause
// Whatever names, labels and paths hold: a terminal is not steered, and no line is forged.
#include "drivers/system/terminal.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "tests/drivers/process.hpp"
#include "tests/drivers/registry_fixture.hpp"
#include "tests/drivers/scene_text.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_terminal {
namespace {

namespace fs = std::filesystem;

const std::string hostile = "a\x1b[31m\u202Eb\nFORGED: pass";

class Terminal : public RegistryTest {
 protected:
  /// What the program says, in the test's folder.
  std::string said(const std::vector<std::string>& words, int status = 0) const {
    const std::string here = folder.string();
    const Ending ending = assay(words, [&] {
      if (::chdir(here.c_str()) != 0) ::_exit(126);
    });
    EXPECT_EQ(ending.status, status) << ending.said;
    return ending.said;
  }
  static void expect_clean(const std::string& text) {
    EXPECT_EQ(text.find_first_of("\x1b\x07\r"), text.npos) << text;
    EXPECT_EQ(text.find("\u202E"), text.npos) << text;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_FALSE(line.starts_with("FORGED")) << text;
  }
};
using LongTerminal = Terminal;

TEST_F(Terminal, LabelsOfALibraryAreText) {
  const std::string library = plugins + "hostile_labels.so";
  const std::string page = said({"materials", library});
  expect_clean(page);
  EXPECT_NE(page.find("<U+001B>[31m"), page.npos) << "and can be seen";
  expect_clean(said({"materials", library, "--json"}));
  expect_clean(said({"register", library, "--as", "fair"}));
  expect_clean(said({"materials"}));
}

TEST_F(LongTerminal, PathsAreText) {
  fs::create_directory(folder / hostile);
  fs::copy_file(plugins + "frozen_1_0.so", folder / hostile / "m.so");
  const std::string scene = tree_folder() + "/configs/paper/tabulate_neo_hookean.yaml";
  write(hostile + "/s.yaml", "title: x\n" + scene_text());
  write(
      "study.yaml",
      "scene: " + tree_folder() +
          "/configs/paper/vortex_cpdi.yaml\naxes: {\"a\\e[31m\\nFORGED: pass\": {x: {material.parameters.nu: 0.2}}}\n");
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"materials", "./" + hostile + "/m.so"},
                                             {"tabulate", scene, "-o", hostile + "/out"},
                                             {"new-material", "clay", "--language", "c", "-o", hostile + "/clay"},
                                             {"study", "study.yaml", "--list"}}) {
    expect_clean(said(words));
  }
  expect_clean(said({"register", "./" + hostile + "/m.so", "--as", "x"}, 2));
  expect_clean(said({"run", hostile + "/s.yaml"}, 2));
  expect_clean(said({"run", hostile + "/none.yaml"}, 2));
}

TEST_F(Terminal, ATableWhoseNameIsNoneIsRefusedWhereverItIsLoaded) {
  for (const char* name : {"path_as_name.so", "name_of_lines.so"}) {
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"materials", plugins + name}, {"check", plugins + name, "--quick"}, {"register", plugins + name}}) {
      const std::string line = said(words, 2);
      expect_clean(line);
      EXPECT_NE(line.find("holds other than small letters, digits and '_'"), line.npos) << line;
    }
  }
}

TEST(PrintedJson, IsTheSameData) {
  testing::internal::CaptureStdout();
  print_json("{\"a\": \"\u009B\u202E\u00E9\"}\n");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "{\"a\": \"\\u009B\\u202E\u00E9\"}\n");
  testing::internal::CaptureStdout();
  print("a\u009Bb\n\u00E9\xFF\n");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "a<U+009B>b\n\u00E9?\n");
}

}  // namespace
}  // namespace assay::drivers::test_terminal
