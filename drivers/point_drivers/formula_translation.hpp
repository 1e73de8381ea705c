// SPDX-License-Identifier: BSD-3-Clause
// The text of MTest's formulas in the words of muparser, which evaluates them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

struct TranslatedFormula {
  std::string text;                    ///< variables are called as variable_word() calls them, powers are ^ in brackets
  std::vector<std::string> variables;  ///< in the order in which they first appear
};

/// "v0", "v1", ...: muparser's names hold no brackets.
std::string variable_word(std::size_t number);

/// Throws InputError at the character that is wrong. where: of the first character of the text.
/// number_of_arguments: 0 of a name that is no function. functions: in messages.
TranslatedFormula translate_formula(const std::string& text, const Location& where,
                                    const std::function<int(const std::string&)>& number_of_arguments,
                                    const std::vector<std::string>& functions);

}  // namespace assay::drivers
