// SPDX-License-Identifier: BSD-3-Clause
// The routines of a Fortran source, and what their statements say of their arguments. A reading of the text, no
// compilation: what it cannot tell it leaves open.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "drivers/material/fortran_text.hpp"

namespace assay::drivers {

struct FortranRoutine {
  std::string name;  ///< small letters
  std::vector<std::string> arguments;
  int line = 0, last_line = 0;               ///< of its text
  std::vector<FortranStatement> statements;  ///< those between its head and its end
};

/// The subroutines, in their order; those of modules and inner ones too.
std::vector<FortranRoutine> subroutines_of(const std::vector<FortranStatement>& statements);

/// One variable of a declaration: "real(8), intent(in) :: a(3), b" are two.
struct FortranVariable {
  std::string type;  ///< integer, real, doubleprecision, ...
  int bytes = 0;     ///< 0: its kind is no number
  std::string name;
  int line = 0;
};

std::vector<FortranVariable> variables_of(std::span<const FortranStatement> statements);

/// Declarations, IMPLICIT, DIMENSION and the like: nothing that is executed.
bool declares(const std::string& statement);

/// Whether a statement that is executed names the variable.
bool uses(std::span<const FortranStatement> statements, const std::string& variable);

/// How an array is indexed where it is used.
struct ArrayUse {
  bool used = false;
  int largest = 0;    ///< of the indices that are constants
  bool whole = true;  ///< all indices are constants, and no other routine is given it: `largest` is its size
};

/// The last index counts. `array` in small letters.
ArrayUse use_of(std::span<const FortranStatement> statements, const std::string& array);

/// The file names that INCLUDE and #include lines name.
struct FortranInclude {
  std::string name;
  int line = 0;
};

std::vector<FortranInclude> includes_of(const std::vector<std::string>& lines, FortranForm form);

}  // namespace assay::drivers
