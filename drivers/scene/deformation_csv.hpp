// SPDX-License-Identifier: BSD-3-Clause
// F(t) of a homogeneous motion from a CSV file.
#pragma once

#include <string>

#include "harness/motion/kinds/deformation_table.hpp"

namespace assay::drivers {

/// Columns t [s], F11, F12, F21, F22, perhaps F33, and F13, F23, F31, F32, which only come together (0, and 1 for F33,
/// where not given). Throws InputError as read_csv does, and unless the first row is t = 0 with F = I, times ascend,
/// and det F > 0 at all rows and at 32 times between two.
DeformationTable read_deformation_table(const std::string& file, Interpolation interpolation);

}  // namespace assay::drivers
