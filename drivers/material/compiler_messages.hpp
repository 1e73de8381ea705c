// SPDX-License-Identifier: BSD-3-Clause
// What gfortran says of a source, in words for its author.
#pragma once

#include <string>
#include <vector>

#include "drivers/material/fortran_source.hpp"
#include "drivers/system/input_error.hpp"

namespace assay::drivers {

/// Whether the compiler has something to say of a line of the source; else it failed by itself.
bool names_a_line(const std::string& said);

/// "x.f:12: 'n' is used uninitialized" of what it warns of and is seldom meant, each once. Its columns are those of the
/// end of a line, and are left out.
std::vector<std::string> warnings_in(const std::string& said);

/// The first error that it names, at its place in the source or in what that includes; version: the compiler's.
InputError refusal_of_compiler(const FortranSource& source, const std::string& version, const std::string& said);

}  // namespace assay::drivers
