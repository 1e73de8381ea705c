// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/basis_bspline.hpp"
#include "mpm/kernels/table.hpp"

namespace assay::mpm::ASSAY_INSTRUCTIONS {

template Kernels<2> table<Bspline4Basis<2>, 2>();
#ifndef ASSAY_ONLY_2D
template Kernels<3> table<Bspline4Basis<3>, 3>();
#endif

}  // namespace assay::mpm::ASSAY_INSTRUCTIONS
