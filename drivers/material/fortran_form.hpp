// SPDX-License-Identifier: BSD-3-Clause
// Whether a Fortran source is in fixed or in free form, and its lines as gfortran can read them, where they are written
// for a compiler that takes more. Every line keeps its number.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/material/fortran_text.hpp"

namespace assay::drivers {

/// What a directive says of the lines behind it: "!DIR$ FREEFORM", "cDEC$ NOFREEFORM", "!DIR$ FIXEDFORMLINESIZE:132".
std::optional<FortranForm> form_by_directive(const std::string& line);

struct FoundForm {
  FortranForm form = FortranForm::fixed;  ///< free, where it changes
  bool mixed = false;                     ///< directives change it on the way
  std::string why;  ///< where the name does not tell: "by a directive in line 2", "by its text: line 3"; else empty
};

/// By directives (!DIR$ FREEFORM), else by the name, unless lines of the text cannot be of that form and none
/// contradicts the other.
FoundForm form_of_source(const std::string& file, const std::vector<std::string>& lines);

/// What the name alone says.
FortranForm form_by_name(const std::string& file);

/// The form of each line: that of the name, until a directive says another.
std::vector<FortranForm> forms_of_lines(const std::vector<std::string>& lines, FortranForm by_name);

/// Lines of fixed form as lines of free form; those whose form is free stay.
std::vector<std::string> in_free_form(const std::vector<std::string>& lines, const std::vector<FortranForm>& forms);

/// Directives of the preprocessor in the first column, in small letters and with its quotes; an ampersand at the end of
/// a line of fixed form, as sources for both forms have it, is taken off.
std::vector<std::string> adapted_lines(const std::vector<std::string>& lines, const std::vector<FortranForm>& forms);

/// Whether a line is a directive of the preprocessor, wherever it begins.
bool is_preprocessor_line(const std::string& line, FortranForm form);

}  // namespace assay::drivers
