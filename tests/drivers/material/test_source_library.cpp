// SPDX-License-Identifier: BSD-3-Clause

#include <sys/wait.h>
#include <unistd.h>

#include "adapters/elf_symbols.hpp"
#include "drivers/material/fortran_compiler.hpp"
#include "drivers/system/input_error.hpp"
#include "tests/drivers/material/source_fixture.hpp"
#include "tests/drivers/refusal.hpp"

namespace assay::drivers::test_source_library {
namespace {

namespace fs = std::filesystem;

class SourceLibraryTest : public SourceTest {
 protected:
  static FortranSource read(const std::string& file) { return read_fortran_source(file, {"f", 1, 2}, "k"); }
  std::string built(const std::string& file) const { return library_of_source(read(file)).file; }
  std::string refused(const std::string& file) const {
    std::string line = refusal_of([&] { built(file); });
    const std::string folder = scratch / "";
    while (line.find(folder) != line.npos) line.replace(line.find(folder), folder.size(), "");
    return line.substr(0, line.rfind(" (GNU Fortran"));
  }
};
using LongSourceLibraryTest = SourceLibraryTest;

TEST_F(SourceLibraryTest, IsCompiledOnce) {
  const std::string source = scratch.write("hooke.f", hooke_umat);
  const std::string library = built(source);
  const auto exported = adapters::exported_symbols(library);
  EXPECT_TRUE(std::binary_search(exported.begin(), exported.end(), "umat_"));
  EXPECT_TRUE(fs::path(library).filename().string().starts_with("hooke-"));
  const auto first = fs::last_write_time(library);
  EXPECT_EQ(built(source), library);
  EXPECT_EQ(fs::last_write_time(library), first) << "compiled again";
  EXPECT_EQ(kept("").size(), 1u) << "what was made on the way is left";
}

TEST_F(LongSourceLibraryTest, EachContentHasItsOwn) {
  const std::string source = scratch.write("hooke.f", fixed_umat("      INCLUDE 'own.inc'\n" + hooke_statements));
  scratch.write("own.inc", "      EMOD=1\n");
  const std::string first = built(source);
  scratch.write("own.inc", "      EMOD=2\n");
  const std::string second = built(source);
  EXPECT_NE(first, second) << "what it includes counts";
  scratch.write("hooke.f", fixed_umat("      INCLUDE 'own.inc'\n" + hooke_statements + "      EMOD=3\n"));
  EXPECT_NE(built(source), second);
  scratch.write("own.inc", "      EMOD=1\n");
  scratch.write("hooke.f", fixed_umat("      INCLUDE 'own.inc'\n" + hooke_statements));
  EXPECT_EQ(built(source), first);
  EXPECT_EQ(kept(".so").size(), 3u);
}

TEST_F(SourceLibraryTest, ADamagedOneIsMadeAnew) {
  const std::string source = scratch.write("hooke.f", hooke_umat);
  const std::string library = built(source);
  fs::resize_file(library, 100);
  EXPECT_EQ(built(source), library);
  EXPECT_FALSE(adapters::exported_symbols(library).empty());
}

TEST_F(SourceLibraryTest, NoPathOfTheSourceIsInIt) {
  const std::string text = fixed_umat("      WRITE(6,*) STRESS(1)\n" + hooke_statements);
  fs::create_directories(scratch / "elsewhere");
  EXPECT_EQ(built(scratch.write("hooke.f", text)), built(scratch.write("elsewhere/hooke.f", text)));
  EXPECT_EQ(bytes_of(built(scratch / "hooke.f")).find(scratch / ""), std::string::npos);
}

TEST_F(LongSourceLibraryTest, BothFormsWithAnyIncludeOfAbaqus) {
  built(scratch.write("free.f90", free_hooke_umat));
  built(scratch.write("free.for", free_hooke_umat));
  built(scratch.write("directive.f", "!DIR$ FREEFORM\n" + free_hooke_umat));
  built(scratch.write("fixed.f90", hooke_umat));
  built(scratch.write("small.F",
                      fixed_umat("#define ONE 1\n      EMOD=ONE\n" + hooke_statements, "UMAT", "Aba_Param.Inc")));
  built(scratch.write("header.f", "#include <SMAAspUserSubroutines.hdr>\n" + hooke_umat));
  std::string windows;
  for (const char c : hooke_umat) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  built(scratch.write("windows.for", windows));
  scratch.write("consts.inc", "      EMOD=1\n");
  built(scratch.write("case.f", fixed_umat("      INCLUDE 'CONSTS.INC'\n" + hooke_statements)));
  EXPECT_EQ(kept(".so").size(), 7u) << "free.f90 and free.for are one";
}

// As their authors' compiler takes them.
TEST_F(LongSourceLibraryTest, WhatOtherCompilersTakeIsAdapted) {
  scratch.write("free.inc", "a = 1\n");
  built(scratch.write("mixed.for", hooke_umat +
                                       "!DEC$ FREEFORM\nsubroutine other(a)\n  implicit none\n  real a\n"
                                       "include 'free.inc'\na = a &\n + 1\nend subroutine\ncDEC$ NOFREEFORM\n" +
                                       fixed_umat(hooke_statements, "LAST")));
  std::string both = hooke_umat;
  both.replace(both.find("SSE,SPD,SCD,\n"), 13, "SSE,SPD,SCD,                       &\n");
  built(scratch.write("both.for", both));
  scratch.write("own.inc", "      #include 'ABA_PARAM.INC'\n");
  built(scratch.write("directive.f", "#DEFINE ONE 1\n" + fixed_umat("      EMOD=ONE\n" + hooke_statements)));
  std::string indented = hooke_umat;
  indented.replace(indented.find("INCLUDE"), 7, "#include");
  const std::string library = built(scratch.write("indented.f", indented));
  EXPECT_EQ(kept(".so").size(), 4u);
  EXPECT_EQ(kept("").size(), 4u);
  EXPECT_EQ(bytes_of(library).find(".assay-"), std::string::npos) << "no path of the way to it";
  scratch.write("mixed.for", hooke_umat + "!DEC$ FREEFORM\nsubroutine other(a)\n a = (1\nend\n");
  const int line = static_cast<int>(lines_of_source(hooke_umat).size()) + 3;
  EXPECT_EQ(refused(scratch / "mixed.for").substr(0, 13), "mixed.for:" + std::to_string(line) + ":")
      << refused(scratch / "mixed.for");
}

TEST_F(SourceLibraryTest, CharactersOfWordProcessorsAreNamed) {
  const std::pair<const char*, const char*> slips[] = {
      {"      X=1.D0\u00A0\n", "the line holds U+00A0, no-break space"},
      {"      X=2.D0\u20131.D0\n", "U+2013 stands where '-' belongs"},
      {"      WRITE(*,*) \u2018A\u2019\n", "U+2018 stands where \"'\" belongs"}};
  for (const auto& [line, words] : slips) {
    const std::string said = refused(scratch.write("word.f", fixed_umat(line + std::string(hooke_statements))));
    EXPECT_NE(said.find(words), std::string::npos) << said;
  }
}

TEST_F(SourceLibraryTest, OldAndLooseSourcesCompile) {
  built(scratch.write("loose.f",
                      fixed_umat("      STRUCTURE /S/\n      REAL*8 X\n      END STRUCTURE\n      RECORD /S/ R\n"
                                 "      R.X=1\n      CALL LOOSE(STRESS)\n      CALL LOOSE(1.D0)\n" +
                                 hooke_statements)));
}

TEST_F(LongSourceLibraryTest, ThePreprocessorHasTheMacrosOfAbaqus) {
  for (const char* macro : {"ABQ_LNX86_64", "ABQ_FORTRAN"}) {
    const std::string statements = "#ifndef " + std::string(macro) + "\n      X=(1\n#endif\n" + hooke_statements;
    built(scratch.write("macro.f", fixed_umat(statements)));
    EXPECT_NE(refused(scratch.write("other.f", fixed_umat("#ifdef " + statements.substr(8)))).find("other.f:14"),
              std::string::npos);
  }
}

TEST_F(SourceLibraryTest, FixedFormIsReadAt132Columns) {
  std::string line = "      X=1";
  line.resize(100, ' ');
  const std::string source = scratch.write("long.f", fixed_umat(line + "+)\n" + hooke_statements));
  EXPECT_NE(refused(source).find("long.f:13:"), std::string::npos) << refused(source);
  line = "      X=1";
  line.resize(132, ' ');
  const std::string cut =
      refused(scratch.write("cut.f", fixed_umat("      Y=(1\n" + line + "+2\n" + hooke_statements)));
  EXPECT_NE(cut.find("what stands beyond column 132, as in line 14, is cut"), std::string::npos) << cut;
}

TEST_F(SourceLibraryTest, TheCompilersFirstErrorIsALine) {
  const std::string source = scratch.write("bad.f", fixed_umat("      X=1\n      EMOD=PROPS(1\n      ENU=PROPS(2\n"));
  EXPECT_EQ(refused(source), "bad.f:14:19: does not compile: Invalid form of array reference; 1 more")
      << refused(source);
  EXPECT_TRUE(kept("").empty()) << "what does not compile leaves nothing";
  scratch.write("part.inc", "      EMOD=(\n");
  EXPECT_EQ(refused(scratch.write("bad2.f", fixed_umat("      INCLUDE 'part.inc'\n"))).substr(0, 11), "part.inc:1:");
  EXPECT_EQ(refused(scratch.write("bad3.f", fixed_umat("      INCLUDE 'absent.inc'\n"))),
            "bad3.f:13: does not compile: Cannot open included file 'absent.inc'");
  const std::string cut = refused(scratch.write("cut.f", hooke_umat.substr(0, hooke_umat.find("   10   CONTINUE"))));
  EXPECT_TRUE(cut.starts_with("cut.f: does not compile: Unexpected end of file")) << cut;
  for (const std::string none : {"      IMPLICIT NONE\n      INCLUDE 'ABA_PARAM.INC'\n",
                                 "      IMPLICIT NONE\n      include 'aba_param.inc'\n"}) {
    std::string text = fixed_umat("", "UMAT", "");
    text.insert(text.find("      CHARACTER"), none);
    const std::string said = refused(scratch.write("none.f", text));
    EXPECT_TRUE(said.starts_with("none.f:8:1: does not compile: ")) << said;
    EXPECT_NE(said.find("holds IMPLICIT REAL*8(A-H,O-Z), beside which there is no IMPLICIT NONE"), std::string::npos);
  }
}

TEST_F(SourceLibraryTest, CardNumbersAreNamedWhereTheyBreakTheSource) {
  std::string text = hooke_umat;
  std::vector<std::string> lines = lines_of_source(text);
  text.clear();
  for (std::size_t k = 0; k < lines.size(); ++k) {
    lines[k].resize(72, ' ');
    text += lines[k] + std::to_string(10000010 + 10 * k) + "\n";
  }
  const std::string line = refused(scratch.write("cards.f", text));
  EXPECT_NE(line.find("cards.f:"), std::string::npos);
  EXPECT_NE(line.find("does not compile"), std::string::npos) << line;
  EXPECT_NE(line.find("cut -c1-72 cards.f > cards_72.f"), std::string::npos) << line;
}

TEST_F(SourceLibraryTest, TwoProcessesMayCompileAtOnce) {
  const std::string source = scratch.write("hooke.f", hooke_umat);
  std::vector<pid_t> children;
  for (int k = 0; k < 4; ++k) {
    children.push_back(::fork());
    if (children.back() != 0) continue;
    int status = 1;
    try {
      status = adapters::exported_symbols(built(source)).empty() ? 1 : 0;
    } catch (const std::exception&) {
    }
    ::_exit(status);
  }
  for (const pid_t child : children) {
    int status = -1;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(kept("").size(), 1u) << "one library, and nothing of the way to it";
}

TEST_F(SourceLibraryTest, WhatAKilledProcessLeftIsSwept) {
  const std::string source = scratch.write("hooke.f", hooke_umat);
  const pid_t child = ::fork();
  if (child == 0) {
    fs::create_directories(fs::path(source_folder()) / (".assay-" + std::to_string(::getpid()) + "-0@" + [] {
                             char name[256] = {};
                             ::gethostname(name, sizeof name - 1);
                             return std::string(name);
                           }()));
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(kept("").size(), 1u);
  built(source);
  EXPECT_EQ(kept("").size(), 1u);
}

TEST_F(SourceLibraryTest, WithoutACompilerOneLineSaysSo) {
  const std::string source = scratch.write("hooke.f", hooke_umat);
  const Environment path("PATH", scratch / "no"), fc("FC", "");
  try {
    built(source);
    FAIL() << "compiled by what?";
  } catch (const SystemError& error) {
    const std::string line = error.what();
    EXPECT_NE(line.find("hooke.f: is Fortran source, and there is no gfortran in $PATH"), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
}

TEST_F(SourceLibraryTest, TheCompilerThatTheEnvironmentNamesIsTakenWithItsOptions) {
  const std::string source = scratch.write("hooke.f", hooke_umat);
  const auto flags_by = [&](const char* words) {
    const Environment fc("FC", words);
    return find_fortran_compiler(source).options;
  };
  EXPECT_TRUE(flags_by("gfortran").empty());
  EXPECT_TRUE(flags_by("ifx -g").empty()) << "another compiler is left alone";
  EXPECT_EQ(flags_by("gfortran -m64  -g0"), (std::vector<std::string>{"-m64", "-g0"}));
  for (const char* absent : {"/nowhere/gfortran", "gfortran-of-nobody -m64"}) {
    try {
      flags_by(absent);
      ADD_FAILURE() << absent;
    } catch (const SystemError& error) {
      EXPECT_NE(std::string(error.what()).find("which is not there"), std::string::npos) << error.what();
    }
  }
}

TEST_F(SourceLibraryTest, ACacheThatCannotBeMadeIsNamed) {
  scratch.write("file", "");
  const Environment home("ASSAY_CACHE_HOME", scratch / "file");
  EXPECT_THROW(built(scratch.write("hooke.f", hooke_umat)), SystemError);
}

TEST_F(SourceLibraryTest, WhatIsNoSourceIsRefused) {
  EXPECT_EQ(refused(scratch / "absent.f"), "f:1:2: k: no such file: 'absent.f'");
  EXPECT_EQ(refused(scratch.write("binary.f", std::string("a\0b", 3))),
            "f:1:2: k: 'binary.f' is no Fortran source: it holds bytes that are no text");
  EXPECT_EQ(refused(scratch.write("dos.f", "      end\n\x1A")),
            "f:1:2: k: 'dos.f' holds U+001A, the end of a file of DOS, in line 2: delete it");
  EXPECT_EQ(refused(scratch.write("mac.f", "      subroutine a\r      end\r")),
            "f:1:2: k: 'mac.f' has lines that end with a carriage return alone, which no compiler reads: "
            "tr '\\r' '\\n' makes them line breaks");
  scratch.write("old.inc", "      x = 1\r      y = 2\r");
  EXPECT_NE(refused(scratch.write("includes.f", "      include 'old.inc'\n      end\n")).find("old.inc' has lines"),
            std::string::npos);
}

}  // namespace
}  // namespace assay::drivers::test_source_library
