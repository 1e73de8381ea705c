// SPDX-License-Identifier: BSD-3-Clause
// errors.csv: the error of every field over time.
#pragma once

#include <string>
#include <vector>

#include "drivers/result.hpp"

namespace assay::drivers {

/// Columns t [s], l2, linf, rms36 [m], then l2 and linf of velocity [m/s], deformation_gradient, jacobian [1] and
/// stress [Pa]; one row a sample.
std::string errors_csv(const std::vector<ErrorSample>& history);

}  // namespace assay::drivers
