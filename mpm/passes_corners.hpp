// SPDX-License-Identifier: BSD-3-Clause
// Corners of domains that move one by one.
#pragma once

#include "mpm/pass.hpp"

namespace assay::mpm {

/// x_c += dt v(x_c), by the grid's velocity. Of bases that move corners.
template <int Dim>
Pass<Dim> corners_pass();

}  // namespace assay::mpm
