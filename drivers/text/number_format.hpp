// SPDX-License-Identifier: BSD-3-Clause
// Numbers for people, independent of the locale.
#pragma once

#include <cstdint>
#include <string>

#include "harness/numeric/number_text.hpp"

namespace assay::drivers {

using assay::rounded_text;

/// A text that is one number, at that many digits; any other text as it is.
std::string shortened(const std::string& text, int significant);

/// 12345678 as "12,345,678".
std::string grouped_text(std::int64_t value);

}  // namespace assay::drivers
