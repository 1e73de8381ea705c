// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/verbs/verbs.hpp"

#include <cstdlib>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "tests/drivers/process.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/registry_fixture.hpp"
#include "tests/support/built.hpp"

namespace assay::drivers::test_new_material {
namespace {

namespace fs = std::filesystem;

struct Flavour {
  const char *language, *interface, *source;
};

const Flavour flavours[] = {{"c", "native", "clay.c"},
                            {"c++", "native", "clay.cpp"},
                            {"fortran", "native", "clay.f90"},
                            {"fortran", "umat", "clay.f90"}};

void PrintTo(const Flavour& flavour, std::ostream* out) { *out << flavour.language << " " << flavour.interface; }

std::string name_of(const testing::TestParamInfo<Flavour>& info) {
  return info.param.interface == std::string("umat") ? "Umat"
         : info.param.language == std::string("c++") ? "Cpp"
         : info.param.language == std::string("c")   ? "C"
                                                     : "Fortran";
}

/// Writes projects into the test's folder.
class NewMaterial : public RegistryTest {
 protected:
  int make(const std::string& name, const Flavour& flavour, const std::string& out = "clay") const {
    return new_material({name, flavour.language, flavour.interface, (folder / out).string(), Verbosity::quiet});
  }
  std::string refused(const std::string& name, const Flavour& flavour, const std::string& out = "clay") const {
    return refusal_of([&] { make(name, flavour, out); });
  }
  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      names.insert(fs::relative(entry.path(), folder).string());
    return names;
  }
};

class NewMaterialFlavours : public NewMaterial, public testing::WithParamInterface<Flavour> {};

TEST_P(NewMaterialFlavours, WritesAFewFilesWithoutPlaceholders) {
  ASSERT_EQ(make("clay", GetParam()), 0);
  std::set<std::string> expected{"clay", "clay/.gitignore", "clay/CMakeLists.txt", "clay/README.md",
                                 "clay/vortex.yaml"};
  expected.insert("clay/" + std::string(GetParam().source));
  if (GetParam().interface == std::string("umat")) expected.insert("clay/clay.yaml");
  EXPECT_EQ(files(), expected);
  for (const std::string& name : expected) {
    if (name == "clay") continue;
    const std::string text = read(name);
    EXPECT_FALSE(std::regex_search(text, std::regex("@[A-Z]+@|SPDX|NAME"))) << name;
    EXPECT_TRUE(name.ends_with(".gitignore") || text.find("clay") != std::string::npos) << name;
    EXPECT_TRUE(text.ends_with("\n") && !text.ends_with("\n\n")) << name;
  }
}

TEST_P(NewMaterialFlavours, TellsTheNextCommands) {
  const std::string here = folder.string();
  const Ending ending =
      assay({"new-material", "clay", "--language", GetParam().language, "--interface", GetParam().interface}, [&] {
        if (::chdir(here.c_str()) != 0) ::_exit(126);
      });
  ASSERT_EQ(ending.status, 0) << ending.said;
  std::istringstream lines(ending.said);
  for (std::string line; std::getline(lines, line);) {
    const bool has_path = line.starts_with("  cmake -B build -D ") || line.find("run vortex.yaml") != line.npos;
    EXPECT_TRUE(line.size() <= 80u || has_path) << line;
  }
  for (const char* word :
       {"CMakeLists.txt", "README.md", "vortex.yaml", GetParam().source, "cd clay\n", "cmake -B build",
        "cmake --build build", "ctest --test-dir build", "assay run vortex.yaml\n"})
    EXPECT_NE(ending.said.find(word), std::string::npos) << word;
  EXPECT_TRUE(fs::exists(folder / "clay/README.md"));
}

/// No line of Fortran may be longer than 132 columns.
TEST_P(NewMaterialFlavours, TakesTheLongestName) {
  const std::string name(60, 'a');
  ASSERT_EQ(make(name, GetParam()), 0);
  testing::internal::CaptureStdout();
  new_material({name, GetParam().language, GetParam().interface, (folder / "again").string(), Verbosity::normal});
  std::istringstream said(testing::internal::GetCapturedStdout());
  for (std::string line; std::getline(said, line);) {
    const bool has_path =
        line.starts_with("  cd ") || line.starts_with("  cmake -B build") || line.find(" run ") != line.npos;
    EXPECT_TRUE(line.size() <= 80 || has_path) << line;
  }
  for (const std::string& file : files()) {
    if (!file.ends_with(".f90")) continue;
    std::istringstream lines(read(file));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 132u) << line;
  }
}

/// A prefix of programs, with the package that CMake looks for in `holds`; empty: none.
std::string steps_with(const fs::path& prefix, const std::string& holds, bool on_path) {
  fs::create_directories(prefix / "bin");
  fs::copy_file(built("assay"), prefix / "bin/assay");
  if (!holds.empty()) {
    fs::create_directories(prefix / holds);
    std::ofstream(prefix / holds / "assay-config.cmake") << "";
  }
  const std::string here = prefix.string(), program = (prefix / "bin/assay").string();
  const std::string path = (on_path ? (prefix / "bin").string() + ":" : "") + "/usr/bin:/bin";
  const std::string command = "cd '" + here + "' && PATH='" + path + "' '" + program +
                              "' new-material clay --language c > said 2>&1 < /dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0);
  return bytes_of((prefix / "said").string());
}

TEST_F(NewMaterial, TheNextStepsSayWhereTheProgramIs) {
  for (const char* holds : {"lib/cmake/assay", "lib/x86_64-linux-gnu/cmake/assay", "share/cmake/assay", "cmake"}) {
    const fs::path prefix = folder / fs::path(holds).parent_path().parent_path().filename() / "with blank";
    const std::string here = prefix.string();
    const std::string found = steps_with(prefix, holds, true);
    EXPECT_NE(found.find("\n  cmake -B build\n"), found.npos) << holds << found;
    EXPECT_NE(found.find("\n  assay run vortex.yaml\n"), found.npos) << found;
    fs::remove_all(prefix);
    const std::string apart = steps_with(prefix, holds, false);
    EXPECT_NE(apart.find("\n  cmake -B build -D CMAKE_PREFIX_PATH='" + here + "'\n"), apart.npos) << apart;
    EXPECT_NE(apart.find("\n  '" + here + "/bin/assay' run vortex.yaml\n"), apart.npos) << apart;
  }
  const std::string alone = steps_with(folder / "alone", "", true);
  EXPECT_NE(alone.find("# with -D CMAKE_PREFIX_PATH=(where assay is installed)"), alone.npos) << alone;
}

INSTANTIATE_TEST_SUITE_P(Kinds, NewMaterialFlavours, testing::ValuesIn(flavours), name_of);

TEST_F(NewMaterial, RefusesNamesThatWouldNotServe) {
  for (const char* name :
       {"", "Clay", "2clay", "_clay", "clay-2", "clay.so", "cl ay", "a/b", "..", "t\xc3\xb6pfer", "a\nb"}) {
    const std::string line = refused(name, flavours[0]);
    EXPECT_TRUE(line.starts_with("NAME: '") && line.find("is no name for a material") != line.npos) << line;
  }
  EXPECT_NE(refused(std::string(61, 'a'), flavours[0]), "accepted");
  EXPECT_EQ(refused("neo_hookean", flavours[0]), "NAME: 'neo_hookean' is the name of a built-in material");
  EXPECT_EQ(refused("test", flavours[1]), "NAME: 'test' is a target that CMake has already");
  EXPECT_EQ(refused("vortex", flavours[3]), "NAME: 'vortex' is the name of the project's scene");
  EXPECT_TRUE(files().empty());
}

TEST_F(NewMaterial, RefusesOtherLanguagesAndInterfaces) {
  EXPECT_EQ(refused("clay", {"rust", "native", ""}), "--language: unknown language 'rust'; known: c, c++, fortran");
  EXPECT_EQ(refused("clay", {"C", "native", ""}),
            "--language: unknown language 'C' (nearest: c); known: c, c++, fortran");
  EXPECT_EQ(refused("clay", {"c", "umat", ""}), "--interface: umat goes with --language fortran, found c");
  EXPECT_EQ(refused("clay", {"c++", "umat", ""}), "--interface: umat goes with --language fortran, found c++");
  EXPECT_EQ(refused("clay", {"fortran", "vumat", ""}),
            "--interface: unknown interface 'vumat' (nearest: umat); known: native, umat");
  EXPECT_TRUE(files().empty());
  const Ending none = assay({"new-material", "clay"});
  EXPECT_EQ(none.status, 2);
  EXPECT_EQ(none.said, "assay new-material: --language is required\n");
}

TEST_F(NewMaterial, LeavesWhatIsThere) {
  write("clay/mine.txt", "mine");
  write("file", "");
  fs::create_directory(folder / "empty");
  fs::create_symlink("nowhere", folder / "link");
  const auto before = files();
  for (const char* there : {"clay", "file", "empty", "link", ".", "clay/"}) {
    const std::string line = refused("clay", flavours[0], there);
    EXPECT_TRUE(line.ends_with(": exists, and a project goes into a new folder; choose another with -o")) << line;
  }
  EXPECT_THROW(make("clay", flavours[0], "file/below"), SystemError);
  EXPECT_EQ(files(), before);
}

TEST_F(NewMaterial, NothingHalfWritten) {
  if (::geteuid() == 0) {  // whom no permission stops
    const Ending ending = assay({"new-material", "clay", "--language", "c", "-o", "/proc/nowhere/clay"});
    EXPECT_EQ(ending.status, 3) << ending.said;
    return;
  }
  fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THROW(make("clay", flavours[0], "new/clay"), SystemError);
  fs::permissions(folder, fs::perms::owner_all);
  EXPECT_TRUE(files().empty());
}

/// The commands of the project's own README.md, with an installed copy of this build.
class LongNewMaterial : public NewMaterialFlavours {
 protected:
  /// Both streams of a script in the test's folder, ended by "status N".
  std::string shell(const std::string& script) const {
    write("script.sh", "unset ASSAY_MATERIAL_PATH DESTDIR\nexport CMAKE_GENERATOR='" ASSAY_CMAKE_GENERATOR
                       "' ASSAY_CACHE_HOME=\"$PWD/cache\" HOME=\"$PWD\" LC_ALL=C\n"
                       "export CFLAGS='-Wall -Wextra -Wpedantic -Wshadow' \nexport CXXFLAGS=\"$CFLAGS\" "
                       "FFLAGS='-Wall -Wno-unused-dummy-argument'\n"
                       "PATH=\"$PWD/pre fix/bin:$PATH\"\nset -e\n" +
                           script);
    const int status = std::system(("cd '" + folder.string() + "' && sh ./script.sh >said 2>&1 </dev/null").c_str());
    return read("said") + "status " + std::to_string(WIFEXITED(status) ? WEXITSTATUS(status) : -1);
  }
};

/// What stands between ```sh and ```.
std::string commands_of(const std::string& readme) {
  std::smatch match;
  return std::regex_search(readme, match, std::regex("```sh\n([^`]*)```")) ? match[1].str() : "false";
}

TEST_P(LongNewMaterial, BuildsPassesCheckAndRunsTheVortex) {
  if (!ASSAY_CAN_INSTALL) GTEST_SKIP() << "this build has no install rules";
  if (GetParam().language == std::string("fortran") && !ASSAY_HAS_FORTRAN) GTEST_SKIP() << "no Fortran compiler";
  ASSERT_EQ(make("clay", GetParam()), 0);
  const std::string readme = read("clay/README.md");
  const std::string said =
      shell("cmake --install '" + built() + "' --prefix 'pre fix' >installed\ncd clay\n" + commands_of(readme));
  EXPECT_TRUE(said.ends_with("AS EXPECTED; results in results/vortex\nstatus 0")) << said;
  EXPECT_NE(said.find("100% tests passed"), std::string::npos) << said;
  EXPECT_EQ(said.find("arning"), std::string::npos) << said;
  EXPECT_TRUE(fs::exists(folder / "clay/results/vortex/report.html"));
  EXPECT_TRUE(fs::exists(folder / "clay/build/clay.check.xml"));
}

/// What `new-material` prints, as it stands, where it was called.
TEST_P(LongNewMaterial, ThePrintedStepsRunWithABuildFolderOnThePathAndWithAnInstalledCopyElsewhere) {
  if (!ASSAY_CAN_INSTALL) GTEST_SKIP() << "this build has no install rules";
  if (GetParam().language == std::string("fortran") && !ASSAY_HAS_FORTRAN) GTEST_SKIP() << "no Fortran compiler";
  const std::string words = std::string(" new-material clay --language ") + GetParam().language + " --interface " +
                            GetParam().interface + " | sed '1,/^next:/d' > steps; sh -e ./steps; rm -r clay\n";
  const std::string said = shell("cmake --install '" + built() + "' --prefix 'elsewhere' >installed\n(PATH='" +
                                 built() + "':\"$PATH\"; assay" + words + ")\n'elsewhere/bin/assay'" + words);
  EXPECT_TRUE(said.ends_with("status 0")) << said;
  std::size_t runs = 0;
  for (std::size_t at = 0; (at = said.find("AS EXPECTED; results in results/vortex", at)) != said.npos; ++at) ++runs;
  EXPECT_EQ(runs, 2u) << said;
}

INSTANTIATE_TEST_SUITE_P(Kinds, LongNewMaterial, testing::ValuesIn(flavours), name_of);

}  // namespace
}  // namespace assay::drivers::test_new_material
