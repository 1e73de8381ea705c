// SPDX-License-Identifier: BSD-3-Clause
// Sources of a USERMAT and of LS-DYNA's user materials, checked from their text.
#include <gtest/gtest.h>

#include <map>

#include "tests/drivers/material/source_fixture.hpp"
#include "tests/drivers/process.hpp"

namespace assay::drivers::test_check_vendor_sources {
namespace {

/// What stands behind crv, by the number of arguments.
const std::map<int, std::string> ends_of_list{{12, ""},
                                              {13, ",nnpcrv"},
                                              {14, ",nnpcrv,cma"},
                                              {16, ",cma,qmat,elsiz,idele"},
                                              {18, ",nnpcrv,cma,qmat,elsiz,idele,reject"}};

/// Linear elasticity as LS-DYNA's users write it: nothing is declared, and reals are those of the program.
std::string umat_of_lsdyna(const std::string& name, int arguments) {
  return "      subroutine " + name + " (cm,eps,sig,epsp,hsv,dt1,capa,etype,tt,\n     1 temper,failel,crv" +
         ends_of_list.at(arguments) + ")\n" + "      dimension cm(*),eps(*),sig(*),hsv(*),crv(*)" +
         (arguments > 13 ? ",cma(*),qmat(3,3)" : "") +
         "\n      character*5 etype\n"
         "      logical failel,reject\n"
         "      young=cm(1)\n"
         "      ratio=cm(2)\n"
         "      g=young/(2.*(1.+ratio))\n"
         "      trace=young*ratio/(1.+ratio)/(1.-2.*ratio)*(eps(1)+eps(2)+eps(3))\n"
         "      do i=1,3\n"
         "        sig(i)=sig(i)+trace+2.*g*eps(i)\n"
         "        sig(i+3)=sig(i+3)+g*eps(i+3)\n"
         "      enddo\n"
         "      hsv(1)=hsv(1)+1.\n"
         "      return\n"
         "      end\n";
}

const std::string usermat_text =
    "      subroutine usermat(\n"
    "     &  matId,elemId,kDomIntPt,kLayer,kSectPt,ldstep,isubst,keycut,\n"
    "     &  nDirect,nShear,ncomp,nStatev,nProp,Time,dTime,Temp,dTemp,\n"
    "     &  stress,ustatev,dsdePl,sedEl,sedPl,epseq,Strain,dStrain,\n"
    "     &  epsPl,prop,coords,var0,defGrad_t,defGrad,tsstif,epsZZ,\n"
    "     &  var1,var2,var3,var4,var5,var6,var7,var8)\n"
    "#include \"impcom.inc\"\n"
    "      dimension stress(ncomp),dsdePl(ncomp,ncomp),dStrain(ncomp),\n"
    "     & prop(nProp)\n"
    "      young=prop(1)\n"
    "      g=young/2/(1+prop(2))\n"
    "      dsdePl=0\n"
    "      dsdePl(1:3,1:3)=2*g*prop(2)/(1-2*prop(2))\n"
    "      do i=1,ncomp\n"
    "        dsdePl(i,i)=dsdePl(i,i)+g\n"
    "        if (i.le.nDirect) dsdePl(i,i)=dsdePl(i,i)+g\n"
    "      enddo\n"
    "      stress=stress+matmul(dsdePl,dStrain)\n"
    "      end\n";

class CheckVendorSources : public SourceTest {
 protected:
  std::string said(int& status, std::vector<std::string> words) {
    words.insert(words.begin(), "check");
    words.insert(words.end(), {"--quick", "-o", scratch / "out"});
    const Ending ending = assay(words);
    status = ending.status;
    return ending.said;
  }
};
using LongCheckVendorSources = CheckVendorSources;

TEST_F(CheckVendorSources, AUsermatIsRecognised) {
  int status = -1;
  const std::string text = said(status, {scratch.write("model.f", usermat_text), "--props", "210e3,.3"});
  EXPECT_EQ(status, 0) << text;
  EXPECT_NE(text.find("a USERMAT (usermat_)"), std::string::npos) << text;
  EXPECT_NE(text.find("2 prop from --props"), std::string::npos) << text;
  const std::string description = bytes_of(scratch / "out/model.yaml");
  EXPECT_NE(description.find("interface: usermat"), std::string::npos) << description;
  EXPECT_NE(description.find("young in the source"), std::string::npos) << description;
}

TEST_F(LongCheckVendorSources, AUserMaterialOfLsdynaIsRecognisedAndHasDoublePrecision) {
  for (const int arguments : {12, 13, 16, 18}) {
    int status = -1;
    const std::string text = said(status, {scratch.write("model.f", umat_of_lsdyna("umat46", arguments)), "--props",
                                           "210e3,.3", "--statev", "1"});
    EXPECT_EQ(status, 0) << text;
    EXPECT_NE(text.find("a user material of LS-DYNA (umat46_)"), std::string::npos) << text;
    EXPECT_NE(text.find("1 hsv from --statev"), std::string::npos) << text;
    const std::string description = bytes_of(scratch / "out/model.yaml");
    EXPECT_NE(description.find("arguments: " + std::to_string(arguments)), std::string::npos) << description;
    EXPECT_EQ(assay({"check", scratch / "out/model.yaml", "--quick", "-o", scratch / "again"}).status, 0);
  }
}

TEST_F(LongCheckVendorSources, AnotherNumberOfArgumentsIsNamed) {
  int status = -1;
  const std::string file = scratch.write("model.f", umat_of_lsdyna("umat46", 14));
  const std::string text = said(status, {file, "--props", "210e3,.3", "--statev", "1"});
  EXPECT_EQ(status, 2);
  EXPECT_NE(text.find("model.f:1:1: 'umat46' has 14 arguments, and a user material of LS-DYNA has 12, 13, 16 or 18"),
            std::string::npos)
      << text;
  const std::string chosen = said(status, {file, "--props", "210e3,.3", "--statev", "1", "--symbol", "umat46"});
  EXPECT_NE(chosen.find("symbol: 'umat46' has 14 arguments"), std::string::npos) << chosen;
  std::string shorter = usermat_text;
  shorter.replace(shorter.find(",var8"), 5, "");
  const std::string of_ansys = said(status, {scratch.write("u.f", shorter), "--props", "210e3,.3"});
  EXPECT_NE(of_ansys.find("'usermat' has 40 arguments, and a USERMAT has 41 or 42"), std::string::npos) << of_ansys;
}

/// The samples that come with LS-DYNA name these files and what they declare, with and without IMPLICIT NONE.
TEST_F(LongCheckVendorSources, TheIncludedFilesOfLsdynaAreProvided) {
  const std::string sample =
      "      include 'nlqparm'\n"
      "      include 'bk06.inc'\n"
      "      include 'iounits.inc'\n"
      "      dimension cm(*),eps(*),sig(*),hsv(*),crv(lq1,2,*),cma(*),qmat(3,3)\n";
  const std::string end =
      "      if (ncycle.eq.1) call usermsg('mat41')\n"
      "      if (etype.ne.'solid') then\n"
      "        write(iotty,10) etype\n"
      "        cerdat(1)=etype\n"
      "        call lsmsg(3,MSG_SOL+1150,ioall,ierdat,rerdat,cerdat,0)\n"
      "      endif\n"
      "   10 format(a)\n"
      "      return\n";
  std::string text = umat_of_lsdyna("umat41", 18);
  const std::string declared = "      dimension cm(*),eps(*),sig(*),hsv(*),crv(*),cma(*),qmat(3,3)\n";
  text.replace(text.find(declared), declared.size(), sample);
  text.replace(text.find("      return\n"), 13, end);
  int status = -1;
  const auto of = [&](const std::string& name, const std::string& source) {
    return said(status, {scratch.write(name, source), "--props", "210e3,.3", "--statev", "1"});
  };
  const std::string implicit = of("model.f", text);
  EXPECT_EQ(status, 0) << implicit;
  EXPECT_EQ(implicit.find("warning"), std::string::npos) << implicit;
  std::string typed = text;
  typed.insert(typed.find("      include 'nlqparm'"), "      implicit none\n");
  typed.insert(typed.find("      character*5 etype"),
               "      real epsp,dt1,capa,tt,temper,elsiz,cm,eps,sig,hsv,crv,cma,qmat\n"
               "      real young,ratio,g,trace\n      integer nnpcrv(*),idele,i\n");
  EXPECT_EQ((of("typed.f", typed), status), 0) << of("typed.f", typed);
  scratch.write("nlqparm", "      parameter (nlq=\n");
  EXPECT_NE(of("own.f", text).find("nlqparm:1:"), std::string::npos) << of("own.f", text);
  EXPECT_EQ(status, 2) << "the file beside the source goes first, and is wrong";
}

/// How compilers of other vendors read columns is not known.
TEST_F(LongCheckVendorSources, ColumnsAreThoseOfAbaqusForItsSourcesAlone) {
  int status = -1;
  std::string text = umat_of_lsdyna("umat41", 18);
  text.replace(text.find("      ratio=cm(2)\n"), 18, "      ratio=" + std::string(62, ' ') + "cm(2)\n");
  for (const auto& [name, source] : {std::pair{"dyna.f", text}, {"ansys.f", usermat_text}}) {
    const std::string found = said(status, {scratch.write(name, source), "--props", "210e3,.3", "--statev", "1"});
    EXPECT_NE(found.find("read at 132 columns;"), std::string::npos) << found;
    EXPECT_EQ(found.find("Abaqus"), std::string::npos) << found;
    EXPECT_EQ(found.find("assay reads it, since it takes 132 columns;") != found.npos, name == std::string("dyna.f"));
  }
  const std::string of_abaqus = said(status, {scratch.write("umat.f", hooke_umat), "--props", "210e3,.3"});
  EXPECT_NE(of_abaqus.find("read at 132 columns as by Abaqus"), std::string::npos) << of_abaqus;
}

TEST_F(LongCheckVendorSources, OfSeveralOneIsChosen) {
  const std::string file = scratch.write("model.f", umat_of_lsdyna("umat41", 18) + umat_of_lsdyna("umat42", 16));
  int status = -1;
  const std::string both = said(status, {file, "--props", "210e3,.3", "--statev", "1"});
  EXPECT_EQ(status, 2) << both;
  EXPECT_NE(both.find("has several entry points"), std::string::npos) << both;
  said(status, {file, "--props", "210e3,.3", "--statev", "1", "--symbol", "umat42"});
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace assay::drivers::test_check_vendor_sources
