// SPDX-License-Identifier: BSD-3-Clause
// A source as gfortran can read it, where it is written for a compiler that takes more. Every line keeps its number.
#pragma once

#include <string>
#include <vector>

#include "drivers/material/fortran_text.hpp"

namespace assay::drivers {

/// The form of each line: that of the name, until a directive (!DIR$ FREEFORM, NOFREEFORM) says another.
std::vector<FortranForm> forms_of_lines(const std::vector<std::string>& lines, FortranForm by_name);

/// Lines of fixed form as lines of free form; those whose form is free stay.
std::vector<std::string> in_free_form(const std::vector<std::string>& lines, const std::vector<FortranForm>& forms);

/// Directives of the preprocessor in the first column, in small letters and with its quotes; an ampersand at the end of
/// a line of fixed form, as sources for both forms have it, is taken off.
std::vector<std::string> adapted_lines(const std::vector<std::string>& lines, const std::vector<FortranForm>& forms);

/// Whether a line is a directive of the preprocessor, wherever it begins.
bool is_preprocessor_line(const std::string& line, FortranForm form);

}  // namespace assay::drivers
