// SPDX-License-Identifier: BSD-3-Clause
// errors.csv: the error of every field over time.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/result/result.hpp"

namespace assay::drivers {

/// Columns t [s], l2, linf, rms36 [m], then l2 and linf of velocity [m/s], deformation_gradient, jacobian [1] and
/// stress [Pa]; one row a sample.
std::string errors_csv(const std::vector<ErrorSample>& history);

/// t [s] and l2 [m] of the rows in which both are numbers; of what is no errors.csv none.
std::vector<std::array<double, 2>> displacement_history(std::string_view errors_csv);

}  // namespace assay::drivers
