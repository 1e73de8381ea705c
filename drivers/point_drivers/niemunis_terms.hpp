// SPDX-License-Identifier: BSD-3-Clause
// Conditions and equations of Niemunis' files: sums of factors times quantities.
#pragma once

#include <string_view>

#include "drivers/point_drivers/niemunis_file.hpp"

namespace assay::drivers {

/// "s1 - 2*s3 > 100". where: of the first character.
NiemunisExit read_exit(std::string_view text, const Location& where);

/// Reads "sd1 + 3.0*sd2 = -10" into an equation. What follows # or ! is a remark.
void read_restriction(std::string_view text, const Location& where, std::size_t equation,
                      NiemunisRestrictions& restrictions);

}  // namespace assay::drivers
