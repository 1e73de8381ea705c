// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/source_description.hpp"

#include <cmath>

#include "drivers/format/yaml_reader.hpp"
#include "drivers/material/fortran_compiler.hpp"
#include "drivers/material/material_description.hpp"
#include "drivers/material/registry.hpp"
#include "drivers/material/source_entry.hpp"
#include "tests/drivers/material/source_fixture.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/support/kept_yaml.hpp"

namespace assay::drivers::test_source_description {
namespace {

class SourceDescriptionTest : public SourceTest {
 protected:
  SourceDescription describe(const std::string& file, const SourceRequest& request = {}) const {
    SourceDescription found = describe_source(file, request, {"f", 1, 2}, "k");
    std::string text = found.text;
    const std::string folder = scratch / "";
    while (text.find(folder) != text.npos) text.replace(text.find(folder), folder.size(), "/folder/");
    keep_yaml("plain", text);
    return found;
  }
  adapters::ForeignModel model(const SourceDescription& description) const {
    return read_description(description.text, scratch / "d.yaml").foreign.value();
  }
  std::string refused(const std::string& file, const SourceRequest& request = {}) const {
    std::string line = refusal_of([&] { describe(file, request); });
    const std::string folder = scratch / "";
    while (line.find(folder) != line.npos) line.replace(line.find(folder), folder.size(), "");
    return line;
  }
  static std::string all(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& each : sentences) text += each + "\n";
    return text;
  }
};
using LongSourceDescriptionTest = SourceDescriptionTest;

TEST_F(SourceDescriptionTest, HasWhatWasGiven) {
  SourceRequest request;
  request.props = {{"", 210e3}, {"nu", .3}, {"", 250}};
  request.statev = 7;
  const SourceDescription found = describe(scratch.write("My-Model.f", hooke_umat), request);
  EXPECT_EQ(found.name, "my_model");
  const adapters::ForeignModel model = this->model(found);
  EXPECT_EQ(model.interface, adapters::ForeignInterface::umat);
  EXPECT_EQ(model.symbol, "umat_");
  ASSERT_EQ(model.properties.size(), 3u);
  EXPECT_EQ(model.properties[0].name, "p1");
  EXPECT_EQ(model.properties[0].value, 210e3);
  EXPECT_EQ(model.properties[1].name, "nu");
  EXPECT_EQ(model.properties[2].name, "p3");
  EXPECT_EQ(model.state.size(), 7u);
  EXPECT_NE(found.text.find("# emod in the source"), std::string::npos) << found.text;
  EXPECT_NE(all(found.notes).find("fixed form, read at 132 columns"), std::string::npos) << all(found.notes);
  EXPECT_NE(all(found.notes).find("3 PROPS from --props; the source reads PROPS(1) to PROPS(2)"), std::string::npos)
      << all(found.notes);
  EXPECT_NE(all(found.notes).find("all are taken as scalars, because the source does not say which are tensors"),
            std::string::npos);
  EXPECT_TRUE(found.warnings.empty()) << all(found.warnings);
}

TEST_F(SourceDescriptionTest, ADeckGivesConstantsNamesAndUnits) {
  const std::string source = scratch.write("job.for", hooke_umat);
  const std::string deck =
      scratch.write("job.inp",
                    "*Material, name=Steel\n*Density\n7.85e-9\n*Depvar\n3\n2, PEEQ, \"plastic: #\"\n"
                    "3, PEEQ\n*User Material, constants=2\n210e3, .3\n");
  SourceRequest by_option;
  by_option.deck = deck;
  for (const SourceDescription& found : {describe(deck), describe(source, by_option)}) {
    const MaterialDescription description = read_description(found.text, scratch / "d.yaml");
    const adapters::ForeignModel& model = *description.foreign;
    EXPECT_EQ(model.properties[0].value, 210e3);
    ASSERT_EQ(model.state.size(), 3u);
    EXPECT_EQ(model.state[0].name + " " + model.state[1].name + " " + model.state[2].name, "s1 PEEQ s3");
    EXPECT_EQ(model.state[1].doc, "plastic: #");
    EXPECT_EQ(model.material_name, "STEEL");
    EXPECT_EQ(model.units.stress, 1e6);
    EXPECT_EQ(model.units.length, 1e-3);
    EXPECT_NEAR(description.density.value(), 7850, 1e-9 * 7850);
    EXPECT_EQ(description.source, source);
    EXPECT_EQ(model.folder + "/", scratch / "");
  }
}

TEST_F(SourceDescriptionTest, ADensityTellsItsUnits) {
  EXPECT_EQ(density_of(7.85e-9).stress, "MPa");
  EXPECT_NEAR(density_of(7.33e-4).si, 7833, 1);  // of steel, in lbf s^2/in^4
  EXPECT_EQ(density_of(7.33e-4).stress, "psi");
  for (const double other : {7850.0, 2.7, 1.0}) {
    EXPECT_EQ(density_of(other).stress, "") << other;
    EXPECT_EQ(density_of(other).si, other);
  }
}

TEST_F(SourceDescriptionTest, WithoutNumbersTheTextIsAsked) {
  const std::string hooke = scratch.write("hooke.f", hooke_umat);
  const adapters::ForeignModel model = this->model(describe(hooke));
  ASSERT_EQ(model.properties.size(), 2u);
  EXPECT_TRUE(std::isnan(model.properties[1].value));
  EXPECT_TRUE(model.state.empty()) << "the source uses none";
  SourceRequest check;
  check.needs_values = true;
  EXPECT_EQ(refused(hooke, check),
            "hooke.f: --props: required and not given: the source reads PROPS(1) to PROPS(2), as --props 1000,.3");
  scratch.write("hooke.inp", "");
  EXPECT_NE(refused(hooke, check).find("; hooke.inp beside it may have them: --deck hooke.inp"), std::string::npos);
  check.props = {{"", 1000}, {"", .3}};
  EXPECT_TRUE(this->model(describe(hooke, check)).state.empty());
}

TEST_F(SourceDescriptionTest, StateIsTakenWhereTheTextLeavesNoDoubt) {
  SourceRequest check;
  check.needs_values = true;
  check.props = {{"", 1000}, {"", .3}};
  const std::string plain = scratch.write("plain.f", fixed_umat(hooke_statements + "      STATEV(4)=STATEV(2)+1\n"));
  EXPECT_EQ(model(describe(plain, check)).state.size(), 4u);
  const std::string loop = scratch.write(
      "loop.f",
      fixed_umat(hooke_statements + "      DO 50 I=1,NTENS\n   50 STATEV(I)=STATEV(I)+DSTRAN(I)\n      STATEV(7)=1\n"));
  EXPECT_EQ(refused(loop, check),
            "loop.f: --statev: required and not given: the source reads STATEV(7), and others by "
            "computed indices");
  EXPECT_NE(refused(loop).find("f:1:2: k: 'loop.f' does not tell how many STATEV it needs"), std::string::npos)
      << refused(loop);
  check.statev = 7;
  EXPECT_EQ(model(describe(loop, check)).state.size(), 7u);
  check.statev = 3;
  EXPECT_NE(all(describe(loop, check).warnings).find("loop.f: uses STATEV(7), and there are 3"), std::string::npos);
}

TEST_F(LongSourceDescriptionTest, TheEntryIsTheOneThatAbaqusWouldCall) {
  const std::string other = fixed_umat(hooke_statements, "UMAT_CLAY"), own = fixed_umat(hooke_statements, "MYLAW");
  EXPECT_EQ(model(describe(scratch.write("own.f", own))).symbol, "mylaw_") << "by its 37 arguments";
  EXPECT_EQ(model(describe(scratch.write("with.f", hooke_umat + other))).symbol, "umat_") << "the plain name";
  const std::string two = scratch.write("two.f", own + other);
  EXPECT_EQ(refused(two), "two.f: has several entry points: choose one by FILE.f:NAME; known: mylaw_, umat_clay_");
  SourceRequest request;
  for (const char* name : {"MYLAW", "mylaw_", "MyLaw"}) {
    request.symbol = name;
    EXPECT_EQ(model(describe(two, request)).symbol, "mylaw_");
  }
  request.symbol = "absent";
  EXPECT_EQ(refused(two, request), "two.f: symbol: 'absent' is no routine of it; known: mylaw_, umat_clay_");
  EXPECT_EQ(
      refused(scratch.write("none.f", "      SUBROUTINE HELPER(A,B)\n      A=B\n      END\n")),
      "none.f: has no UMAT and no VUMAT: no routine of that name, and none of 37 or 33 arguments; no usermat, and no "
      "umat41 to umat50; known: its "
      "subroutines helper (2)");
  std::string within = hooke_umat;
  within.insert(within.rfind("END"), "END SUBROUTINE");
  within.erase(within.rfind("END\n"));
  EXPECT_EQ(refused(scratch.write("module.f", "      MODULE LAWS\n      CONTAINS\n" + within + "\n      END MODULE\n")),
            "module.f:3:1: 'umat' has the 37 arguments of a UMAT, but no program can find it: move it out of its "
            "MODULE or CONTAINS");
  EXPECT_EQ(
      model(describe(scratch.write("helped.f", hooke_umat + "      SUBROUTINE UMAT_HELP(A)\n      A=1\n      END\n")))
          .symbol,
      "umat_");
}

TEST_F(SourceDescriptionTest, AVumatIsKnownByItsArguments) {
  const std::string text =
      "      subroutine law(nblock,ndir,nshr,nstatev,nfieldv,nprops,lanneal,\n"
      "     1 stepTime,totalTime,dt,cmname,coordMp,charLength,props,density,\n"
      "     2 strainInc,relSpinInc,tempOld,stretchOld,defgradOld,fieldOld,\n"
      "     3 stressOld,stateOld,enerInternOld,enerInelasOld,tempNew,\n"
      "     4 stretchNew,defgradNew,fieldNew,stressNew,stateNew,\n"
      "     5 enerInternNew,enerInelasNew)\n"
      "      include 'VABA_PARAM.INC'\n"
      "      dimension props(nprops),stateOld(nblock,nstatev),\n"
      "     1 stateNew(nblock,nstatev),stressNew(nblock,ndir+nshr)\n"
      "      character*80 cmname\n"
      "      do k=1,nblock\n        stateNew(k,3)=stateOld(k,2)+props(5)*dt\n      end do\n      end\n";
  const SourceDescription found = describe(scratch.write("v.f", text));
  const adapters::ForeignModel vumat = model(found);
  EXPECT_EQ(vumat.interface, adapters::ForeignInterface::vumat);
  EXPECT_EQ(vumat.symbol, "law_");
  EXPECT_EQ(vumat.properties.size(), 5u);
  EXPECT_EQ(vumat.state.size(), 3u);
  EXPECT_NE(all(found.notes).find("dt is used: if the stress depends on the rate"), std::string::npos)
      << all(found.notes);
}

TEST_F(SourceDescriptionTest, WhatMayFollowIsSaidAndNotAssumed) {
  const SourceDescription found =
      describe(scratch.write("m.f", fixed_umat(hooke_statements + "      STATEV(1)=STATEV(1)+DTIME\n")));
  EXPECT_NE(all(found.notes).find("flags: [rate_dependent]"), std::string::npos);
  EXPECT_NE(all(found.notes).find("neither DROT nor ROTSIG"), std::string::npos);
  EXPECT_EQ(model(found).flags & ASSAY_RATE_DEPENDENT, 0u);
  const std::string finite = all(describe(scratch.write("F.f", fixed_umat("      STRESS(1)=DFGRD1(1,1)\n"))).notes);
  EXPECT_NE(finite.find("the source reads DFGRD1 and no strain: DDSDDE may be for finite strain"), std::string::npos)
      << finite;
}

TEST_F(LongSourceDescriptionTest, SizesThatAbaqusDoesNotHandOverAreWarnedOf) {
  const auto warnings = [&](const std::string& statements, const std::string& include = "ABA_PARAM.INC") {
    return all(describe(scratch.write("m.f", fixed_umat(statements, "UMAT", include))).warnings);
  };
  EXPECT_EQ(warnings("      X=1\n"), "");
  const std::string wide = warnings("      INTEGER*8 NDI,NSHR\n");
  EXPECT_NE(wide.find("m.f:1: NDI, NSHR are declared an integer of 8 bytes, and Abaqus hands over 4"),
            std::string::npos)
      << wide;
  const std::string narrow = warnings("      X=1\n", "");
  EXPECT_NE(narrow.find("are reals of 4 bytes, and Abaqus hands over 8: INCLUDE 'ABA_PARAM.INC'"), std::string::npos)
      << narrow;
  std::string implicit = fixed_umat("      X=1\n", "UMAT", "");
  implicit.replace(implicit.find("C\n"), 2, "      IMPLICIT REAL*8 (A-H,O-Z)\n");
  EXPECT_EQ(all(describe(scratch.write("i.f", implicit)).warnings), "");
  EXPECT_NE(warnings("      REAL DTIME\n").find("DTIME is a real of 4 bytes"), std::string::npos);
}

TEST_F(LongSourceDescriptionTest, AnotherListOfArgumentsIsWarnedOf) {
  const auto warnings = [&](const std::string& from, const std::string& to) {
    std::string text = fixed_umat("      X=1\n");
    text.replace(text.find(from), from.size(), to);
    return all(describe(scratch.write("m.f", text)).warnings);
  };
  const std::string fewer = warnings("SPD,SCD", "SPD");
  EXPECT_NE(fewer.find("m.f:1: takes 36 arguments, and Abaqus hands over 37: SCD is not among them"), std::string::npos)
      << fewer;
  const std::string more = warnings("KSPT,JSTEP", "KSPT,KMORE,JSTEP");
  EXPECT_NE(more.find("takes 38 arguments, and Abaqus hands over 37; every argument after the first missing or added"),
            std::string::npos)
      << more;
  const std::string turned = warnings("(STRESS,STATEV", "(STATEV,STRESS");
  EXPECT_NE(turned.find("m.f:1: STATEV stands where Abaqus hands over STRESS"), std::string::npos) << turned;
  EXPECT_EQ(warnings("JSTEP,KINC", "KSTEP,KINC").find("stands where"), std::string::npos) << "a name of its own";
}

TEST_F(LongSourceDescriptionTest, WhatTheCompilerWarnsOfIsTold) {
  const std::string routine = "      SUBROUTINE TWICE(A,B)\n      INCLUDE 'ABA_PARAM.INC'\n      B=2*A\n      END\n";
  const auto warnings = [&](const std::string& statements) {
    const std::string file = scratch.write("m.f", fixed_umat(hooke_statements + statements) + routine);
    const std::string first = all(describe(file).warnings);
    EXPECT_EQ(all(describe(file).warnings), first) << "where its library is kept";
    return first;
  };
  EXPECT_NE(warnings("      CALL TWICE(1.0,SSE)\n").find("Type mismatch in argument 'a'; passed REAL(4) to REAL(8)"),
            std::string::npos);
  EXPECT_NE(warnings("      CALL TWICE(1.D0)\n").find("Missing actual argument for argument 'b'"), std::string::npos);
  const std::string unset = warnings("      SSE=ANU\n");
  EXPECT_NE(unset.find(scratch / "m.f:"), std::string::npos) << unset;
  EXPECT_NE(unset.find("'anu' is used uninitialized"), std::string::npos) << unset;
  EXPECT_NE(warnings("      SSE=2/3*EG\n").find("Integer division truncated"), std::string::npos);
  const std::string below = "Array reference out of bounds (0 < 1)";
  const std::string loop = "      DO I=0,2\n        SSE=SSE+DSTRAN(I)\n      END DO\n";
  EXPECT_NE(warnings(loop).find(below + " in loop"), std::string::npos) << warnings(loop);
  EXPECT_EQ(warnings("      CALL TWICE(EG,SSE)\n"), "");
  EXPECT_EQ(warnings("      SSE=TIME(2)+PREDEF(1)\n"), "");
}

TEST_F(LongSourceDescriptionTest, VariablesThatHoldLessOfAPropertyAreWarnedOf) {
  const auto warnings = [&](const std::string& statements) {
    return all(describe(scratch.write("m.f", fixed_umat(statements))).warnings);
  };
  const std::string whole = warnings("      K0=PROPS(1)\n      XNU=PROPS(2)\n      LAM=2*PROPS(1)/3\n");
  EXPECT_NE(whole.find("K0, LAM are integers by their first letter, and take real numbers"), std::string::npos)
      << whole;
  EXPECT_NE(whole.find("m.f:13: "), std::string::npos) << whole;
  const std::string single = warnings("      REAL E\n      E=PROPS(1)\n");
  EXPECT_NE(single.find("m.f:14: E is a real of 4 bytes, and takes PROPS"), std::string::npos) << single;
  for (const char* right : {"      REAL*8 K0\n      K0=PROPS(1)\n", "      N=INT(PROPS(1))\n", "      E=PROPS(1)\n",
                            "      N=NINT(PROPS(1))\n", "      INTEGER N\n      N=PROPS(1)\n"}) {
    EXPECT_EQ(warnings(right), "") << right;
  }
}

TEST_F(SourceDescriptionTest, ADeckNeedsItsSource) {
  const std::string deck = scratch.write("job.inp", "*Material, name=A\n*User Material, constants=1\n1\n");
  EXPECT_EQ(refused(deck),
            "f:1:2: k: 'job.inp' has no Fortran source beside it: job.f, job.for, ...; assay check takes SOURCE --deck "
            "job.inp");
  scratch.write("job.f", hooke_umat);
  scratch.write("job.for", hooke_umat);
  EXPECT_NE(refused(deck).find("has several Fortran sources beside it"), std::string::npos);
}

TEST_F(SourceDescriptionTest, IsFoundByItsPath) {
  const std::string source = scratch.write("hooke.f", hooke_umat);
  const MaterialSource found = find_material(source, {}, "k", Isolation::worker, {{"p1", 1}, {"p4", 2}});
  EXPECT_STREQ(found.table->name, "hooke");
  EXPECT_EQ(found.table->parameter_count, 4u) << "as many as a scene names";
  EXPECT_EQ(found.source, source);
  EXPECT_EQ(found.isolation, Isolation::worker);
  const std::string two = scratch.write("two.f", hooke_umat + fixed_umat(hooke_statements, "OTHER"));
  EXPECT_STREQ(find_material(two + ":other", {}, "k").table->name, "two");
  scratch.write("two.inp",
                "*Material, name=A\n*User Material, constants=1\n1\n*Material, name=B\n*User Material, "
                "constants=3\n1, 2, 3\n");
  EXPECT_EQ(find_material((scratch / "two.inp") + ":B", {}, "k").table->parameter_count, 3u);
}

TEST_F(LongSourceDescriptionTest, ADescriptionMayNameASource) {
  scratch.write("hooke.f", hooke_umat);
  const auto read = [&](const std::string& text) { return read_description(text, scratch / "d.yaml"); };
  const MaterialDescription first = read("source: hooke.f\ninterface: umat\n");
  EXPECT_TRUE(std::filesystem::exists(first.library));
  scratch.write("hooke.f", hooke_umat + "C\n");
  EXPECT_NE(read("source: hooke.f\ninterface: umat\n").library, first.library) << "compiled when it has changed";
  EXPECT_EQ(read(description_yaml(first)).library, first.library) << "and not by a worker";
  EXPECT_EQ(read(lasting_yaml(first)).source, scratch / "hooke.f");
  scratch.write("wide.f", fixed_umat("      INTEGER*8 NDI\n" + hooke_statements));
  EXPECT_NE(all(read("source: wide.f\ninterface: umat\n").warnings).find("NDI is declared an integer of 8 bytes"),
            std::string::npos);
  const auto line = [&](const std::string& text) { return refusal_of([&] { read(text); }); };
  EXPECT_NE(line("source: hooke.f\n").find("source: goes with interface: umat, vumat, usermat or lsdyna"),
            std::string::npos);
  EXPECT_NE(line("source: no.f\ninterface: umat\n").find(":1:9: source: no such file"), std::string::npos);
  EXPECT_NE(line("source: a.c\ninterface: umat\n").find(":1:9: source: must be a Fortran source"), std::string::npos);
  EXPECT_NE(line("library: a.so\nsource: hooke.f\ninterface: umat\n")
                .find("d.yaml:2:9: source: contradicts `library`: a source is compiled"),
            std::string::npos);
  const std::string absent = "link: the linker finds no library 'no_such_lib'";
  EXPECT_NE(line("source: hooke.f\ninterface: umat\nlink: [m, no_such_lib]\n").find("d.yaml:3:11: " + absent),
            std::string::npos);
  EXPECT_NE(line("source: hooke.f\ninterface: umat\nlink: no_such_lib\n").find("d.yaml:3:7: " + absent),
            std::string::npos);
}

}  // namespace
}  // namespace assay::drivers::test_source_description
