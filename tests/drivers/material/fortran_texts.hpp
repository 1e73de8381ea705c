// SPDX-License-Identifier: BSD-3-Clause
// Small routines as they are written for Abaqus, for tests of sources.
#pragma once

#include <string>

#include "drivers/material/tool_process.hpp"

namespace assay::drivers {

inline bool has_gfortran() { return !tool_in_path("gfortran").empty(); }

/// Text, or line, of a routine that begins in column 1 here and in column 7 of fixed form.
inline std::string indented(const std::string& statements) {
  std::string text;
  for (std::size_t begin = 0; begin < statements.size();) {
    const std::size_t end = std::min(statements.find('\n', begin), statements.size());
    text += "      " + statements.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  return text;
}

/// A UMAT in fixed form of that name, with these statements.
inline std::string fixed_umat(const std::string& statements, const std::string& name = "UMAT",
                              const std::string& include = "ABA_PARAM.INC") {
  return "      SUBROUTINE " + name +
         "(STRESS,STATEV,DDSDDE,SSE,SPD,SCD,\n"
         "     1 RPL,DDSDDT,DRPLDE,DRPLDT,\n"
         "     2 STRAN,DSTRAN,TIME,DTIME,TEMP,DTEMP,PREDEF,DPRED,CMNAME,\n"
         "     3 NDI,NSHR,NTENS,NSTATV,PROPS,NPROPS,COORDS,DROT,PNEWDT,\n"
         "     4 CELENT,DFGRD0,DFGRD1,NOEL,NPT,LAYER,KSPT,JSTEP,KINC)\n"
         "C\n" +
         (include.empty() ? "" : "      INCLUDE '" + include + "'\n") +
         "      CHARACTER*80 CMNAME\n"
         "      DIMENSION STRESS(NTENS),STATEV(NSTATV),DDSDDE(NTENS,NTENS),\n"
         "     1 DDSDDT(NTENS),DRPLDE(NTENS),STRAN(NTENS),DSTRAN(NTENS),\n"
         "     2 TIME(2),PREDEF(1),DPRED(1),PROPS(NPROPS),COORDS(3),DROT(3,3),\n"
         "     3 DFGRD0(3,3),DFGRD1(3,3),JSTEP(4)\n" +
         statements + "      RETURN\n      END\n";
}

/// Isotropic linear elasticity: PROPS(1) = E, PROPS(2) = nu.
inline const std::string hooke_statements =
    "      EMOD=PROPS(1)\n"
    "      ENU=PROPS(2)\n"
    "      EG=EMOD/(2.D0*(1.D0+ENU))\n"
    "      ELAM=2.D0*EG*ENU/(1.D0-2.D0*ENU)\n"
    "      DO 20 I=1,NTENS\n"
    "        DO 10 J=1,NTENS\n"
    "          DDSDDE(I,J)=0.D0\n"
    "          IF (I.LE.NDI.AND.J.LE.NDI) DDSDDE(I,J)=ELAM\n"
    "   10   CONTINUE\n"
    "        DDSDDE(I,I)=DDSDDE(I,I)+EG\n"
    "        IF (I.LE.NDI) DDSDDE(I,I)=DDSDDE(I,I)+EG\n"
    "   20 CONTINUE\n"
    "      DO 40 I=1,NTENS\n"
    "        DO 30 J=1,NTENS\n"
    "          STRESS(I)=STRESS(I)+DDSDDE(I,J)*DSTRAN(J)\n"
    "   30   CONTINUE\n"
    "   40 CONTINUE\n";

inline const std::string hooke_umat = fixed_umat(hooke_statements);

/// The same in free form.
inline const std::string free_hooke_umat =
    "subroutine umat(stress, statev, ddsdde, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, time, dtime, "
    "&\n"
    "                temp, dtemp, predef, dpred, cmname, ndi, nshr, ntens, nstatv, props, nprops, coords, drot, &\n"
    "                pnewdt, celent, dfgrd0, dfgrd1, noel, npt, layer, kspt, jstep, kinc)\n"
    "  include 'aba_param.inc'\n"
    "  character(len=80) cmname\n"
    "  dimension stress(ntens), statev(nstatv), ddsdde(ntens, ntens), ddsddt(ntens), drplde(ntens), stran(ntens), &\n"
    "    dstran(ntens), time(2), predef(1), dpred(1), props(nprops), coords(3), drot(3, 3), dfgrd0(3, 3), &\n"
    "    dfgrd1(3, 3), jstep(4)\n"
    "  eg = props(1)/(2*(1 + props(2)))\n"
    "  ddsdde = 0\n"
    "  ddsdde(1:ndi, 1:ndi) = 2*eg*props(2)/(1 - 2*props(2))\n"
    "  do i = 1, ntens\n"
    "    ddsdde(i, i) = ddsdde(i, i) + merge(2*eg, eg, i <= ndi) ! shears are engineering's\n"
    "  end do\n"
    "  stress = stress + matmul(ddsdde, dstran)\n"
    "end subroutine umat\n";

}  // namespace assay::drivers
