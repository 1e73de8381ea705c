// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/basis/basis_bspline.hpp"
#include "mpm/data/dimension.hpp"
#include "mpm/kernels/variants/table.hpp"

namespace assay::mpm::ASSAY_INSTRUCTIONS {

template Kernels<ASSAY_DIMENSION> table<Bspline3Basis<ASSAY_DIMENSION>, ASSAY_DIMENSION>();

}  // namespace assay::mpm::ASSAY_INSTRUCTIONS
