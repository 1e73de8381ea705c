// SPDX-License-Identifier: BSD-3-Clause
// Every basis, for the passes that are compiled once for each of them.
#pragma once

#include "mpm/basis_bspline.hpp"
#include "mpm/basis_cpdi.hpp"
#include "mpm/basis_cpdi2.hpp"
#include "mpm/basis_cpgimp.hpp"
#include "mpm/basis_linear.hpp"
#include "mpm/basis_ugimp.hpp"

#define ASSAY_FOR_EACH_BASIS(PASSES) \
  PASSES(LinearBasis, 2)             \
  PASSES(LinearBasis, 3)             \
  PASSES(UgimpBasis, 2)              \
  PASSES(UgimpBasis, 3)              \
  PASSES(CpgimpBasis, 2)             \
  PASSES(CpgimpBasis, 3)             \
  PASSES(CpdiBasis, 2)               \
  PASSES(CpdiBasis, 3)               \
  PASSES(Cpdi2Basis, 2)              \
  PASSES(Cpdi2Basis, 3)              \
  PASSES(Bspline2Basis, 2)           \
  PASSES(Bspline2Basis, 3)           \
  PASSES(Bspline3Basis, 2)           \
  PASSES(Bspline3Basis, 3)
