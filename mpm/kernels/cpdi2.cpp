// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/basis_cpdi2.hpp"
#include "mpm/kernels/table.hpp"

namespace assay::mpm::ASSAY_INSTRUCTIONS {

template Kernels<2> table<Cpdi2Basis<2>, 2>();
#ifndef ASSAY_ONLY_2D
template Kernels<3> table<Cpdi2Basis<3>, 3>();
#endif

}  // namespace assay::mpm::ASSAY_INSTRUCTIONS
