// SPDX-License-Identifier: BSD-3-Clause
// Tables of numbers between blanks, with remarks that begin with #.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

struct NumberLine {
  std::vector<std::string> fields;
  std::vector<int> columns;  ///< of the first characters of the fields, from 1
  int line = 0;              ///< from 1
};

/// Lines that are not empty and no remarks.
std::vector<NumberLine> number_lines(std::string_view text);

/// The values of a column, from 1. Throws InputError at a line that does not have a number there.
std::vector<double> column_values(const std::vector<NumberLine>& lines, int column, const std::string& file);

/// Of a formula in which $2 is the value of the second column. `constant` gives the value of another name.
/// where: of the formula.
std::vector<double> formula_of_columns(const std::vector<NumberLine>& lines, const std::string& formula,
                                       const std::string& file, const Location& where,
                                       const std::function<double(const std::string& name)>& constant);

/// The bytes of such a file.
std::string read_table_bytes(const std::string& file);

}  // namespace assay::drivers
