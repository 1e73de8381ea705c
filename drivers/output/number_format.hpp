// SPDX-License-Identifier: BSD-3-Clause
// Numbers for people, independent of the locale.
#pragma once

#include <cstdint>
#include <string>

namespace assay::drivers {

/// At most `significant` (1 to 17) digits, trailing zeros dropped, "1.2e-05" where that is shorter; "nan", "inf".
std::string rounded_text(double value, int significant);

/// A text that is one number, at that many digits; any other text as it is.
std::string shortened(const std::string& text, int significant);

/// 12345678 as "12,345,678".
std::string grouped_text(std::int64_t value);

}  // namespace assay::drivers
