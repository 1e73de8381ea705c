// SPDX-License-Identifier: BSD-3-Clause
// What a user may have meant by a text that stands where a number, or true or false, belongs.
#pragma once

#include <cstddef>
#include <string>

#include "drivers/format/yaml_reader.hpp"

namespace assay::drivers {

/// To follow "found '0,1'": what makes it no number, and what to write instead, as ": numbers have a decimal point,
/// write 0.1"; empty where that is not known.
std::string number_remedy(const Tree& found);
std::string number_remedy(const std::string& found);

/// The same where true or false belongs.
std::string boolean_remedy(const Tree& found);

/// The same where a list of `count` numbers belongs, or of any where that is 0: ": write [2, 2]".
std::string list_remedy(const Tree& found, std::size_t count);

/// "[2, 2]" of "2; 2"; empty of a text that is not made of numbers.
std::string list_of_numbers(const std::string& text);

}  // namespace assay::drivers
