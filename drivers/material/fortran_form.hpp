// SPDX-License-Identifier: BSD-3-Clause
// Whether a Fortran source is in fixed or in free form.
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

}  // namespace assay::drivers
