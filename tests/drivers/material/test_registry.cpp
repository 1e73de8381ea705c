// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/registry.hpp"

#include <cstdlib>

#include "adapters/builtin.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/registry_fixture.hpp"
#include "tests/support/built.hpp"

namespace assay::drivers::test_registry {
namespace {

namespace fs = std::filesystem;

class Registry : public RegistryTest {
 protected:
  static MaterialSource find(const std::string& adapter) { return find_material(adapter, {"f", 1, 2}, "k"); }
  static std::string refused(const std::string& adapter) {
    return refusal_of([&] { find(adapter); });
  }
};

TEST_F(Registry, NamesLeadToBuiltInModelsFirst) {
  fs::create_directories(folder / "data/materials");
  write("data/materials/neo_hookean.yaml", "library: " + plugins + "two_models.so\nname: first\n");
  const MaterialSource found = find("neo_hookean");
  EXPECT_EQ(found.table, adapters::builtin_table("neo_hookean"));
  EXPECT_EQ(found.library, "");
}

TEST_F(Registry, ThenTheUsersRegistryThenTheSearchPath) {
  write("path/both.yaml", "library: " + plugins + "two_models.so\nname: second\n");
  setenv("ASSAY_MATERIAL_PATH", (":/absent/folder:" + (folder / "path").string() + "::").c_str(), 1);
  EXPECT_STREQ(find("both").table->name, "second");
  write("data/materials/both.yaml",
        "library: " + plugins + "two_models.so\nname: first\nparameters: {modulus: 5}\ndensity: 7\n");
  const MaterialSource found = find("both");
  EXPECT_STREQ(found.table->name, "first");
  EXPECT_EQ(found.description, (folder / "data/materials/both.yaml").string());
  EXPECT_EQ(found.library, plugins + "two_models.so");
  EXPECT_EQ(found.parameters.at("modulus"), 5);
  EXPECT_EQ(found.density, 7);
}

TEST_F(Registry, SearchPathTakesLibrariesWithAndWithoutPrefix) {
  fs::create_directories(folder / "path");
  fs::copy_file(plugins + "frozen_1_0.so", folder / "path/soft.so");
  fs::copy_file(plugins + "frozen_1_0.so", folder / "path/libhard.so");
  fs::copy_file(plugins + "anisotropic.so", folder / "path/libsoft.so");
  setenv("ASSAY_MATERIAL_PATH", (folder / "path").c_str(), 1);
  EXPECT_EQ(find("soft").library, (folder / "path/soft.so").string()) << "NAME.so before libNAME.so";
  EXPECT_EQ(find("hard").library, (folder / "path/libhard.so").string());
  std::string names, builtin;
  for (const RegisteredName& name : registered_names()) names += name.name + " ";
  for (const auto* table : adapters::builtin_tables()) builtin += table->name + std::string(" ");
  EXPECT_EQ(names, builtin + "hard soft ");
}

/// Neither is read as what it is not.
TEST_F(Registry, SourcesOfOtherLanguagesAndObjectFilesAreToldWhatToDo) {
  for (const char* name : {"u.c", "u.cpp", "u.py"}) {
    write(name, "x");
    EXPECT_NE(refused((folder / name).string()).find("build a shared library"), std::string::npos) << name;
    EXPECT_NE(refused(name).find("build a shared library"), std::string::npos) << refused(name);
  }
  write("m.c", "int x;\n");
  ASSERT_EQ(std::system(("cc -c -o " + (folder / "m.o").string() + " " + (folder / "m.c").string()).c_str()), 0);
  EXPECT_NE(refused((folder / "m.o").string()).find("gcc -shared"), std::string::npos)
      << refused((folder / "m.o").string());
}

TEST_F(Registry, ADescriptionStandsBeforeItsLibrary) {
  write("path/soft.yaml", "library: libsoft.so\ninterface: native\ndensity: 7\n");
  fs::copy_file(plugins + "frozen_1_0.so", folder / "path/libsoft.so");
  setenv("ASSAY_MATERIAL_PATH", (folder / "path").c_str(), 1);
  EXPECT_EQ(find("soft").density, 7);
}

TEST_F(Registry, PathsAreLoadedDirectly) {
  EXPECT_STREQ(find(plugins + "two_models.so:second").table->name, "second");
  EXPECT_STREQ(find(built("materials/libneo_hookean.so")).table->name, "neo_hookean");
  fs::copy_file(plugins + "two_models.so", folder / "local.so");
  const std::string file = write("soft.yaml", "library: local.so\nname: second\ninterface: native\n");
  EXPECT_EQ(find(file).library, (folder / "local.so").string()) << "relative to the description";
}

TEST_F(Registry, RefusesInOneLineThatSaysWhere) {
  std::vector<std::string> builtin;
  for (const auto* table : adapters::builtin_tables()) builtin.emplace_back(table->name);
  EXPECT_EQ(refused("neo_hokean"),
            "f:1:2: k: unknown material 'neo_hokean' (nearest: neo_hookean); known: " + joined(builtin));
  EXPECT_EQ(refused("/absent/lib.so"), "f:1:2: k: no such file: '/absent/lib.so'");
  EXPECT_EQ(refused(plugins + "two_models.so"), "f:1:2: k: '" + plugins +
                                                    "two_models.so' holds several materials; say which as FILE:NAME; "
                                                    "known: first, second");
  EXPECT_EQ(refused(plugins + "two_models.so:thrid"),
            "f:1:2: k: '" + plugins + "two_models.so' holds no material 'thrid'; known: first, second");
  EXPECT_NE(refused(""), "accepted");
  EXPECT_NE(refused("/"), "accepted");
  EXPECT_NE(refused(".so"), "accepted");
}

TEST_F(Registry, DescriptionsAreStrict) {
  const auto line = [&](const std::string& text) { return refused(write("d.yaml", text)); };
  const std::string file = (folder / "d.yaml").string(), library = "library: " + plugins + "two_models.so\n";
  const std::string known = "library, name, interface, density, time_limit, memory_limit, files, parameters";
  EXPECT_EQ(line("name: x\n"), file + ":1:1: library: required and not given; known: " + known);
  EXPECT_EQ(line(library + "nmae: first\n"), file + ":2:1: nmae: unknown key (nearest: name); known: " + known);
  EXPECT_EQ(line(library + "interface: umap\n"),
            file +
                ":2:12: interface: unknown value 'umap' (nearest: umat); known: native, umat, vumat, mfront, "
                "usermat, lsdyna");
  EXPECT_EQ(line(library + "density: 0\n"), file + ":2:10: density: must be greater than 0, found '0'");
  EXPECT_EQ(line(library + "parameters: {modulus: .nan}\n"),
            file + ":2:23: parameters.modulus: must be a finite number, found '.nan'");
  EXPECT_EQ(line(library + "name: third\n"),
            file + ":2:7: name: '" + plugins + "two_models.so' holds no material 'third'; known: first, second");
  EXPECT_EQ(line("library: absent.so\n"), file + ":1:10: library: '" + (folder / "absent.so").string() +
                                              "' no such library, and none of that name in $ASSAY_MATERIAL_PATH");
  const std::string norton = built("tests/foreign/mfront_norton.so");
  EXPECT_EQ(
      line("library: " + norton + "\n"),
      file + ":1:10: library: '" + norton + "' is no plug-in of the ABI: the description lacks interface: mfront");
  EXPECT_EQ(line(""), file + ": empty");
}

TEST_F(Registry, TheFolderFollowsTheEnvironment) {
  EXPECT_EQ(registry_folder(), (folder / "data/materials").string());
  unsetenv("ASSAY_DATA_HOME");
  const std::string home = std::getenv("HOME") ? std::getenv("HOME") : "";
  setenv("XDG_DATA_HOME", "/xdg", 1);
  EXPECT_EQ(registry_folder(), "/xdg/assay/materials");
  setenv("XDG_DATA_HOME", "relative", 1);
  setenv("HOME", "/home/x", 1);
  EXPECT_EQ(registry_folder(), "/home/x/.local/share/assay/materials");
  unsetenv("XDG_DATA_HOME");
  unsetenv("HOME");
  EXPECT_EQ(registry_folder(), "");
  EXPECT_STREQ(find("neo_hookean").table->name, "neo_hookean");
  setenv("HOME", home.c_str(), 1);
}

}  // namespace
}  // namespace assay::drivers::test_registry
