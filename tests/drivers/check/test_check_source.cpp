// SPDX-License-Identifier: BSD-3-Clause
// A Fortran source as a material, as its author calls the program.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <nlohmann/json.hpp>

#include "tests/drivers/material/source_fixture.hpp"
#include "tests/drivers/process.hpp"
#include "tests/support/wait.hpp"

namespace assay::drivers::test_check_source {
namespace {

namespace fs = std::filesystem;

class CheckSource : public SourceTest {
 protected:
  /// In the scratch folder, as a user stands in his own.
  Ending run(const std::vector<std::string>& words, const std::function<void()>& before = {}) const {
    return assay(words, [&] {
      if (::chdir((scratch / "").c_str()) != 0) ::_exit(126);
      ::setenv("ASSAY_DATA_HOME", (scratch / "data").c_str(), 1);
      if (before) before();
    });
  }
  std::string scene(const std::string& material) const {
    return scratch.write("scene.yaml",
                         "motion: {type: vortex, inner: 0.75, outer: 1.25, amplitude: {type: sine, peak: 0.02}}\n"
                         "material: " +
                             material +
                             "\nbody: {domain: ring, per_cell: [2, 2]}\ngrid: {spacing: 0.1}\n"
                             "method: {basis: linear, transfer: flip, update: usl}\ntime: {end: 0.01}\n");
  }
  static bool says(const Ending& ending, const std::string& words) {
    return ending.said.find(words) != std::string::npos;
  }
};
using LongCheckSource = CheckSource;

TEST_F(CheckSource, ANewUserHasTheVerdictAtOnce) {
  scratch.write("model.f", hooke_umat);
  const Stopwatch watch;
  const Ending ending = run({"check", "model.f", "--props", "210e3,.3"});
  const double wall_s = watch.seconds();
  EXPECT_EQ(ending.status, 0) << ending.said;
  EXPECT_TRUE(says(ending, "model.f: pass")) << ending.said;
  EXPECT_TRUE(says(ending, "a UMAT (umat_) in fixed form, read at 132 columns")) << ending.said;
  EXPECT_TRUE(says(ending, "description, which you can edit: results/check/model.yaml")) << ending.said;
  EXPECT_LT(wall_s, sanitized() ? 600 : 60) << "seconds";
  const Ending again = run({"check", "results/check/model.yaml", "--quick"});
  EXPECT_EQ(again.status, 0) << again.said;
}

TEST_F(LongCheckSource, WhatIsMissingIsOneLine) {
  scratch.write("model.f", hooke_umat);
  const auto line = [&](const std::vector<std::string>& words, int status = 2) {
    const Ending ending = run(words);
    EXPECT_EQ(ending.status, status) << ending.said;
    EXPECT_EQ(std::count(ending.said.begin(), ending.said.end(), '\n'), 1) << ending.said;
    EXPECT_FALSE(fs::exists(scratch / "results"));
    return ending.said;
  };
  EXPECT_NE(line({"check", "model.f"}).find("model.f: --props: required and not given"), std::string::npos);
  EXPECT_NE(line({"check", "no.f", "--props", "1"}).find("no such file"), std::string::npos);
  EXPECT_EQ(line({"check", "model.f", "--props", "1,x"}),
            "--props: must be NUMBER or NAME=NUMBER, separated by commas, found 'x'\n");
  EXPECT_EQ(line({"check", "model.f", "--props", "1e3;.3"}), "--props: commas separate PROPS: write 1e3,.3\n");
  EXPECT_EQ(line({"check", "model.f", "--props", "E=1,E=2"}), "--props: 'E' is there twice\n");
  for (const char* list : {"1000,,.3", "1000, ,.3", ",1000", "1000,.3,"})
    EXPECT_NE(line({"check", "model.f", "--props", list}).find("has no value at place "), std::string::npos) << list;
  EXPECT_EQ(line({"check", "model.f", "--props", "p2=.3,p1=1000"}),
            "--props: 'p2' stands at place 1, and PROPS are taken in the order in which they are given\n");
  EXPECT_NE(line({"check", "model.f", "--props", "ENU=.3,EMOD=1000"}).find("it is PROPS(2)"), std::string::npos);
  EXPECT_EQ(line({"check", "model.f", "--props", "1", "--statev", "-1"}),
            "--statev: must be a whole number from 0 to 10000, found '-1'\n");
  EXPECT_NE(line({"check", "model.f", "--deck", "no.inp"}).find("no.inp: no such file"), std::string::npos);
  EXPECT_EQ(
      line({"check", "neo_hookean", "--props", "1"}),
      "--props: goes with a Fortran source (model.f) or an Abaqus deck (job.inp), and 'neo_hookean' is neither\n");
  EXPECT_EQ(line({"check", "--all", "--statev", "1"}),
            "--statev: goes with a Fortran source (model.f) or an Abaqus deck (job.inp)\n");
  EXPECT_EQ(line({"register", "--remove", "x", "--symbol", "y"}),
            "--symbol: goes with a Fortran source (model.f) or an Abaqus deck (job.inp)\n");
  scratch.write("bad.f", fixed_umat("      X=PROPS(1\n"));
  EXPECT_NE(line({"check", "bad.f", "--props", "1"}).find("bad.f:13:16: does not compile: "), std::string::npos);
}

TEST_F(LongCheckSource, TheFolderWhereTheUserStandsMayBeGone) {
  const std::string model = scratch.write("model.f", hooke_umat);
  for (const char* props : {"210e3,.3", "E=210e3,nu=.3"}) {
    fs::create_directories(scratch / "gone");
    const Ending ending = assay({"check", model, "--props", props, "--quick", "-o", scratch / "out"}, [&] {
      if (::chdir((scratch / "gone").c_str()) != 0 || ::rmdir((scratch / "gone").c_str()) != 0) ::_exit(126);
    });
    EXPECT_EQ(ending.status, 0) << ending.said;
    EXPECT_TRUE(says(ending, "description, which you can edit: ")) << ending.said;
  }
  fs::create_directories(scratch / "gone");
  const Ending relative = assay({"check", model, "--props", "1,.3", "--quick"}, [&] {
    if (::chdir((scratch / "gone").c_str()) != 0 || ::rmdir((scratch / "gone").c_str()) != 0) ::_exit(126);
  });
  EXPECT_EQ(relative.status, 3) << relative.said;
  EXPECT_TRUE(says(relative, "results/check: cannot be made: ")) << relative.said;
}

// The utilities of the host have these names, too.
TEST_F(LongCheckSource, ItsOwnRoutinesAreCalled) {
  for (const char* name : {"SINV", "SPRINC", "GETNUMCPUS"}) {
    std::string text = hooke_umat;
    const std::string line = "      EMOD=PROPS(1)";
    text.insert(text.find(line) + line.size(), std::string("\n      CALL ") + name + "(EMOD)");
    text += std::string("      SUBROUTINE ") + name +
            "(X)\n      INCLUDE 'ABA_PARAM.INC'\n      COMMON /CALLS/ N\n      N=N+1\n      X=X*1\n      END\n";
    scratch.write("model.f", text);
    const Ending ending = run({"check", "model.f", "--props", "210e3,.3", "--quick"});
    EXPECT_EQ(ending.status, 0) << name << ": " << ending.said;
  }
}

TEST_F(LongCheckSource, PropsMayStandBetweenBlanks) {
  scratch.write("model.f", hooke_umat);
  const Ending ending = run({"check", "--props", "210e3", ".3", "model.f", "--quick"});
  EXPECT_EQ(ending.status, 0) << ending.said;
  EXPECT_TRUE(says(ending, "2 PROPS from --props")) << ending.said;
  EXPECT_EQ(run({"check", "model.f", "--quick", "--props", "1.d3,", ".3"}).status, 0);
  EXPECT_TRUE(says(run({"check", "model.f", "3", "--props", "1e3"}), "unknown argument '3'"));
}

TEST_F(LongCheckSource, IsLinkedWithWhatItNeeds) {
  scratch.write("doubled.f90", "real(8) function doubled(e)\n real(8) :: e\n doubled = 2*e\nend function\n");
  ASSERT_EQ(std::system(("cd '" + (scratch / "") + "' && gfortran -fPIC -c doubled.f90 -o doubled.o").c_str()), 0);
  std::string text = hooke_umat;
  const std::string line = "      EMOD=PROPS(1)";
  text.insert(text.find(line) + line.size(), "\n      EMOD=DOUBLED(EMOD)");
  scratch.write("model.f", text);
  const std::vector<std::string> words{"check", "model.f", "--props", "1e3,.3", "--quick"};
  const auto linked_with = [&](const std::string& what) {
    std::vector<std::string> all = words;
    all.insert(all.end(), {"--link", what});
    return run(all);
  };
  const Ending absent = run(words);
  EXPECT_EQ(absent.status, 1) << absent.said;
  EXPECT_TRUE(says(absent, "diagnosis: routine missing")) << absent.said;
  EXPECT_TRUE(says(linked_with("./no.o"), "--link: '" + (scratch / "no.o") + "': no such file"));
  EXPECT_TRUE(says(linked_with("model.f"), "--link: '" + (scratch / "model.f") + "' is no library and no object"));
  EXPECT_TRUE(says(linked_with("-rm"), "--link: must be the name of a library (lapack) or a file"));
  EXPECT_TRUE(says(linked_with("nothing_of_that_name"), "link: the linker finds no library 'nothing_of_that_name'"));
  const Ending linked = linked_with("doubled.o,m");
  EXPECT_EQ(linked.status, 0) << linked.said;
  const Ending again = run({"check", "results/check/model.yaml", "--quick"});
  EXPECT_EQ(again.status, 0) << again.said;
  EXPECT_NE(bytes_of(scratch / "results/check/model.yaml").find("link: ["), std::string::npos);
  EXPECT_EQ(run({"register", "results/check/model.yaml"}).status, 0);
  EXPECT_EQ(run({"check", "model", "--quick"}).status, 0) << "what is registered is compiled again";
  scratch.write("lib.yaml", "library: model.so\ninterface: umat\nlink: [m]\n");
  EXPECT_TRUE(says(run({"check", "lib.yaml"}), "lib.yaml:3:7: link: goes with a source"));
}

TEST_F(CheckSource, WithoutACompilerTheSystemIsToBlame) {
  scratch.write("model.f", hooke_umat);
  const Ending ending = run({"check", "model.f", "--props", "1,.3"}, [] {
    ::setenv("PATH", "", 1);
    ::unsetenv("FC");
  });
  EXPECT_EQ(ending.status, 3);
  EXPECT_TRUE(says(ending, "there is no gfortran in $PATH")) << ending.said;
  EXPECT_EQ(std::count(ending.said.begin(), ending.said.end(), '\n'), 1) << ending.said;
}

// At 72 columns the tail is cut, and the model is right; Abaqus reads it.
TEST_F(CheckSource, ATailBeyondColumn72IsReadAndTold) {
  std::string text = hooke_umat;
  const std::string line = "          STRESS(I)=STRESS(I)+DDSDDE(I,J)*DSTRAN(J)";
  text.insert(text.find(line) + line.size(), std::string(72 - line.size(), ' ') + "+0.1d0*props(1)*dstran(j)**2");
  scratch.write("tail.f", text);
  const Ending ending = run({"check", "tail.f", "--props", "1e3,.3", "--quick"});
  EXPECT_TRUE(says(ending, "tail.f:27: code beyond column 72 (line 27), here '+0.1d0*props(1)*dstran(j)**2'"))
      << ending.said;
  EXPECT_EQ(ending.status, 1) << ending.said;
}

TEST_F(CheckSource, CardNumbersAreReadAsAbaqusDoesAndTold) {
  std::string text = hooke_umat;
  const std::string line = "      EMOD=PROPS(1)";
  text.insert(text.find(line) + line.size(), "*1.d0" + std::string(72 - line.size() - 5, ' ') + "00000010");
  scratch.write("card.f", text);
  const Ending ending = run({"check", "card.f", "--props", "1e3,.3", "--quick"});
  EXPECT_TRUE(says(ending, "this line ends in '1.d000000010'")) << ending.said;
  EXPECT_TRUE(says(ending, "cut -c1-72 card.f > card_72.f")) << ending.said;
}

TEST_F(LongCheckSource, ADeckIsEnough) {
  scratch.write("job.f", hooke_umat);
  scratch.write("job.inp", "*Material, name=Steel\n*Density\n7850.\n*User Material, constants=2\n1.e3, .3\n");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"check", "job.inp", "--quick"}, {"check", "job.f", "--deck", "job.inp", "--quick"}}) {
    const Ending ending = run(words);
    EXPECT_EQ(ending.status, 0) << ending.said;
    EXPECT_TRUE(says(ending, "2 PROPS from *User Material")) << ending.said;
  }
  const Ending run_it = run({"run", scene("{adapter: job.inp}"), "-o", "out"});
  EXPECT_EQ(run_it.status, 0) << run_it.said;
}

TEST_F(CheckSource, AnIncludeOfADeckThatIsNotThereIsAWarning) {
  scratch.write("job.f", hooke_umat);
  scratch.write("job.inp", "*Include, input=density.inc\n*Material, name=A\n*User Material, constants=2\n1.e3, .3\n");
  const Ending ending = run({"check", "job.f", "--deck", "job.inp", "--quick", "--quiet"});
  EXPECT_EQ(ending.status, 0) << ending.said;
  EXPECT_TRUE(says(ending, "job.inp:1:1: *Include: 'density.inc' cannot be read, and is left out")) << ending.said;
}

TEST_F(CheckSource, AnOverrunOfSdviniIsNamedAsOne) {
  scratch.write("model.f", std::string(hooke_umat) +
                               "      SUBROUTINE SDVINI(STATEV,COORDS,NSTATV,NCRDS,NOEL,NPT,LAYER,KSPT)\n"
                               "      INCLUDE 'ABA_PARAM.INC'\n"
                               "      DIMENSION STATEV(NSTATV),COORDS(NCRDS)\n"
                               "      STATEV(NSTATV+2)=3\n"
                               "      END\n");
  const Ending ending = run({"check", "model.f", "--props", "1e3,.3", "--statev", "2", "--quick"});
  EXPECT_EQ(ending.status, 1) << ending.said;
  EXPECT_TRUE(says(ending, "diagnosis: overrun")) << ending.said;
}

TEST_F(CheckSource, ADecksNamesThatAreNoKeysStandInTheText) {
  scratch.write("job.f", hooke_umat);
  scratch.write("job.inp",
                "*Material, name=A\n*Depvar\n2\n1, EQ PLASTIC\n2, P\n*User Material, constants=2\n1.e3, .3\n");
  const Ending ending = run({"check", "job.inp", "--quick"});
  EXPECT_EQ(ending.status, 0) << ending.said;
  const std::string written = bytes_of(scratch / "results/check/job.yaml");
  EXPECT_NE(written.find("s1: {kind: scalar, doc: \"EQ PLASTIC\"}"), std::string::npos) << written;
  EXPECT_NE(written.find("P: scalar"), std::string::npos) << written;
}

TEST_F(LongCheckSource, IsTakenBySceneAndSetting) {
  scratch.write("my dir/modél.f", "");
  fs::create_directories(scratch / "my dir");
  scratch.write("my dir/modél.f", hooke_umat);
  const std::string setting = "material={adapter: 'my dir/modél.f', parameters: {p1: 1000, p2: 0.3}, density: 1000}";
  const std::string file = scene("{adapter: neo_hookean, parameters: {E: 1000, nu: 0.3}, density: 1000}");
  for (const char* verb : {"run", "tabulate", "explain"}) {
    std::vector<std::string> words{verb, file, "--set", setting};
    if (std::string(verb) != "explain") words.insert(words.end(), {"-o", "out"});
    const Ending ending = run(words);
    EXPECT_EQ(ending.status, 0) << ending.said;
  }
  const Ending again = run({"run", "out/resolved.yaml", "-o", "again"});
  EXPECT_EQ(again.status, 0) << again.said;
  scratch.write("points.csv", "X,Y,t\n1,0,0.005\n");
  const std::string own = scene("{adapter: 'my dir/modél.f', parameters: {p1: 1000, p2: 0.3}, density: 1000}");
  const Ending evaluated = run({"eval", own, "--points", "points.csv"});
  EXPECT_EQ(evaluated.status, 0) << evaluated.said;
  const Ending lacks = run({"run", file, "-o", "out", "--set", "material={adapter: 'my dir/modél.f', density: 1000}"});
  EXPECT_EQ(lacks.status, 2);
  EXPECT_TRUE(says(lacks, "p1")) << lacks.said;
}

TEST_F(LongCheckSource, IsRegisteredAndThenUsed) {
  scratch.write("model.f", hooke_umat);
  const Ending registered = run({"register", "model.f", "--as", "mine", "--props", "1e3,.3"});
  EXPECT_EQ(registered.status, 0) << registered.said;
  EXPECT_TRUE(says(registered, "registered mine: model in " + scratch / "model.f")) << registered.said;
  EXPECT_TRUE(says(run({"materials", "--verbose"}), "\nmine (model model)"));
  EXPECT_EQ(run({"check", "mine", "--quick"}).status, 0);
  EXPECT_EQ(run({"run", scene("{adapter: mine, density: 1000}"), "-o", "out"}).status, 0);
  const Ending shown = run({"materials", "mine", "--json"});
  const auto json = nlohmann::json::parse(shown.said);
  EXPECT_EQ(json["source"], scratch / "model.f");
  fs::remove(scratch / "model.f");
  const Ending listed = run({"materials"});
  EXPECT_EQ(listed.status, 0);
  EXPECT_TRUE(says(listed, "mine: broken")) << listed.said;
}

TEST_F(LongCheckSource, TwoEntriesAreAChoice) {
  scratch.write("two.f", fixed_umat(hooke_statements, "MYLAW") + fixed_umat(hooke_statements, "UMAT_B"));
  const Ending refused = run({"check", "two.f", "--props", "1e3,.3"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(says(refused, "choose one by --symbol NAME; known: mylaw_, umat_b_")) << refused.said;
  EXPECT_EQ(run({"check", "two.f", "--props", "1e3,.3", "--symbol", "MYLAW", "--quick"}).status, 0);
  EXPECT_EQ(run({"check", "two.f:mylaw", "--props", "1e3,.3", "--quick"}).status, 0);
}

TEST_F(CheckSource, FirstRunsAtOnceAreAlike) {
  scratch.write("model.f", hooke_umat);
  std::vector<pid_t> children;
  for (int k = 0; k < 3; ++k) {
    children.push_back(start_assay({"materials", "model.f"}, scratch / ("said" + std::to_string(k)), [&] {
      if (::chdir((scratch / "").c_str()) != 0) ::_exit(126);
    }));
  }
  for (const pid_t child : children) {
    int status = -1;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(kept(".so").size(), 1u);
  EXPECT_EQ(kept(".yaml").size(), 1u);
  EXPECT_EQ(kept("").size(), 2u);
}

// The worker of a library stands elsewhere.
TEST_F(CheckSource, TheCacheMayBeRelativeToTheUser) {
  scratch.write("model.f", hooke_umat);
  const Ending ending =
      run({"check", "model.f", "--props", "1e3,.3", "--quick"}, [] { ::setenv("ASSAY_CACHE_HOME", "near/cache", 1); });
  EXPECT_EQ(ending.status, 0) << ending.said;
  EXPECT_TRUE(fs::exists(scratch / "near/cache/sources"));
  EXPECT_TRUE(kept("").empty());
}

TEST_F(LongCheckSource, AnEditedDescriptionStays) {
  scratch.write("model.f", hooke_umat);
  const std::string file = scratch / "results/check/model.yaml";
  EXPECT_EQ(run({"check", "model.f", "--props", "1e3,.3", "--quick"}).status, 0);
  EXPECT_EQ(run({"check", "model.f", "--props", "2e3,.3", "--quick"}).status, 0);
  EXPECT_NE(bytes_of(file).find("p1: 2000"), std::string::npos) << "nobody has edited it";
  const std::string edited = bytes_of(file) + "# mine\n";
  std::ofstream(file) << edited;
  const Ending third = run({"check", "model.f", "--props", "3e3,.3", "--quick"});
  EXPECT_EQ(bytes_of(file), edited);
  EXPECT_TRUE(says(third, "model.new.yaml")) << third.said;
  EXPECT_NE(bytes_of(scratch / "results/check/model.new.yaml").find("p1: 3000"), std::string::npos);
}

/// Hooke's law with E from a file.
std::string umat_with_file(const std::string& open) {
  std::string statements = hooke_statements;
  const std::string line = "      EMOD=PROPS(1)\n";
  statements.replace(statements.find(line), line.size(),
                     "      OPEN(15," + open + ")\n      READ(15,*) EMOD\n      CLOSE(15)\n");
  return fixed_umat(statements);
}

TEST_F(LongCheckSource, AFileThatIsNotFoundIsNamedAndGiven) {
  scratch.write("model.f", umat_with_file("FILE='young.dat',STATUS='OLD'"));
  const Ending absent = run({"check", "model.f", "--props", "0,.3", "--quick"});
  EXPECT_EQ(absent.status, 1);
  EXPECT_TRUE(says(absent, "files:")) << absent.said;
  EXPECT_TRUE(says(absent, "[young.dat]")) << absent.said;
  EXPECT_FALSE(says(absent, "???")) << "the list of calls says nothing";
  scratch.write("young.dat", "1000.\n");
  const std::string description = scratch.write("given.yaml",
                                                "source: model.f\ninterface: umat\nproperties: [0, 0.3]\n"
                                                "files: [young.dat]\ndensity: 1000\n");
  const Ending given = run({"check", "given.yaml", "--quick"});
  EXPECT_EQ(given.status, 0) << given.said;
  const Ending ran = run({"run", scene("{adapter: given.yaml}"), "-o", "out"});
  EXPECT_EQ(ran.status, 0) << ran.said;
  EXPECT_EQ(bytes_of(scratch / "young.dat"), "1000.\n");
  const Ending failed = run({"run", scene("{adapter: results/check/model.yaml, density: 1000}"), "-o", "out"});
  EXPECT_EQ(failed.status, 1);
  EXPECT_TRUE(says(failed, "[young.dat]")) << failed.said;
  const Ending registered = run({"register", description, "--as", "given"});
  EXPECT_EQ(registered.status, 0) << registered.said;
  EXPECT_EQ(run({"check", "given", "--quick"}).status, 0);
}

TEST_F(CheckSource, AFileThatIsMadeEmptyIsNamedToo) {
  scratch.write("model.f", umat_with_file("FILE='young.dat'"));
  const Ending ending = run({"check", "model.f", "--props", "0,.3", "--quick"});
  EXPECT_EQ(ending.status, 1);
  EXPECT_TRUE(says(ending, "[young.dat]")) << ending.said;
}

// GETOUTDIR leads to the source, wherever its library is kept.
TEST_F(LongCheckSource, TheOutputFolderIsThatOfTheSource) {
  std::string statements = hooke_statements;
  const std::string line = "      EMOD=PROPS(1)\n";
  statements.replace(statements.find(line), line.size(),
                     "      CALL GETOUTDIR(DIR,LDIR)\n      NAME=DIR(1:LDIR)//'/young.dat'\n"
                     "      OPEN(15,FILE=NAME,STATUS='OLD')\n      READ(15,*) EMOD\n      CLOSE(15)\n");
  // A padded variable: libgfortran hands an unpadded name to strndup, at which strict_string_checks stops.
  scratch.write("model.f", fixed_umat("      CHARACTER*256 DIR,NAME\n" + statements));
  scratch.write("young.dat", "1000.\n");
  const Ending ending = run({"check", "model.f", "--props", "0,.3", "--quick"});
  EXPECT_EQ(ending.status, 0) << ending.said;
}

}  // namespace
}  // namespace assay::drivers::test_check_source
