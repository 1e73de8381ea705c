// SPDX-License-Identifier: BSD-3-Clause
// Folders of the environment that are relative to where the user stands: processes of models stand elsewhere.
#include <gtest/gtest.h>

#include "tests/drivers/process.hpp"
#include "tests/drivers/registry_fixture.hpp"
#include "tests/drivers/scene_text.hpp"

namespace assay::drivers::test_relative_paths {
namespace {

namespace fs = std::filesystem;

class RelativePaths : public RegistryTest {
 protected:
  void SetUp() override {
    RegistryTest::SetUp();
    fs::create_directories(folder / "build");
    fs::copy_file(built("tests/foreign/mfront_neo_hookean.so"), folder / "build/law.so");
    write("law.yaml", "library: law.so\ninterface: mfront\nproperties: {YoungModulus: 1000, PoissonRatio: 0.3}\n");
    write("build/law_here.yaml",
          "library: law.so\ninterface: mfront\nproperties: {YoungModulus: 1000, PoissonRatio: 0.3}\ndensity: 1000\n");
  }
  Ending run(const std::vector<std::string>& words, const std::function<void()>& before = {}) const {
    return assay(words, [&] {
      if (::chdir(folder.c_str()) != 0) ::_exit(126);
      ::setenv("ASSAY_MATERIAL_PATH", "nowhere:build", 1);
      if (before) before();
    });
  }
};
using LongRelativePaths = RelativePaths;

TEST_F(LongRelativePaths, TheSearchPathServesEveryVerb) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"materials", "law.yaml"},
                                                {"check", "law.yaml", "--quick"},
                                                {"check", "law_here", "--quick"},
                                                {"register", "law.yaml", "--as", "mine"}}) {
    const Ending ending = run(words);
    EXPECT_EQ(ending.status, 0) << words[0] << " " << words[1] << "\n" << ending.said;
  }
  write("scene.yaml",
        "motion: {type: vortex, inner: 0.75, outer: 1.25, amplitude: {type: sine, peak: 0.02}}\n"
        "material: {adapter: law_here}\ntime: {end: 0.01}\n");
  const Ending tabulated = run({"tabulate", "scene.yaml", "-o", "out"});
  EXPECT_EQ(tabulated.status, 0) << tabulated.said;
}

TEST_F(LongRelativePaths, SoIsTheFolderForTemporaryFiles) {
  fs::create_directories(folder / "tmp");
  const Ending ending = run({"check", "law_here"}, [] { ::setenv("TMPDIR", "tmp", 1); });
  EXPECT_EQ(ending.status, 0) << ending.said;
  EXPECT_TRUE(fs::is_empty(folder / "tmp"));
}

TEST_F(RelativePaths, AnEmptyOneIsNoneAndAWrongOneIsNamed) {
  const auto with = [&](const char* value) {
    return run({"check", "law_here", "--quick"}, [value] { ::setenv("TMPDIR", value, 1); });
  };
  EXPECT_EQ(with("").status, 0) << with("").said;
  for (const char* wrong : {"/no/such", "build/law.so"}) {
    const Ending ending = with(wrong);
    EXPECT_EQ(ending.status, 3) << ending.said;
    EXPECT_NE(ending.said.find(wrong), std::string::npos) << ending.said;
  }
}

// The loader reads them once, when the program starts.
TEST_F(LongRelativePaths, SoAreThoseOfTheLoader) {
  fs::create_directories(folder / "dep");
  fs::copy_file(built("tests/plugins/libhelper.so"), folder / "dep/libhelper.so");
  fs::copy_file(built("tests/plugins/asks_a_helper.so"), folder / "model.so");
  for (const char* path : {"dep", "nowhere:./dep", "dep:"}) {
    for (const char* verb : {"check", "materials"}) {
      const Ending ending = run({verb, "./model.so"}, [path] { ::setenv("LD_LIBRARY_PATH", path, 1); });
      EXPECT_LE(ending.status, 1) << verb << " " << path << "\n" << ending.said;
      EXPECT_EQ(ending.said.find("libhelper"), std::string::npos) << ending.said;
    }
  }
}

// By its contract: the registry would otherwise be another one in each folder.
TEST_F(RelativePaths, TheRegistryMustBeAbsoluteForEveryVerb) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"materials"}, {"check", "law_here"}, {"register", "law.yaml"}}) {
    const Ending ending = run(words, [] { ::setenv("ASSAY_DATA_HOME", "data", 1); });
    EXPECT_EQ(ending.status, 2) << words[0];
    EXPECT_EQ(ending.said, "ASSAY_DATA_HOME: must be an absolute path, found 'data'\n") << words[0];
  }
}

}  // namespace
}  // namespace assay::drivers::test_relative_paths
