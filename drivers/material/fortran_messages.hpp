// SPDX-License-Identifier: BSD-3-Clause
// What gfortran says of a source: its errors, and those of its warnings that usually mean a mistake.
#pragma once

#include <string>
#include <vector>

#include "drivers/material/fortran_source.hpp"
#include "drivers/system/input_error.hpp"

namespace assay::drivers {

/// "./model.f:4:72: Error: Syntax error in argument list at (1)".
struct CompilerMessage {
  Location where;
  std::string text;
};

std::vector<CompilerMessage> errors_in(const std::string& said);

/// Its own words without the marks of the compiler's drawing.
std::string plain_message(std::string text);

/// "x.f:12: 'n' is used uninitialized" of what it warns of and is seldom meant, each once. Its columns are those of the
/// end of a line, and are left out.
std::vector<std::string> warnings_in(const std::string& said);

/// A sentence on variables of the source that are integers by their first letter and take a real number, by the
/// compiler's -Wconversion; none where there are none. One that is declared takes it on purpose.
std::vector<std::string> truncations_in(const std::string& said, const FortranSource& source);

}  // namespace assay::drivers
