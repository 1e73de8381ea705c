// SPDX-License-Identifier: BSD-3-Clause
// Cuts the text of an MTest file into tokens.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drivers/point_drivers/mtest_tokens.hpp"

namespace assay::drivers {

/// The last token is Kind::end. A quote that is not closed in its line is a sign, because a description in plain words
/// may hold one.
std::vector<MtestToken> scan_mtest(std::string_view text, const std::string& file);

/// The name in @name@ that begins at `at`; empty where none does.
std::string placeholder_at(std::string_view text, std::size_t at);

/// Whether the whole word is one.
bool is_placeholder(std::string_view word);

}  // namespace assay::drivers
