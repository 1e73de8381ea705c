// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/verbs/verbs.hpp"

#include <sys/stat.h>

#include "drivers/format/yaml_writer.hpp"
#include "drivers/material/registry.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/registry_fixture.hpp"
#include "tests/support/built.hpp"

namespace assay::drivers::test_register {
namespace {

namespace fs = std::filesystem;

class Register : public RegistryTest {
 protected:
  static int add(const std::string& file, const std::string& name = {}) {
    return register_material({file, name, {}, Verbosity::quiet});
  }
  static std::string refused(const std::string& file, const std::string& name = {}) {
    return refusal_of([&] { add(file, name); });
  }
  std::size_t entries() const {
    std::error_code code;
    std::size_t count = 0;
    for (fs::directory_iterator at(folder / "data/materials", code), end; !code && at != end; at.increment(code))
      ++count;
    return count;
  }
};

TEST_F(Register, ALibraryByItsOwnOrAnotherName) {
  EXPECT_EQ(add(plugins + "frozen_1_0.so"), 0);
  EXPECT_EQ(add(plugins + "two_models.so:second", "soft-clay.2"), 0);
  EXPECT_STREQ(find_material("frozen", {}, "").table->name, "frozen");
  EXPECT_STREQ(find_material("soft-clay.2", {}, "").table->name, "second");
  EXPECT_EQ(read("data/materials/frozen.yaml"),
            "library: " + yaml_scalar(plugins + "frozen_1_0.so") + "\nname: frozen\ninterface: native\n");
  EXPECT_EQ(entries(), 2u) << "no temporary file is left";
}

TEST_F(Register, ARelativePathIsWrittenAbsolute) {
  const fs::path before = fs::current_path();
  fs::current_path(plugins);
  EXPECT_EQ(add("frozen_1_0.so"), 0);
  fs::current_path(before);
  EXPECT_EQ(find_material("frozen", {}, "").library, plugins + "frozen_1_0.so");
}

TEST_F(Register, ADescriptionUnderItsFileName) {
  fs::copy_file(plugins + "two_models.so", folder / "local.so");
  const std::string file =
      write("stiff.yaml", "library: local.so\nname: first\nparameters: {modulus: 0.1}\ndensity: 7\n");
  EXPECT_EQ(add(file), 0);
  EXPECT_EQ(read("data/materials/stiff.yaml"),
            "library: " + (folder / "local.so").string() +
                "\nname: first\ninterface: native\nparameters:\n  modulus: 0.1\ndensity: 7\n");
  EXPECT_EQ(find_material("stiff", {}, "").parameters.at("modulus"), 0.1);
}

TEST_F(Register, RegisteringAgainReplaces) {
  add(plugins + "two_models.so:first", "x");
  add(plugins + "two_models.so:second", "x");
  EXPECT_STREQ(find_material("x", {}, "").table->name, "second");
  std::vector<std::string> said;
  for (const char* name : {"x", "y"}) {
    testing::internal::CaptureStdout();
    register_material({plugins + "two_models.so:first", name, {}, Verbosity::normal});
    said.push_back(testing::internal::GetCapturedStdout());
  }
  EXPECT_TRUE(said[0].ends_with("; replaces what had that name\n")) << said[0];
  EXPECT_TRUE(said[1].ends_with("two_models.so\n")) << said[1];
}

/// As some soils do that need a pressure: `check` tells the rest.
TEST_F(Register, KeepsWhatRefusesToBeAtRestAndSaysSo) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(register_material({plugins + "not_finite.so", {}, {}, Verbosity::normal}), 0);
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_NE(said.find("it refuses an undeformed point: the material returned a stress"), std::string::npos) << said;
  EXPECT_EQ(entries(), 1u);
}

TEST_F(Register, RefusesWhatFailsTheProbeAndWritesNothing) {
  for (const char* name : {"crashes", "exits", "refuses", "no_entry", "other_major", "wrong_major", "small_struct",
                           "every_index", "unresolved", "two_models", "absent"}) {
    EXPECT_NE(refused(plugins + name + ".so"), "accepted") << name;
  }
  const std::string bad =
      write("bad.yaml", "library: " + plugins + "two_models.so\nname: first\nparameters: {modulus: -1}\n");
  EXPECT_NE(refused(bad).find("must lie from"), std::string::npos);
  EXPECT_EQ(entries(), 0u);
}

TEST_F(Register, ALibraryOfMfrontDescribesItself) {
  const std::string library = built("tests/foreign/mfront_neo_hookean.so");
  testing::internal::CaptureStdout();
  EXPECT_EQ(register_material({library, "rubber", {}, Verbosity::normal}), 0);
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_NE(said.find("mfront, NeoHookean"), std::string::npos) << said;
  EXPECT_NE(said.find("must give YoungModulus, PoissonRatio"), std::string::npos) << said;
  EXPECT_NE(said.find("scenes must give its density"), std::string::npos) << said;
  EXPECT_TRUE(find_material("rubber", {}, "").foreign);
  EXPECT_EQ(add(library + ":NeoHookean", "rubber2"), 0);
  EXPECT_NE(refused(library + ":Norton").find("has no behaviour 'Norton'; known: NeoHookean"), std::string::npos);
}

TEST_F(Register, APipeAmongTheNamesIsNoName) {
  add(plugins + "frozen_1_0.so");
  ASSERT_EQ(::mkfifo((folder / "data/materials/pipe.yaml").c_str(), 0600), 0);
  for (const RegisteredName& registered : registered_names()) EXPECT_NE(registered.name, "pipe");
}

TEST_F(Register, CountsTheStateAsItsAuthorDoes) {
  const std::string library = built("tests/foreign/umat_j2.so");
  if (!fs::exists(library)) GTEST_SKIP() << "no Fortran compiler";
  const std::string file = write("clay.yaml", "library: " + library + "\ninterface: umat\ndensity: 1000\n" +
                                                  "properties: {E: 1.0e3, nu: 0.3, y: 10, h: 20, c: 50}\n" +
                                                  "state: {back: symmetric_tensor, p: scalar}\n");
  testing::internal::CaptureStdout();
  register_material({file, {}, {}, Verbosity::normal});
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_NE(said.find("5 properties, 2 state variables of 7 numbers"), std::string::npos) << said;
}

TEST_F(Register, ASubroutineNeedsADescription) {
  const std::string library = built("tests/foreign/umat_neo_hookean.so");
  if (!fs::exists(library)) GTEST_SKIP() << "no Fortran compiler";
  EXPECT_EQ(refused(library), "'" + library + "' exports 'umat_', a UMAT: it needs a description, a YAML file with " +
                                  "library, interface: umat, properties and state");
  EXPECT_EQ(entries(), 0u);
}

TEST_F(Register, SaysThatTheStressDependsOnTheDuration) {
  const std::string library = built("tests/foreign/mfront_norton.so");
  const std::string properties =
      "\ninterface: mfront\nproperties: {YoungModulus: 1e3, PoissonRatio: 0.3, A: 1e-3, n: 2}\n";
  const auto said = [&](const std::string& keys) {
    const std::string file = write("creep.yaml", "library: " + library + properties + keys);
    testing::internal::CaptureStdout();
    register_material({file, "creep", {}, Verbosity::normal});
    return testing::internal::GetCapturedStdout().find("the stress depends on the length of a step") !=
           std::string::npos;
  };
  EXPECT_TRUE(said(""));
  EXPECT_FALSE(said("flags: [rate_dependent]\n"));
}

TEST_F(Register, CountsTheStateThatMetadataTells) {
  testing::internal::CaptureStdout();
  register_material({built("tests/foreign/mfront_norton.so"), "creep", {}, Verbosity::normal});
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_TRUE(said.starts_with("registered creep: norton in ")) << said;
  EXPECT_NE(said.find("2 state variables of 7"), std::string::npos) << said;
}

TEST_F(Register, RefusesBadNames) {
  EXPECT_EQ(refused(plugins + "frozen_1_0.so", "neo_hookean"),
            "--as: 'neo_hookean' is the name of a built-in material; choose another with --as");
  EXPECT_TRUE(refused(built("materials/libneo_hookean.so")).ends_with("choose another with --as"));
  for (const char* name : {"a/b", "../x", ".x", "x.so", "x.yaml", "a b", "-x", "a\nb"}) {
    EXPECT_TRUE(refused(plugins + "frozen_1_0.so", name).starts_with("--as: ")) << name;
  }
  EXPECT_EQ(entries(), 0u);
}

TEST_F(Register, RemovesWhatWasRegistered) {
  add(plugins + "frozen_1_0.so");
  EXPECT_EQ(refusal_of([] {
              register_material({{}, {}, "frozn", Verbosity::quiet});
            }),
            "--remove: unknown name 'frozn' (nearest: frozen); known: frozen");
  EXPECT_EQ(register_material({{}, {}, "frozen", Verbosity::quiet}), 0);
  EXPECT_EQ(entries(), 0u);
  EXPECT_EQ(refusal_of([] {
              register_material({{}, {}, "frozen", Verbosity::quiet});
            }),
            "--remove: unknown name 'frozen'; known: none");
  EXPECT_EQ(refusal_of([] {
              register_material({{}, {}, "neo_hookean", Verbosity::quiet});
            }),
            "--remove: 'neo_hookean' is built in");
  write("data/secret.yaml", "");
  EXPECT_NE(refusal_of([] { register_material({{}, {}, "../secret", Verbosity::quiet}); }), "accepted");
  EXPECT_TRUE(fs::exists(folder / "data/secret.yaml"));
}

TEST_F(Register, RemovesNoFolder) {
  fs::create_directories(folder / "data/materials/dir.yaml");
  EXPECT_TRUE(refusal_of([] {
                register_material({{}, {}, "dir", Verbosity::quiet});
              }).ends_with("dir.yaml' is a folder and no registered name"));
  EXPECT_TRUE(fs::exists(folder / "data/materials/dir.yaml"));
  for (const RegisteredName& each : registered_names()) EXPECT_NE(each.name, "dir");
}

TEST_F(Register, RefusesPathsThatTheRegistryCannotKeep) {
  for (const char* name : {"a\nb.so", "a\x7f.so", "a\xff.so", "\xc3.so"}) {
    fs::copy_file(plugins + "frozen_1_0.so", folder / name);
    const std::string line = refused((folder / name).string(), "x");
    EXPECT_TRUE(line.starts_with("FILE: its path ")) << line;
  }
  fs::copy_file(plugins + "frozen_1_0.so", folder / "\xc3\xa4 b.so");
  EXPECT_EQ(add((folder / "\xc3\xa4 b.so").string()), 0);
  EXPECT_EQ(find_material("frozen", {}, "").library, (folder / "\xc3\xa4 b.so").string());
}

TEST_F(Register, ARelativeDataHomeIsRefused) {
  setenv("ASSAY_DATA_HOME", "data", 1);
  EXPECT_EQ(refused(plugins + "frozen_1_0.so"), "ASSAY_DATA_HOME: must be an absolute path, found 'data'");
}

TEST_F(Register, SaysThatTheWorkingDirectoryIsGone) {
  const fs::path before = fs::current_path();
  fs::create_directory(folder / "gone");
  fs::current_path(folder / "gone");
  fs::remove(folder / "gone");
  std::string line;
  try {
    add("frozen_1_0.so");
  } catch (const SystemError& error) {
    line = error.what();
  }
  fs::current_path(before);
  EXPECT_TRUE(line.starts_with("the working directory cannot be found: ")) << line;
}

TEST_F(Register, AnUnusableRegistryIsTheSystemsFault) {
  write("data", "a file where the folder should be");
  EXPECT_THROW(add(plugins + "frozen_1_0.so"), SystemError);
}

}  // namespace
}  // namespace assay::drivers::test_register
