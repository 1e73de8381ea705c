// SPDX-License-Identifier: BSD-3-Clause
// Sources of a USERMAT and of LS-DYNA's user materials, checked from their text.
#include <gtest/gtest.h>

#include "tests/drivers/material/source_fixture.hpp"
#include "tests/drivers/process.hpp"

namespace assay::drivers::test_check_vendor_sources {
namespace {

/// Linear elasticity as LS-DYNA's users write it: nothing is declared, and reals are those of the program.
std::string umat_of_lsdyna(const std::string& name, bool older) {
  return "      subroutine " + name + " (cm,eps,sig,epsp,hsv,dt1,capa,etype,tt,\n     1 temper,failel,crv," +
         (older ? "cma,qmat,elsiz,idele)\n" : "nnpcrv,cma,qmat,elsiz,idele,reject)\n") +
         "      dimension cm(*),eps(*),sig(*),hsv(*),crv(*),cma(*),qmat(3,3)\n"
         "      character*5 etype\n"
         "      logical failel,reject\n"
         "      young=cm(1)\n"
         "      ratio=cm(2)\n"
         "      g=young/(2.*(1.+ratio))\n"
         "      trace=young*ratio/((1.+ratio)*(1.-2.*ratio))*(eps(1)+eps(2)+eps(3))\n"
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

TEST_F(CheckVendorSources, AUserMaterialOfLsdynaIsRecognisedAndHasDoublePrecision) {
  for (const bool older : {false, true}) {
    int status = -1;
    const std::string text = said(
        status, {scratch.write("model.f", umat_of_lsdyna("umat46", older)), "--props", "210e3,.3", "--statev", "1"});
    EXPECT_EQ(status, 0) << text;
    EXPECT_NE(text.find("a user material of LS-DYNA (umat46_)"), std::string::npos) << text;
    EXPECT_NE(text.find("1 hsv from --statev"), std::string::npos) << text;
    const std::string description = bytes_of(scratch / "out/model.yaml");
    EXPECT_NE(description.find(older ? "arguments: 16" : "arguments: 18"), std::string::npos) << description;
  }
}

TEST_F(CheckVendorSources, OfSeveralOneIsChosen) {
  const std::string file = scratch.write("model.f", umat_of_lsdyna("umat41", false) + umat_of_lsdyna("umat42", true));
  int status = -1;
  const std::string both = said(status, {file, "--props", "210e3,.3", "--statev", "1"});
  EXPECT_EQ(status, 2) << both;
  EXPECT_NE(both.find("has several entry points"), std::string::npos) << both;
  said(status, {file, "--props", "210e3,.3", "--statev", "1", "--symbol", "umat42"});
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace assay::drivers::test_check_vendor_sources
