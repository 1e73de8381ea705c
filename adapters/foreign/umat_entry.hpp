// SPDX-License-Identifier: BSD-3-Clause
// Abaqus/Standard's user material, as Fortran compilers on Linux export it: all by reference, and the length of CMNAME
// by value at the end.
#pragma once

#include <cstddef>

namespace assay::adapters {

// clang-format off
using UmatEntry = void (*)(
    double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd,
    double* rpl, double* ddsddt, double* drplde, double* drpldt,
    double* stran, double* dstran, double* time, double* dtime, double* temp, double* dtemp,
    double* predef, double* dpred, const char* cmname,
    int* ndi, int* nshr, int* ntens, int* nstatv, double* props, int* nprops,
    double* coords, double* drot, double* pnewdt, double* celent,
    double* dfgrd0, double* dfgrd1, int* noel, int* npt, int* layer, int* kspt, int* jstep, int* kinc,
    std::size_t cmname_length);

/// Abaqus' SDVINI: initial STATEV of one point.
using SdviniEntry = void (*)(double* statev, double* coords, int* nstatv, int* ncrds, int* noel, int* npt, int* layer,
                             int* kspt);

/// Abaqus' UEXTERNALDB; LOP = 0: the analysis begins.
using UexternaldbEntry = void (*)(int* lop, int* lrestart, double* time, double* dtime, int* kstep, int* kinc);
// clang-format on

}  // namespace assay::adapters
