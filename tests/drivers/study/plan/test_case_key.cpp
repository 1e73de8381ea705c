// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/plan/study.hpp"
#include "drivers/system/program_identity.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <set>

#include "tests/drivers/material/fortran_texts.hpp"
#include "tests/drivers/material/source_fixture.hpp"
#include "tests/drivers/study/study_text_fixture.hpp"
#include "tests/support/built.hpp"

namespace assay::drivers::test_case_key {
namespace {

namespace fs = std::filesystem;

/// The keys of the cases of a study.
std::vector<std::string> keys_in(const StudyFolder& folder, const std::string& text) {
  std::vector<std::string> keys;
  for (const PlannedCase& one : plan_of(folder.read(text)).cases) keys.push_back(one.key);
  return keys;
}

/// The key of the one case of s.yaml.
std::string key_in(const StudyFolder& folder) { return keys_in(folder, "axes: {threads: [1]}\n").at(0); }

/// The same by a process of its own, which has read no library yet; what it throws where it does.
std::string key_elsewhere(const StudyFolder& folder) {
  const std::string said = folder.scratch() / "said";
  const pid_t child = ::fork();
  if (child == 0) {
    try {
      folder.scratch().write("said", key_in(folder));
    } catch (const std::exception& error) {
      folder.scratch().write("said", error.what());
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return bytes_of(said);
}

/// What it reads has no name here: a file, the environment.
TEST(CaseKey, ChangesWithWhatAModelAnswers) {
  const StudyFolder folder;
  const std::string text =
      "set: {force.response: sheet, material: {adapter: " + built("tests/plugins/asks_its_environment.so") +
      ", parameters: {}, density: 1000}}\naxes: {threads: [1]}\n";
  std::set<std::string> keys;
  for (const char* share : {"1", "1.001", "30", "1"}) {
    const Environment variable("ASSAY_TEST_SHARE", share);
    const std::string said = folder.scratch() / "said";
    const pid_t child = ::fork();
    if (child == 0) {
      folder.scratch().write("said", keys_in(folder, text).at(0));
      ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    keys.insert(bytes_of(said));
  }
  EXPECT_EQ(keys.size(), 3u);
}

TEST(CaseKey, ChangesWithEveryValueOfTheScene) {
  const std::vector<std::string> settings{"threads: 2",
                                          "motion.amplitude.peak: 0.9",
                                          "motion.period: 1.25",
                                          "material.parameters.E: 1001",
                                          "material.parameters.nu: 0.31",
                                          "material.density: 1000.0000000000001",
                                          "body.per_cell: [2, 3]",
                                          "method.formulation: total",
                                          "body.outside: free",
                                          "grid.spacing: 0.5",
                                          "method.basis: cpdi2",
                                          "method.transfer: apic",
                                          "method.courant: 0.3",
                                          "force.evaluation: point",
                                          "force.response: none",
                                          "time.end: 0.5",
                                          "time.step: 0.01",
                                          "output.errors: 50",
                                          "limits.particle_steps: 1e11"};
  std::string axes = "axes: {changed: {none: {}";
  for (const std::string& setting : settings) axes += ", '" + setting + "': {" + setting + "}";
  const auto keys = keys_in(StudyFolder(), axes + "}}\n");
  ASSERT_EQ(keys.size(), settings.size() + 1);
  std::set<std::string> known;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    EXPECT_EQ(keys[i].size(), 32u);
    EXPECT_TRUE(known.insert(keys[i]).second) << (i == 0 ? "none" : settings[i - 1]);
  }
}

TEST(CaseKey, IsTheSameOfTheSameScene) {
  const StudyFolder folder;
  const std::string as_given = key_in(folder);
  EXPECT_EQ(key_in(folder), as_given);
  EXPECT_EQ(key_elsewhere(folder), as_given);
  const char* scenes[] = {
      // other order, block style, other numbers' texts
      "force:\n  response: closed_form\nmethod:\n  transfer: flip\n  basis: cpdi\ngrid: {spacing: 7.5e-1}\n"
      "body: {upper: [1.50, 1.5], lower: [-1.5, -1.5], domain: square}  # a comment\n"
      "material:\n  density: 1.0e3\n  parameters: {E: 1000}\n  adapter: 'neo_hookean'\n"
      "motion:\n  type: \"vortex\"\n",
      // defaults written out, other expectations
      "motion: {type: vortex, inner: 0.75, outer: 1.25, period: 1.0, amplitude: {type: sine, peak: 1.0}}\n"
      "material: {adapter: neo_hookean, parameters: {E: 1e3, nu: 0.3}, density: 1000}\n"
      "body: {domain: square, lower: [-1.5, -1.5], upper: [1.5, 1.5], outside: held, per_cell: [2, 2]}\n"
      "grid: {spacing: 0.75}\nmethod: {basis: cpdi, transfer: flip, courant: 0.4}\n"
      "force: {response: closed_form}\ntime: {end: 1}\noutput: {errors: 100}\nexpect: {t: 1}\n"};
  for (const char* scene : scenes) {
    folder.scratch().write("s.yaml", scene);
    EXPECT_EQ(key_in(folder), as_given) << scene;
  }
  EXPECT_EQ(keys_in(folder, "axes: {a: {b: {grid.spacing: 0.75, threads: 1, method.courant: 4.0e-1}}}\n").at(0),
            as_given)
      << "how the study writes it";
}

TEST(CaseKey, DoesNotDependOnWhereTheSceneLies) { EXPECT_EQ(key_in(StudyFolder()), key_in(StudyFolder())); }

TEST(CaseKey, ChangesWithTheBytesOfTheMaterialsLibrary) {
  const StudyFolder folder;
  std::string scene = small_scene;
  scene.replace(scene.find("neo_hookean"), 11, "mine.so");
  folder.scratch().write("s.yaml", scene);
  fs::copy(built("materials/libneo_hookean.so"), folder.scratch() / "mine.so");
  const std::string first = key_elsewhere(folder);
  ASSERT_EQ(first.size(), 32u) << first;
  EXPECT_EQ(key_elsewhere(folder), first);
  const std::string bytes = bytes_of(folder.scratch() / "mine.so");
  folder.scratch().write("mine.so", bytes + '\0');  // the loader does not mind
  const std::string second = key_elsewhere(folder);
  EXPECT_EQ(second.size(), 32u) << second;
  EXPECT_NE(second, first);
  folder.scratch().write("mine.so", bytes);
  EXPECT_EQ(key_elsewhere(folder), first);
}

TEST(CaseKey, ChangesWithALibraryThatTheMaterialsNeeds) {
  const StudyFolder folder;
  std::string scene = small_scene;
  scene.replace(scene.find("neo_hookean"), 11, "asks_a_helper.so");
  scene.replace(scene.find("{E: 1e3}"), 8, "{}");
  scene.replace(scene.find("closed_form"), 11, "none");
  folder.scratch().write("s.yaml", scene);
  for (const std::string file : {"asks_a_helper.so", "libhelper.so"})
    fs::copy(built("tests/plugins/" + file), folder.scratch() / file);
  const std::string first = key_elsewhere(folder);
  ASSERT_EQ(first.size(), 32u) << first;
  EXPECT_EQ(key_elsewhere(folder), first);
  folder.scratch().write("libhelper.so", bytes_of(folder.scratch() / "libhelper.so") + '\0');
  const std::string second = key_elsewhere(folder);
  EXPECT_EQ(second.size(), 32u) << second;
  EXPECT_NE(second, first);
}

TEST(CaseKey, ChangesWithTheFilesThatTheModelReads) {
  const StudyFolder folder;
  std::string scene = small_scene;
  scene.replace(scene.find("neo_hookean"), 11, "mine.yaml");
  folder.scratch().write("s.yaml", scene);
  folder.scratch().write("table.txt", "1 2 3\n");
  folder.scratch().write("mine.yaml", "library: " + built("materials/libneo_hookean.so") + "\nfiles: [table.txt]\n");
  const std::string first = key_elsewhere(folder);
  ASSERT_EQ(first.size(), 32u) << first;
  folder.scratch().write("table.txt", "1 2 4\n");
  const std::string second = key_elsewhere(folder);
  EXPECT_EQ(second.size(), 32u) << second;
  EXPECT_NE(second, first);
}

/// As a routine does that asks for its folder by GETOUTDIR.
TEST(LongCaseKey, ChangesWithFilesBesideASourceThatItsTextNames) {
  if (!has_gfortran()) GTEST_SKIP() << "no Fortran compiler";
  const StudyFolder folder;
  std::string scene = small_scene;
  const std::size_t at = scene.find("material:"), end = scene.find('\n', at);
  scene.replace(at, end - at, "material: {adapter: m.f, parameters: {p1: 1000, p2: 0.3}, density: 1000}");
  folder.scratch().write("s.yaml", scene);
  folder.scratch().write("m.f", fixed_umat("      CHARACTER*256 OUTDIR\n"
                                           "      CALL GETOUTDIR(OUTDIR,LENOUT)\n"
                                           "      OPEN(UNIT=115,FILE=OUTDIR(1:LENOUT)//'/young.dat')\n"
                                           "      READ(115,*) EREAD\n      CLOSE(115)\n" +
                                           hooke_statements));
  const auto key_with = [&](const char* name, const char* text) {
    folder.scratch().write(name, text);
    return key_elsewhere(folder);
  };
  const std::string first = key_with("young.dat", "1000\n");
  ASSERT_EQ(first.size(), 32u) << first;
  EXPECT_NE(key_with("young.dat", "4000\n"), first);
  EXPECT_EQ(key_with("young.dat", "1000\n"), first);
  EXPECT_EQ(key_with("old.dat", "1000\n"), first) << "which it does not name";
}

TEST(CaseKey, ChangesWithTheBytesOfTheMotionsTable) {
  const StudyFolder folder;
  folder.scratch().write("s.yaml",
                         "motion: {type: homogeneous, path: path.csv}\n"
                         "material: {adapter: neo_hookean, parameters: {E: 1e3}, density: 1000}\n"
                         "body: {domain: square, lower: [0, 0], upper: [1, 1]}\n"
                         "grid: {spacing: 0.5}\n"
                         "method: {basis: cpdi, transfer: flip}\n");
  const std::string table = "t,F11,F12,F21,F22,F33\n0,1,0,0,1,1\n0.5,1.1,0,0,1,1\n1,1.2,0,0,1,1\n";
  folder.scratch().write("path.csv", table);
  const std::string first = key_elsewhere(folder);
  ASSERT_EQ(first.size(), 32u) << first;
  folder.scratch().write("path.csv", table + "# nothing\n");
  EXPECT_NE(key_elsewhere(folder), first);
}

TEST(CaseKey, TheProgramIsHashedOnceWithoutMaterials) {
  const std::string before = loaded_identity();
  EXPECT_EQ(before.size(), 64u);
  const StudyFolder folder;
  std::string scene = small_scene;
  scene.replace(scene.find("neo_hookean"), 11, built("materials/libneo_hookean.so"));
  folder.scratch().write("s.yaml", scene);
  const std::string key = key_in(folder);
  EXPECT_EQ(loaded_identity(), before);
  EXPECT_EQ(key_in(folder), key) << "with the library loaded";
}

}  // namespace
}  // namespace assay::drivers::test_case_key
