// SPDX-License-Identifier: BSD-3-Clause
// Numbers in and out, independent of the locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "harness/numeric/number_text.hpp"

namespace assay::drivers {

/// The whole text as a decimal number: `2`, `-1.5`, `1e3`, `.5`, `+2.`; nothing for anything else (hexadecimal, `1,5`,
/// blanks, and values beyond the range of a double). YAML's `.inf` and `.nan` give those values.
std::optional<double> parse_number(std::string_view text);

/// The whole text as a whole number, digits with at most a sign before them; nothing for anything else.
std::optional<std::int64_t> parse_integer(std::string_view text);

using assay::number_text;

// For people.

using assay::rounded_text;

/// A text that is one number, at that many digits; any other text as it is.
std::string shortened(const std::string& text, int significant);

/// 12345678 as "12,345,678".
std::string grouped_text(std::int64_t value);

}  // namespace assay::drivers
